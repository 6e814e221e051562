// SPDX-License-Identifier: MIT
// A depth image in colours: near is dark, far is light, no reading is the page.
import type { KeptFrame } from "./data";
import { element } from "./dom";

// From dark blue over grey to yellow, told apart by lightness alone (after Nuñez, Anderton and Renslow's cividis, 2018).
const kStops = [[0, 32, 77], [65, 77, 107], [124, 123, 120], [188, 175, 111], [255, 234, 70]] as const;

function colourOf(share: number): [number, number, number] {
  const place = share * (kStops.length - 1);
  const low = kStops[Math.floor(place)] ?? kStops[0];
  const high = kStops[Math.min(kStops.length - 1, Math.floor(place) + 1)] ?? low;
  const part = place - Math.floor(place);
  return [0, 1, 2].map((k) => Math.round((low[k] ?? 0) * (1 - part) + (high[k] ?? 0) * part)) as [number, number, number];
}

export class DepthView {
  readonly element = element("figure", "depth");
  private readonly canvas = element("canvas");
  private readonly caption = element("figcaption");

  constructor() {
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "Depth image");
    this.element.append(this.canvas, this.caption);
  }

  show(frame: KeptFrame, depth: Uint8Array): void {
    this.caption.textContent = frame.text;
    this.element.hidden = depth.length === 0;
    const context = this.canvas.getContext("2d");
    if (!context || frame.width * frame.height === 0) return;
    this.canvas.width = frame.width;
    this.canvas.height = frame.height;
    const image = context.createImageData(frame.width, frame.height);
    depth.forEach((value, i) => {
      if (value > 0) image.data.set([...colourOf((value - 1) / 254), 255], 4 * i);
    });
    context.putImageData(image, 0, 0);
  }
}
