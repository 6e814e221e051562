// SPDX-License-Identifier: MIT
// Two clouds, before, between and after.
import { Colours } from "./align/colours";
import { AlignScene } from "./align/scene";
import { AlignTools } from "./align/tools";
import { makeCharts } from "./chart";
import type { AlignData, ChartData } from "./data";
import { noView } from "./missing";
import { makeSteps } from "./steps";
import { showTransforms } from "./tools/transform_panel";

export async function showAlign(align: AlignData, charts: ChartData[], stage: HTMLElement): Promise<void> {
  const matrix = document.getElementById("matrix");
  if (matrix) showTransforms(align.transform, matrix);
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
    const tools = new AlignTools(scene, colours, stage);
    stage.append(scene.viewer.element, colours.legend, colours.range.element, steps.element, tools.element);
    steps.show(align.poses.length - 1);
    tools.follow(steps);
  } else {
    stage.append(steps.element);
    steps.show(align.poses.length - 1);
  }
}
