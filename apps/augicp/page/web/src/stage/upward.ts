// SPDX-License-Identifier: MIT
// Which way is up, in frames that do not say so: by the floor if there is one, else by the custom of the sensor's frame.
import { Vector3 } from "three";
import { sampled } from "./sampled";

export interface Upward {
  name: string;
  up: Vector3; // unit length, in the page
}

export interface Surveyed {
  points: Float32Array; // in the page
  directions: Int8Array; // three a point, 127 for 1
  structures: Uint8Array; // 1: planar
  zero: Vector3; // of the page, in the target's frame
}

const kPlanar = 1;
const kMaxSamples = 3000;
const kFloorTilt_deg = 50; // of a sensor that still sees a floor below it
const kBundle_deg = 8; // of normals of one plane
const kLeastShare = 0.08; // of planar points on a floor
const cosine = (angle_deg: number): number => Math.cos((angle_deg * Math.PI) / 180);

// A camera looks along z, with y down: all points are in a cone before it. The share tolerates strays.
export function isOfCamera({ points, zero }: Pick<Surveyed, "points" | "zero">): boolean {
  const all = sampled(points);
  const before = all.filter((point) => {
    const { x, y, z } = point.add(zero);
    return z > 0 && Math.abs(x) < 1.5 * z && Math.abs(y) < 1.5 * z;
  });
  return all.length > 0 && before.length > 0.98 * all.length;
}

// Normals of planar points: towards a camera, which sees no floor from below; else the half that is upwards.
function normalsOf({ points, directions, structures, zero }: Surveyed, custom: Vector3, isSeen: boolean): Vector3[] {
  const stride = Math.max(1, Math.ceil(structures.length / kMaxSamples));
  const normals: Vector3[] = [];
  for (let i = 0; i < structures.length; i += stride) {
    if (structures[i] !== kPlanar) continue;
    const normal = new Vector3().fromArray(directions, 3 * i).normalize();
    const side = isSeen ? new Vector3().fromArray(points, 3 * i).add(zero).negate() : custom;
    normals.push(normal.dot(side) < 0 ? normal.negate() : normal);
  }
  return normals;
}

// The mean of the largest bundle of normals not far from the custom; none if it is small.
function floorNormal(surveyed: Surveyed, custom: Vector3, isSeen: boolean): Vector3 | null {
  const normals = normalsOf(surveyed, custom, isSeen);
  const near = normals.filter((normal) => normal.dot(custom) > cosine(kFloorTilt_deg));
  const bundle = (centre: Vector3): Vector3[] => near.filter((normal) => normal.dot(centre) > cosine(kBundle_deg));
  const stride = Math.max(1, Math.ceil(near.length / 200));
  let best: Vector3[] = [];
  for (let i = 0; i < near.length; i += stride) {
    const found = bundle(near[i] ?? custom);
    if (found.length > best.length) best = found;
  }
  if (best.length < kLeastShare * normals.length || best.length < 20) return null;
  return best.reduce((sum, normal) => sum.add(normal), new Vector3()).normalize();
}

const kAxes: Upward[] = (["x", "y", "z"] as const).flatMap((name, axis) =>
  [1, -1].map((sign) => ({ name: sign > 0 ? name : `\u2212${name}`, up: new Vector3().setComponent(axis, sign) })),
);

// What may be up, the guess first.
export function upwards(surveyed: Surveyed): Upward[] {
  const isSeen = isOfCamera(surveyed);
  const custom = isSeen ? "\u2212y" : "z";
  const axes = [...kAxes].sort((one, other) => Number(other.name === custom) - Number(one.name === custom));
  const found = axes[0] ? floorNormal(surveyed, axes[0].up, isSeen) : null;
  return found ? [{ name: "floor", up: found }, ...axes] : axes;
}
