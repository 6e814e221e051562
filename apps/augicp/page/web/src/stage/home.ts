// SPDX-License-Identifier: MIT
// The direction of the first look: from above and a little beside, and from behind a sensor that looks one way.
import { Vector3 } from "three";

const kLeastRise_deg = 28;
const kMostRise_deg = 45;
const kBeside_deg = 22;

// Across up, the direction nearest to the wanted one.
function level(wanted: Vector3, up: Vector3): Vector3 {
  const flat = wanted.clone().addScaledVector(up, -wanted.dot(up));
  if (flat.length() > 0.1) return flat.normalize();
  const other = Math.abs(up.z) < 0.7 ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0);
  return level(other, up);
}

// How far above the horizon the eye is: no flatter than the sensor looks down itself, within bounds.
function rise(up: Vector3, ahead: Vector3): number {
  const down_deg = (Math.asin(Math.max(-1, Math.min(1, -ahead.dot(up)))) * 180) / Math.PI;
  return (Math.max(kLeastRise_deg, Math.min(kMostRise_deg, down_deg)) * Math.PI) / 180;
}

// From what is seen to the eye, unit length. ahead: where the sensor looks, unit length.
export function homeDirection(up: Vector3, ahead: Vector3): Vector3 {
  const angle = rise(up, ahead);
  const back = level(ahead, up).negate().applyAxisAngle(up, (kBeside_deg * Math.PI) / 180);
  return back.multiplyScalar(Math.cos(angle)).addScaledVector(up, Math.sin(angle));
}
