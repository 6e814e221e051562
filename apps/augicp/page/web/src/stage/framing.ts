// SPDX-License-Identifier: MIT
// From where a camera sees a set of points whole: no point is cut, and no smaller picture would do.
import { Matrix4, Vector3 } from "three";
import { robustBounds, sampled } from "./sampled";

// What one camera sees: tangents of half its opening, across and upwards.
export interface Opening {
  across: number;
  upwards: number;
}

export interface Look {
  eye: Vector3;
  target: Vector3; // about which the view rotates
  up: Vector3;
}

// Part of the picture that stays free at its rim, for legends.
const kRim = 0.06;

// Points that are fitted, with their pose in the page.
export interface Fitted {
  points: Float32Array;
  pose?: readonly number[]; // 4x4, columns first; none: the identity
}

// A few thousand of all points in the page, without strays far outside.
export function samplesOf(parts: readonly Fitted[]): Vector3[] {
  const all = parts.flatMap(({ points, pose }) => {
    const matrix = new Matrix4();
    if (pose) matrix.fromArray(pose);
    return sampled(points).map((point) => point.applyMatrix4(matrix));
  });
  const bounds = robustBounds(all);
  const inside = all.filter((point) => bounds.containsPoint(point));
  return inside.length > 0 ? inside : [new Vector3(-1, -1, -1), new Vector3(1, 1, 1)];
}

// The diagonal of the box of all of them, above 0.
export function robustExtent(points: readonly Vector3[]): number {
  return Math.max(robustBounds(points).getSize(new Vector3()).length() / 1.5, 1e-6);
}

// How far a frustum's two opposite planes must reach, along the side axis and backwards.
function slab(points: readonly Vector3[], side: Vector3, back: Vector3, tangent: number): { middle: number; distance: number } {
  let positive = -Infinity;
  let negative = -Infinity;
  for (const point of points) {
    const along = point.dot(side);
    const behind = tangent * point.dot(back);
    positive = Math.max(positive, along + behind);
    negative = Math.max(negative, behind - along);
  }
  return { middle: (positive - negative) / 2, distance: (positive + negative) / (2 * tangent) };
}

// The look along a direction, which points from what is seen to the eye.
export function fitted(points: readonly Vector3[], toEye: Vector3, up: Vector3, opening: Opening): Look {
  const back = toEye.clone().normalize();
  const right = new Vector3().crossVectors(up, back).normalize();
  const above = new Vector3().crossVectors(back, right);
  const across = slab(points, right, back, opening.across * (1 - kRim));
  const upwards = slab(points, above, back, opening.upwards * (1 - kRim));
  const depths = points.map((point) => point.dot(back)).sort((one, other) => one - other);
  const middle = depths[Math.floor(depths.length / 2)] ?? 0;
  const range = (depths.at(-1) ?? 0) - (depths[0] ?? 0);
  const least = range > 1e-9 ? 0.1 * range : 1;
  const place = (depth: number): Vector3 =>
    new Vector3().addScaledVector(right, across.middle).addScaledVector(above, upwards.middle).addScaledVector(back, depth);
  const distance = Math.max(across.distance, upwards.distance, middle + least);
  return { eye: place(distance), target: place(middle), up };
}
