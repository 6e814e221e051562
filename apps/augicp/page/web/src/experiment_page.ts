// SPDX-License-Identifier: MIT
// The grid of curves, one quantity at a time.
import { makeCharts } from "./chart";
import type { ChartData } from "./data";
import { choice } from "./dom";

export function showExperiment(charts: ChartData[]): void {
  const sections = [...document.querySelectorAll<HTMLElement>("section.quantity")];
  makeCharts(charts);
  if (sections.length < 2) return;
  const names = sections.map((section) => section.querySelector("h2")?.textContent ?? "");
  const chooser = choice(names, "Quantity", (chosen) => {
    sections.forEach((section, index) => { section.hidden = index !== chosen; });
  });
  sections[0]?.before(chooser);
}
