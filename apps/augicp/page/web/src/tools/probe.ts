// SPDX-License-Identifier: MIT
// A click shows a point's coordinates and attributes; a second one the distance between the two.
import { BufferGeometry, Color, Line, LineBasicMaterial, Points, PointsMaterial, Vector3 } from "three";
import type { AlignScene } from "../align/scene";
import { button, cssColour, element } from "../dom";
import { lengthText } from "../stage/lengths";
import { picked, type Picked } from "./pick";
import type { Section } from "./section";

const kClick_px = 4; // a longer way is a rotation
const kStructures = ["no structure", "planar", "edge"];

const coordinates = (place: Vector3): string => `(${place.toArray().map((value) => value.toFixed(4)).join(", ")}) m`;

export class Probe {
  readonly element = element("div", "readout");
  private readonly text = element("div");
  private readonly marks = new Points(new BufferGeometry(), new PointsMaterial({ size: 11, sizeAttenuation: false, depthTest: false }));
  private readonly line = new Line(new BufferGeometry(), new LineBasicMaterial({ depthTest: false }));
  private chosen: Picked[] = [];

  constructor(private readonly scene: AlignScene, private readonly section: Section) {
    const { canvas } = scene.viewer;
    this.element.setAttribute("role", "status");
    this.element.append(this.text, button("\u00d7", "Forget the points", () => { this.choose([]); }));
    for (const part of [this.marks, this.line]) {
      part.frustumCulled = false;
      part.renderOrder = 20;
      part.material.color = new Color(cssColour("--free"));
      scene.viewer.scene.add(part);
    }
    this.choose([]);
    let from: [number, number] = [0, 0];
    canvas.addEventListener("pointerdown", (event) => { from = [event.clientX, event.clientY]; });
    canvas.addEventListener("pointerup", (event) => {
      if (event.button === 0 && Math.hypot(event.clientX - from[0], event.clientY - from[1]) < kClick_px) this.pickAt(event.offsetX, event.offsetY);
    });
  }

  private pickAt(x_px: number, y_px: number): void {
    const { viewer, source, target } = this.scene;
    if (viewer.isSplit) return;
    const at = { x_px, y_px, width_px: viewer.canvas.clientWidth, height_px: viewer.canvas.clientHeight };
    const found = picked([target, source], viewer.camera, at, (place) => this.section.cuts(place));
    if (found) this.choose([...this.chosen.slice(-1), found]);
  }

  private choose(chosen: Picked[]): void {
    this.chosen = chosen;
    this.element.hidden = chosen.length === 0;
    const places = chosen.map(({ place }) => place);
    this.marks.visible = places.length > 0;
    this.line.visible = places.length > 1;
    for (const part of [this.marks, this.line]) {
      part.geometry.dispose();
      part.geometry = new BufferGeometry().setFromPoints(places);
    }
    this.text.replaceChildren(...this.describe());
    this.scene.viewer.invalidate();
  }

  private describe(): HTMLElement[] {
    const last = this.chosen.at(-1);
    if (!last) return [];
    const { points, index, place } = last;
    const { data } = this.scene;
    const isSource = points === this.scene.source;
    const own = isSource ? this.inSource(place) : null;
    const lines = [
      `${isSource ? "Source" : "Target"} point, ${kStructures[points.cloud.structures[index] ?? 0] ?? ""}`,
      `target frame ${coordinates(place.clone().add(new Vector3(...data.zero)))}`,
    ];
    if (own) lines.push(`source frame ${coordinates(own)}`);
    const distance = points.cloud.distances?.[index] ?? NaN;
    if (!Number.isNaN(distance)) lines.push(`${lengthText(distance)} from the target's surface, at the end`);
    const intensity = points.cloud.intensities?.[index] ?? NaN;
    if (!Number.isNaN(intensity)) lines.push(`intensity ${Number(intensity.toPrecision(4))}`);
    const before = this.chosen.length > 1 ? this.chosen[0] : null;
    if (before) lines.push(`${lengthText(before.place.distanceTo(place), 4)} from the point before`);
    return lines.map((line, i) => element(i === 0 ? "b" : "div", "", line));
  }

  // By the pose that is shown.
  private inSource(place: Vector3): Vector3 {
    return place.clone().applyMatrix4(this.scene.source.matrix.clone().invert()).add(new Vector3(...this.scene.data.source_zero));
  }
}
