// SPDX-License-Identifier: MIT
// Where a camera was, and what it saw there.
import { Color, Vector3 } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { makeCharts } from "./chart";
import { CloudPoints } from "./cloud_points";
import { type ChartData, type KeptFrame, type OdometryData, floats, isFinitePose } from "./data";
import { DepthView } from "./depth_view";
import { choice, cssColour, element, onColourScheme, toggle } from "./dom";
import { makeSteps } from "./steps";
import { markStrip, markTopView } from "./svg_marks";
import { type Fitted, samplesOf } from "./stage/framing";
import { homeDirection } from "./stage/home";
import { type Home, Viewer } from "./stage/viewer";

const kFittedModels = 20;

// Two points a line; wide lines, for a trajectory must be seen before its surroundings.
function lines(points: Float32Array, colour: string, width_px: number): LineSegments2 {
  const material = new LineMaterial({ linewidth: width_px });
  const recolour = (): void => { material.color = new Color(cssColour(colour)); };
  recolour();
  onColourScheme(recolour);
  const made = new LineSegments2(new LineSegmentsGeometry().setPositions(points), material);
  made.frustumCulled = false;
  return made;
}

// A camera's pyramid: its eye and the corners of what it sees, depth metres ahead.
function pyramid(depth: number): LineSegments2 {
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x = 0, y = 0]) => [0.55 * x * depth, 0.42 * y * depth, depth]);
  const edges = corners.flatMap((corner, i) => [[0, 0, 0], corner, corner, corners[(i + 1) % 4] ?? corner]).flat();
  const made = lines(new Float32Array(edges), "--marker", 1.5);
  made.matrixAutoUpdate = false;
  return made;
}

// The trajectories, and the local models of some frames.
function homeOf(odometry: OdometryData): Home {
  const parts: Fitted[] = [odometry.estimate, odometry.truth].map((points) => ({ points: floats(points) }));
  const stride = Math.ceil(odometry.kept.length / kFittedModels);
  odometry.kept.forEach(({ model, model_pose: pose }, i) => {
    if (model && isFinitePose(pose) && i % stride === 0) parts.push({ points: floats(model.points), pose });
  });
  const up = new Vector3(...odometry.view.up);
  return { points: samplesOf(parts), toEye: homeDirection(up, new Vector3(...odometry.view.ahead)), up };
}

class OdometryScene {
  readonly viewer: Viewer;
  private readonly camera: LineSegments2;
  private model: CloudPoints | null = null;
  private isModelShown = true;
  private kept: KeptFrame | null = null;

  constructor(private readonly odometry: OdometryData) {
    this.viewer = new Viewer("Trajectory in 3D: arrow keys rotate, with Shift they move, + and - zoom, 0 shows all", homeOf(odometry));
    this.camera = pyramid(0.08 * odometry.extent);
    const truth = lines(floats(odometry.truth), "--target", 2.5);
    const estimate = lines(floats(odometry.estimate), "--source", 2.5);
    this.viewer.scene.add(truth, estimate, this.camera);
  }

  show(frame: number, kept: KeptFrame | null): void {
    const pose = this.odometry.frames[frame]?.pose;
    this.camera.visible = isFinitePose(pose);
    if (isFinitePose(pose)) this.camera.matrix.fromArray(pose);
    this.camera.matrixWorldNeedsUpdate = true;
    if (kept !== this.kept) this.showModel(kept);
    this.viewer.invalidate();
  }

  controls(): HTMLElement {
    const row = element("div", "toggles");
    const up = new Vector3(...this.odometry.view.up);
    row.append(
      choice(["3D", "Top"], "View", (index) => { if (index === 0) this.viewer.reset(); else this.viewer.lookAlong(up); }),
      toggle("Local model", "What frames are registered to", true, (on) => {
        this.isModelShown = on;
        if (this.model) this.model.visible = on;
        this.viewer.invalidate();
      }),
    );
    return row;
  }

  private showModel(kept: KeptFrame | null): void {
    this.kept = kept;
    if (this.model) {
      this.viewer.scene.remove(this.model);
      this.model.geometry.dispose();
      this.model.material.dispose();
      this.model = null;
    }
    if (kept?.model === undefined || !isFinitePose(kept.model_pose)) return;
    this.model = new CloudPoints(kept.model, "--none", 0.6 * (kept.model_extent ?? 1), 1);
    this.model.pose = kept.model_pose;
    this.model.visible = this.isModelShown;
    this.viewer.scene.add(this.model);
  }
}

// The last one kept up to a frame.
function keptAt(odometry: OdometryData, frame: number): KeptFrame | null {
  return odometry.kept.filter((kept) => kept.frame <= frame).at(-1) ?? odometry.kept[0] ?? null;
}

function legend(odometry: OdometryData): HTMLElement {
  const row = element("div", "view-legend");
  for (const [name, text] of [["target", "ground truth"], ["source", "estimate"], ["none", "local model"]] as const) {
    if (name === "target" && odometry.truth === "") continue;
    const item = element("span", "", text);
    item.prepend(element("i", name));
    row.append(item);
  }
  return row;
}

function frameAt(odometry: OdometryData, time: number): number {
  const distances = odometry.frames.map((frame) => Math.abs((frame.time ?? Infinity) - time));
  return distances.indexOf(Math.min(...distances));
}

export function showOdometry(odometry: OdometryData, charts: ChartData[], stage: HTMLElement): void {
  const live = makeCharts(charts, (time) => { steps.show(frameAt(odometry, time)); });
  const depth = new DepthView();
  let scene: OdometryScene | null = null;
  try {
    scene = new OdometryScene(odometry);
    stage.prepend(scene.viewer.element);
    scene.viewer.element.append(depth.element);
  } catch {
    stage.prepend(element("p", "notice", "This browser has no WebGL: the trajectory cannot be drawn in 3D."), depth.element);
  }
  const texts = odometry.frames.map((frame) => frame.text);
  const steps = makeSteps(odometry.frames.length, "Frame", texts, (frame) => {
    const kept = keptAt(odometry, frame);
    scene?.show(frame, kept);
    if (kept) depth.show(kept);
    for (const chart of live) chart.mark(odometry.frames[frame]?.time ?? 0);
    strip(frame);
    markTopView(odometry.frames[frame]?.top ?? null);
  });
  const strip = markStrip(odometry.frames.length, (frame) => { steps.show(frame); });
  stage.append(legend(odometry), steps.element);
  if (scene) stage.append(scene.controls());
  steps.show(odometry.frames.length - 1);
}
