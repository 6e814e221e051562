// SPDX-License-Identifier: MIT
// Two clouds, before, between and after.
import { Colours } from "./align/colours";
import { AlignScene } from "./align/scene";
import { layerToggles } from "./align/layers";
import { makeCharts } from "./chart";
import { copyButton } from "./copy";
import type { AlignData, ChartData } from "./data";
import { button, element, select } from "./dom";
import { noView } from "./missing";
import { makeSteps } from "./steps";

function viewControls(scene: AlignScene, colours: Colours): HTMLElement {
  const { survey, viewer } = scene;
  const setUp = (index: number): void => {
    const home = survey.home(index);
    viewer.setHome(home);
    colours.setUp(home.up);
  };
  setUp(0);
  const row = element("div", "toggles");
  const up = select("Up", "Which way is up", survey.upwards.map(({ name }) => name), setUp);
  row.append(colours.chooser, up, button("Fit", "Show all (0, or a double click)", () => { viewer.reset(); }));
  return row;
}

export async function showAlign(align: AlignData, charts: ChartData[], stage: HTMLElement): Promise<void> {
  const matrix = document.getElementById("matrix");
  if (matrix) matrix.before(copyButton(() => matrix));
  const live = makeCharts(charts, (x) => { steps.show(x); });
  let scene: AlignScene | null = null;
  try {
    scene = await AlignScene.of(align);
  } catch (reason) {
    stage.append(noView("The clouds cannot be drawn", reason));
  }
  const steps = makeSteps(align.poses.length, "Iteration", align.step_texts, (step) => {
    scene?.showStep(step);
    for (const chart of live) chart.mark(step);
  });
  if (scene) {
    const colours = new Colours(scene);
    stage.append(scene.viewer.element, colours.legend, colours.range.element, steps.element, layerToggles(scene), viewControls(scene, colours));
  } else stage.append(steps.element);
  steps.show(align.poses.length - 1);
}
