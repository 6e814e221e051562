// SPDX-License-Identifier: MIT
// A few thousand points in place of millions, for what need not know all.
import { Box3, Vector3 } from "three";

const kMaxSamples = 8000;
const kStrays = 0.01; // part of the points that may be far outside, on each side
const kMargin = 0.25; // of the others' diagonal, within which strays belong to them
const kLargest = 1e12; // farther away, float cannot tell points apart

// Every n-th point, n so that about kMaxSamples are taken.
export function sampled(points: Float32Array): Vector3[] {
  const count = Math.floor(points.length / 3);
  const stride = Math.max(1, Math.ceil(count / kMaxSamples));
  const chosen: Vector3[] = [];
  for (let i = 0; i < count; i += stride) {
    const point = new Vector3().fromArray(points, 3 * i);
    if (point.toArray().every((value) => Math.abs(value) < kLargest)) chosen.push(point);
  }
  return chosen;
}

export function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((one, other) => one - other);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0;
}

// The box of all points that are not far outside the box of nearly all.
export function robustBounds(points: readonly Vector3[]): Box3 {
  const low = new Vector3();
  const high = new Vector3();
  for (const axis of [0, 1, 2] as const) {
    const values = points.map((point) => point.getComponent(axis));
    const [least, most] = [quantile(values, kStrays), quantile(values, 1 - kStrays)];
    low.setComponent(axis, least);
    high.setComponent(axis, most);
  }
  return new Box3(low, high).expandByScalar(kMargin * low.distanceTo(high));
}
