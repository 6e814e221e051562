// SPDX-License-Identifier: MIT
// Where a sensor was, and what it saw there.
import { makeCharts } from "./chart";
import { gradient, kSequential } from "./colour/palette";
import type { ChartData, OdometryData } from "./data";
import { DepthView } from "./depth_view";
import { button, choice, element, select, toggle } from "./dom";
import { noView } from "./missing";
import type { Kept } from "./odometry/map";
import { keptClouds, OdometryScene } from "./odometry/scene";
import { kPathColours, type PathColour } from "./odometry/trajectory";
import { unpackedBytes } from "./packed";
import { Vector3 } from "three";
import { makeSteps } from "./steps";
import { markStrip, markTopView } from "./svg_marks";
import { pictureTools } from "./tools/picture_tools";
import { pointSize } from "./tools/point_size";
import { Probe } from "./tools/probe";
import { Section } from "./tools/section";

// The last one kept up to a frame.
function keptAt(kept: readonly Kept[], frame: number): Kept | null {
  return kept.filter(({ frame: { frame: number } }) => number <= frame).at(-1) ?? kept[0] ?? null;
}

function legend(odometry: OdometryData, colour: PathColour): HTMLElement[] {
  const seen = odometry.lidar ? "scan at the frame" : "local model at the frame";
  const items = [["target", "ground truth"], ["source", "estimate"], ["seen", seen], ["none", "map"]] as const;
  const texts = items.filter(([name]) => (name !== "target" || odometry.has_truth) && (name !== "source" || colour === "one colour"));
  const spans = texts.map(([name, text]) => {
    const item = element("span", "", text);
    item.prepend(element("i", name));
    return item;
  });
  if (colour === "status") spans.push(element("span", "", "estimate: colours of the status strip"));
  if (colour === "time") {
    const ramp = element("i", "ramp");
    ramp.style.background = gradient(kSequential);
    const item = element("span", "", `0 to ${Number((odometry.frames.at(-1)?.time ?? 0).toPrecision(3))} s`);
    item.prepend(ramp);
    spans.push(item);
  }
  return spans;
}

function frameAt(odometry: OdometryData, time: number): number {
  const distances = odometry.frames.map((frame) => Math.abs((frame.time ?? Infinity) - time));
  return distances.indexOf(Math.min(...distances));
}

function controls(odometry: OdometryData, scene: OdometryScene, key: HTMLElement, stage: HTMLElement): HTMLElement {
  const row = element("div", "toggles");
  const section = new Section(scene, scene.points);
  scene.viewer.element.append(new Probe(scene, section).element);
  const up = new Vector3(...odometry.view.up);
  const seen = odometry.lidar ? "Scan" : "Local model";
  row.append(
    choice(["3D", "Top"], "View", (index) => { if (index === 0) scene.viewer.reset(); else scene.viewer.lookAlong(up); }),
    button("Fit", "Show all (0, or a double click)", () => { scene.viewer.reset(); }),
    toggle("Map", "What was seen along the trajectory", true, (on) => { scene.map.visible = on; scene.viewer.invalidate(); }),
    toggle(seen, "What the sensor saw, or was registered to, at the frame", true, (on) => { scene.isSeenVisible = on; }),
    toggle("Grid", "Lines on the ground", true, (on) => { scene.viewer.showGround(on); }),
    select("Colour", "What the colour of the trajectory shows; with time, the map's too", kPathColours, (index) => {
      const colour = kPathColours[index] ?? "one colour";
      scene.colour(colour);
      key.replaceChildren(...legend(odometry, colour));
    }),
  );
  row.append(pointSize((factor) => { scene.sizeFactor = factor; }), ...pictureTools(scene.viewer, stage, "odometry.png"));
  key.replaceChildren(...legend(odometry, "one colour"));
  const tools = element("div", "tools");
  tools.append(row, section.element);
  return tools;
}

export async function showOdometry(odometry: OdometryData, charts: ChartData[], stage: HTMLElement): Promise<void> {
  const live = makeCharts(charts, (time) => { steps.show(frameAt(odometry, time)); });
  const kept = await keptClouds(odometry);
  const images = await Promise.all(odometry.kept.map(({ depth }) => unpackedBytes(depth ?? "")));
  const depth = new DepthView();
  let scene: OdometryScene | null = null;
  try {
    scene = await OdometryScene.of(odometry, kept);
    stage.append(scene.viewer.element);
    scene.viewer.element.append(depth.element);
  } catch (reason) {
    stage.append(noView("The trajectory cannot be drawn in 3D", reason), depth.element);
  }
  const texts = odometry.frames.map((frame) => frame.text);
  const steps = makeSteps(odometry.frames.length, "Frame", texts, (frame) => {
    const at = keptAt(kept, frame);
    scene?.show(frame, at);
    if (at) depth.show(at.frame, images[kept.indexOf(at)] ?? new Uint8Array(0));
    for (const chart of live) chart.mark(odometry.frames[frame]?.time ?? 0);
    strip(frame);
    markTopView(odometry.frames[frame]?.top ?? null);
  });
  const strip = markStrip(odometry.frames.length, (frame) => { steps.show(frame); });
  const key = element("div", "view-legend");
  stage.append(key, steps.element);
  if (scene) stage.append(controls(odometry, scene, key, stage));
  steps.show(odometry.frames.length - 1);
}
