// SPDX-License-Identifier: MIT
// A click shows a point's coordinates and attributes; a second one the distance between the two.
import { BufferGeometry, Color, Line, LineBasicMaterial, Points, PointsMaterial } from "three";
import { button, cssColour, element } from "../dom";
import { lengthText } from "../stage/lengths";
import { picked, type Picked } from "./pick";
import type { Probed } from "./probed";
import type { Section } from "./section";

const kClick_px = 4; // a longer way is a rotation

export class Probe {
  readonly element = element("div", "readout");
  private readonly text = element("div");
  private readonly marks = new Points(new BufferGeometry(), new PointsMaterial({ size: 11, sizeAttenuation: false, depthTest: false }));
  private readonly line = new Line(new BufferGeometry(), new LineBasicMaterial({ depthTest: false }));
  private chosen: Picked[] = [];

  constructor(private readonly scene: Probed, private readonly section: Section) {
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
    const { viewer, clouds } = this.scene;
    if (viewer.isSplit) return;
    const at = { x_px, y_px, width_px: viewer.canvas.clientWidth, height_px: viewer.canvas.clientHeight };
    const found = picked(clouds, viewer.camera, at, (place) => this.section.cuts(place));
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
    const lines = this.scene.describe(last);
    const before = this.chosen.length > 1 ? this.chosen[0] : null;
    if (before) lines.push(`${lengthText(before.place.distanceTo(last.place), 4)} from the point before`);
    return lines.map((line, i) => element(i === 0 ? "b" : "div", "", line));
  }
}
