// SPDX-License-Identifier: MIT
// What the colour of a point may show.
import { lengthText, roundBelow } from "../stage/lengths";
import { quantile } from "../stage/sampled";
import { kSequential, kSigned, type Palette } from "./palette";

export type ModeName = "cloud" | "distance" | "height" | "intensity" | "rgb" | "structure";

export interface Mode {
  name: ModeName;
  label: string;
  code: number; // in the shader
  palette: Palette | null; // null: no numbers
  text: (value: number) => string;
  grey: string; // what grey points are
}

const plain = (value: number): string => String(Number(value.toPrecision(3)));

export const kModes: readonly Mode[] = [
  { name: "cloud", label: "source and target", code: 0, palette: null, text: plain, grey: "" },
  { name: "distance", label: "distance from the target's surface", code: 2, palette: kSigned, text: (value) => lengthText(value), grey: "no overlap, and the target" },
  { name: "height", label: "height", code: 3, palette: kSequential, text: (value) => lengthText(value), grey: "" },
  { name: "intensity", label: "intensity", code: 4, palette: kSequential, text: plain, grey: "unknown" },
  { name: "rgb", label: "colour of the file", code: 5, palette: null, text: plain, grey: "no colour" },
  { name: "structure", label: "structure", code: 1, palette: null, text: plain, grey: "" },
];

export type Range = [number, number];

const kNoiseWidths = 3; // standard deviations of the noise that span half of the palette
const kSigmaPerMedian = 1.4826; // of a normal distribution's absolute values

// The smallest of 1, 2 and 5 times powers of ten that is not below.
function roundAbove(value: number): number {
  const below = roundBelow(value);
  if (below >= value * (1 - 1e-9)) return below;
  return [2, 2.5, 5, 10].map((factor) => roundBelow(factor * below * 1.0001)).find((candidate) => candidate >= value) ?? 10 * below;
}

// Signed distances at the scale of their noise, so that a misfit of few standard deviations spans the palette; others between
// their lowest and highest values, without strays.
export function rangeFor(mode: Mode, values: readonly number[]): Range {
  if (values.length === 0) return [0, 1];
  if (mode.name === "distance") {
    const noise = kSigmaPerMedian * quantile(values.map(Math.abs), 0.5);
    const half = roundAbove(Math.max(kNoiseWidths * noise, 1e-6));
    return [-half, half];
  }
  const [low, high] = [quantile(values, 0.01), quantile(values, 0.99)];
  return high > low ? [low, high] : [low - 0.5, low + 0.5];
}
