// SPDX-License-Identifier: MIT
// Where the sensor was, as wide lines: a trajectory must be seen before its surroundings.
import { Color } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { colourAt, kSequential } from "../colour/palette";
import { type FrameData, isFinitePose } from "../data";
import { cssColour, onColourScheme } from "../dom";

// Two points a line.
export function lines(points: Float32Array, colour: string, width_px: number): LineSegments2 {
  const material = new LineMaterial({ linewidth: width_px });
  const recolour = (): void => { material.color = new Color(cssColour(colour)); };
  recolour();
  onColourScheme(recolour);
  const made = new LineSegments2(new LineSegmentsGeometry().setPositions(points), material);
  made.frustumCulled = false;
  return made;
}

// A camera's pyramid: its eye and the corners of what it sees, depth metres ahead.
export function pyramid(depth: number): LineSegments2 {
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x = 0, y = 0]) => [0.55 * x * depth, 0.42 * y * depth, depth]);
  const edges = corners.flatMap((corner, i) => [[0, 0, 0], corner, corner, corners[(i + 1) % 4] ?? corner]).flat();
  const made = lines(new Float32Array(edges), "--marker", 1.5);
  made.matrixAutoUpdate = false;
  return made;
}

// A LiDAR's axes: x long, y and z short.
export function sensorAxes(length: number): LineSegments2 {
  const made = lines(new Float32Array([0, 0, 0, length, 0, 0, 0, 0, 0, 0, 0.5 * length, 0, 0, 0, 0, 0, 0, 0.5 * length]), "--marker", 2.5);
  made.matrixAutoUpdate = false;
  return made;
}

export type PathColour = "one colour" | "status" | "time";
export const kPathColours: readonly PathColour[] = ["one colour", "status", "time"];

// A colour of the style sheet, as lines need it.
const named = (name: string): number[] => new Color(cssColour(name)).toArray();
const kStatusColours: Record<string, string> = {
  started: "--good", tracked: "--planar", degenerate: "--edge", doubtful: "--s3", lost: "--high",
};

// From each frame with a pose to the next one of its segment.
export class EstimatedPath extends LineSegments2 {
  private readonly ends: readonly FrameData[]; // the later frame of each line

  constructor(private readonly frames: readonly FrameData[], private colour: PathColour = "one colour") {
    const ends: FrameData[] = [];
    const positions: number[] = [];
    let last: FrameData | null = null;
    for (const frame of frames) {
      if (!isFinitePose(frame.pose)) continue;
      if (last && isFinitePose(last.pose) && last.segment === frame.segment) {
        positions.push(...last.pose.slice(12, 15), ...frame.pose.slice(12, 15));
        ends.push(frame);
      }
      last = frame;
    }
    super(new LineSegmentsGeometry().setPositions(positions), new LineMaterial({ linewidth: 3, vertexColors: true }));
    this.ends = ends;
    this.frustumCulled = false;
    this.recolour(colour);
    onColourScheme(() => { this.recolour(this.colour); });
  }

  recolour(colour: PathColour): void {
    this.colour = colour;
    const plain = named("--source");
    const longest = this.frames.at(-1)?.time ?? 1;
    const colourOf: Record<PathColour, (frame: FrameData) => number[]> = {
      "one colour": () => plain,
      status: (frame) => named(kStatusColours[frame.status] ?? "--none"),
      time: (frame) => new Color().setRGB(...colourAt(kSequential, (frame.time ?? 0) / (longest || 1)), "srgb").toArray(),
    };
    const colours = this.ends.flatMap((frame) => { const made = colourOf[colour](frame); return [...made, ...made]; });
    if (colours.length > 0) this.geometry.setColors(colours);
  }
}
