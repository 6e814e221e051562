// SPDX-License-Identifier: MIT
// A bar of a round length, as it is seen at the distance of the view's centre.
import type { PerspectiveCamera, Vector3 } from "three";
import { element } from "../dom";
import { lengthText, roundBelow } from "./lengths";

const kLongest_px = 130;

export class ScaleBar {
  readonly element = element("div", "scale-bar");
  private readonly bar = element("i");
  private readonly text = element("span");

  constructor() {
    this.element.title = "A length at the distance of the view's centre; nearer things look larger";
    this.element.append(this.bar, this.text);
  }

  update(camera: PerspectiveCamera, centre: Vector3, height_px: number): void {
    const across = 2 * camera.position.distanceTo(centre) * Math.tan((camera.fov * Math.PI) / 360);
    const perPixel = across / Math.max(1, height_px);
    if (!Number.isFinite(perPixel) || perPixel <= 0) return;
    const length = roundBelow(perPixel * kLongest_px);
    this.bar.style.width = `${length / perPixel}px`;
    this.text.textContent = lengthText(length);
  }
}
