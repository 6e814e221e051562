// SPDX-License-Identifier: MIT
// Several trajectories over the ground truth.
import { Vector3 } from "three";
import { makeCharts } from "./chart";
import type { ChartData, TrajectoriesData } from "./data";
import { button, choice, element, toggle } from "./dom";
import { noView } from "./missing";
import { lines } from "./odometry/trajectory";
import { unpackedPoints } from "./packed";
import { samplesOf } from "./stage/framing";
import { homeDirection } from "./stage/home";
import { Viewer } from "./stage/viewer";
import { pictureTools } from "./tools/picture_tools";

const kNumColours = 6; // of the style sheet, as curves have them
const kWidth_px = 2.5;

function toggleOf(name: string, index: number, onChange: (on: boolean) => void): HTMLElement {
  const made = toggle(name, `Show or hide: ${name}`, true, onChange);
  const key = element("i", "line");
  key.style.background = `var(--s${index % kNumColours})`;
  made.prepend(key);
  return made;
}

export async function showTrajectories(data: TrajectoriesData, charts: ChartData[], stage: HTMLElement): Promise<void> {
  makeCharts(charts);
  const parts = await Promise.all(data.paths.map((path) => unpackedPoints(path.lines)));
  const up = new Vector3(...data.view.up);
  const home = { points: samplesOf(parts.map((points) => ({ points }))), toEye: homeDirection(up, new Vector3(...data.view.ahead)), up };
  let viewer: Viewer;
  try {
    viewer = new Viewer("Trajectories in 3D: arrow keys rotate, with Shift they move, + and - zoom, 0 shows all", home);
  } catch (reason) {
    stage.append(noView("The trajectories cannot be drawn in 3D", reason));
    return;
  }
  const drawn = parts.map((points, index) => lines(points, `--s${index % kNumColours}`, kWidth_px));
  viewer.scene.add(...drawn);
  const row = element("div", "toggles");
  row.append(
    choice(["3D", "Top"], "View", (index) => { if (index === 0) viewer.reset(); else viewer.lookAlong(up); }),
    button("Fit", "Show all (0, or a double click)", () => { viewer.reset(); }),
    ...data.paths.map((path, index) => toggleOf(path.name, index, (on) => {
      const line = drawn[index];
      if (line) line.visible = on;
      viewer.invalidate();
    })),
    toggle("Grid", "Lines on the ground", true, (on) => { viewer.showGround(on); }),
    ...pictureTools(viewer, stage, "trajectories.png"),
  );
  const tools = element("div", "tools");
  tools.append(row);
  stage.append(viewer.element, tools);
}
