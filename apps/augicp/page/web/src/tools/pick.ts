// SPDX-License-Identifier: MIT
// The point that is drawn nearest to a place in the picture.
import { Matrix4, type PerspectiveCamera, Vector3 } from "three";
import type { CloudPoints } from "../cloud_points";

const kReach_px = 10;

export interface Picked {
  points: CloudPoints;
  index: number;
  place: Vector3; // in the page
}

export interface Place {
  x_px: number;
  y_px: number;
  width_px: number;
  height_px: number;
}

// Within reach, the one nearest to the eye: what lies behind it is hidden. isCut: whether a place in the page is not drawn.
export function picked(clouds: readonly CloudPoints[], camera: PerspectiveCamera, at: Place, isCut: (place: Vector3) => boolean): Picked | null {
  const project = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  let best: Picked | null = null;
  let nearest = Infinity;
  const place = new Vector3();
  const seen = new Vector3();
  for (const points of clouds.filter(({ visible }) => visible))
    for (let index = 0; index < points.cloud.count; ++index) {
      place.fromArray(points.cloud.points, 3 * index).applyMatrix4(points.matrix);
      seen.copy(place).applyMatrix4(project);
      if (Math.abs(seen.z) > 1) continue;
      const across = (0.5 + 0.5 * seen.x) * at.width_px - at.x_px;
      const down = (0.5 - 0.5 * seen.y) * at.height_px - at.y_px;
      const score = camera.position.distanceTo(place) * (1 + Math.hypot(across, down) / kReach_px / 10);
      if (Math.hypot(across, down) > kReach_px || score >= nearest || isCut(place)) continue;
      nearest = score;
      best = { points, index, place: place.clone() };
    }
  return best;
}
