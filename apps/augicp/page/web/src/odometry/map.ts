// SPDX-License-Identifier: MIT
// What was seen along the trajectory: the points of the kept frames, each at its place in the page.
import { Matrix4, Vector3 } from "three";
import { type Cloud, cloudOf, spreadOrder } from "../cloud";
import { isFinitePose, type KeptFrame, type OdometryData } from "../data";

export interface Kept {
  frame: KeptFrame;
  cloud: Cloud | null;
}

export const keptClouds = (odometry: OdometryData): Promise<Kept[]> =>
  Promise.all(odometry.kept.map(async (frame) => ({ frame, cloud: frame.model ? await cloudOf(frame.model) : null })));

// A local model stays the same until its next keyframe, a scan does not.
function different(kept: readonly Kept[]): Kept[] {
  let before = "";
  return kept.filter(({ frame }) => {
    const pose = frame.model_pose.join();
    const isNew = pose !== before;
    before = pose;
    return isNew;
  });
}

// Its intensities are the times of the frames, seconds.
export function mapOf(odometry: OdometryData, kept: readonly Kept[]): Cloud {
  const parts = different(kept).filter(({ frame, cloud }) => cloud && isFinitePose(frame.model_pose));
  const count = parts.reduce((sum, { cloud }) => sum + (cloud?.count ?? 0), 0);
  const map: Cloud = {
    count, points: new Float32Array(3 * count), directions: new Int8Array(3 * count), structures: new Uint8Array(count),
    intensities: new Float32Array(count), colours: null, distances: null, distanceDirections: null,
  };
  const order = spreadOrder(count);
  let next = 0;
  for (const { frame, cloud } of parts) {
    const pose = new Matrix4().fromArray(frame.model_pose as number[]);
    for (let i = 0; i < (cloud?.count ?? 0); ++i) {
      const to = order[next++] ?? 0;
      new Vector3().fromArray(cloud?.points ?? [], 3 * i).applyMatrix4(pose).toArray(map.points, 3 * to);
      map.intensities?.set([odometry.frames[frame.frame]?.time ?? 0], to);
    }
  }
  return map;
}
