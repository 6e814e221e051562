// SPDX-License-Identifier: MIT
// A box along the axes of the frame: what lies outside is not drawn. Thin in one axis, it is a section.
import { Box3, Vector3 } from "three";
import { Span } from "../colour/span";
import { button, element } from "../dom";
import { lengthText } from "../stage/lengths";
import type { Probed } from "./probed";

const kNames = ["x", "y", "z"] as const;

export class Section {
  readonly element = element("details", "section");
  private readonly whole: Box3;
  private readonly box: Box3;
  private readonly spans: Span[];

  constructor(private readonly scene: Probed, points: readonly Vector3[]) {
    this.whole = new Box3().setFromPoints([...points]).expandByScalar(1e-6);
    this.box = this.whole.clone();
    this.spans = kNames.map((name, axis) => new Span(`Section ${name}`, (low, high) => { this.cut(axis, low, high); }));
    const grid = element("div", "spans");
    kNames.forEach((name, axis) => { grid.append(element("span", "", name), this.spans[axis]?.element ?? ""); });
    this.element.append(element("summary", "", "Section"), grid, button("Whole", "Draw everything again", () => { this.state = null; }));
    this.show();
  }

  // The six bounds; null: nothing is cut.
  get state(): number[] | null {
    return this.isWhole() ? null : [...this.box.min.toArray(), ...this.box.max.toArray()];
  }

  set state(bounds: readonly number[] | null) {
    this.box.copy(this.whole);
    if (bounds?.length === 6) this.box.set(new Vector3().fromArray(bounds), new Vector3().fromArray(bounds, 3));
    this.show();
    this.apply();
  }

  cuts(place: Vector3): boolean {
    return !this.isWhole() && !this.box.containsPoint(place);
  }

  private isWhole(): boolean {
    return this.box.equals(this.whole);
  }

  private cut(axis: number, low: number, high: number): void {
    this.box.min.setComponent(axis, low);
    this.box.max.setComponent(axis, high);
    this.apply();
  }

  private show(): void {
    this.spans.forEach((span, axis) => {
      const ends = (box: Box3): [number, number] => [box.min.getComponent(axis), box.max.getComponent(axis)];
      span.show(ends(this.whole), ends(this.box), (value) => lengthText(value + (this.scene.zero[axis] ?? 0)));
    });
  }

  // Strays outside the sliders' reach are drawn as long as nothing is cut.
  private apply(): void {
    const far = new Vector3().setScalar(1e15);
    this.scene.box = this.isWhole() ? { low: far.clone().negate(), high: far } : { low: this.box.min, high: this.box.max };
  }
}
