// SPDX-License-Identifier: MIT
// Lines at round distances on the ground: the plane across up, at the height of the lowest points.
import { BufferGeometry, Color, Float32BufferAttribute, LineBasicMaterial, LineSegments, Vector3 } from "three";
import { cssColour, onColourScheme } from "../dom";
import { roundBelow } from "./lengths";
import { quantile } from "./sampled";

const kFewestCells = 8;

export interface Ground {
  lines: LineSegments;
  cell: number; // metres
}

interface Footprint {
  across: [number, number];
  along: [number, number];
  height: number;
}

function footprint(points: readonly Vector3[], across: Vector3, along: Vector3, up: Vector3): Footprint {
  const range = (axis: Vector3): [number, number] => {
    const values = points.map((point) => point.dot(axis));
    return [Math.min(...values), Math.max(...values)];
  };
  return { across: range(across), along: range(along), height: quantile(points.map((point) => point.dot(up)), 0.01) };
}

function outward([low, high]: [number, number], cell: number): [number, number] {
  return [cell * Math.floor(low / cell), cell * Math.ceil(high / cell)];
}

function stops([low, high]: [number, number], cell: number): number[] {
  return Array.from({ length: Math.round((high - low) / cell) + 1 }, (_, i) => low + i * cell);
}

export function groundGrid(points: readonly Vector3[], up: Vector3): Ground {
  const across = new Vector3(1, 0, 0).addScaledVector(up, -up.x);
  if (across.length() < 0.5) across.set(0, 1, 0).addScaledVector(up, -up.y);
  across.normalize();
  const along = new Vector3().crossVectors(up, across);
  const seen = footprint(points, across, along, up);
  const size = Math.max(seen.across[1] - seen.across[0], seen.along[1] - seen.along[0], 1e-6);
  const cell = roundBelow(size / kFewestCells);
  const [x, y] = [outward(seen.across, cell), outward(seen.along, cell)];
  const ends: number[] = [];
  const put = (u: number, v: number): void => {
    ends.push(...new Vector3().addScaledVector(across, u).addScaledVector(along, v).addScaledVector(up, seen.height).toArray());
  };
  for (const u of stops(x, cell)) { put(u, y[0]); put(u, y[1]); }
  for (const v of stops(y, cell)) { put(x[0], v); put(x[1], v); }
  return { lines: linesOf(ends), cell };
}

function linesOf(ends: readonly number[]): LineSegments {
  const material = new LineBasicMaterial();
  const recolour = (): void => { material.color = new Color(cssColour("--ground")); };
  recolour();
  onColourScheme(recolour);
  const lines = new LineSegments(new BufferGeometry().setAttribute("position", new Float32BufferAttribute(ends, 3)), material);
  lines.renderOrder = -1;
  return lines;
}
