// SPDX-License-Identifier: MIT
// A slider for the size of points, 1 at first.
import { element } from "../dom";

export function pointSize(change: (factor: number) => void): HTMLElement {
  const slider = element("input");
  slider.type = "range";
  [slider.min, slider.max, slider.step, slider.value] = ["0.3", "4", "0.1", "1"];
  slider.setAttribute("aria-label", "Point size");
  slider.addEventListener("input", () => { change(Number(slider.value)); });
  const holder = element("label", "select", "Size");
  holder.append(slider);
  return holder;
}
