// SPDX-License-Identifier: MIT
// What the first view of two clouds needs to know of them.
import { Vector3 } from "three";
import type { Cloud } from "./cloud";
import { type AlignData, isFinitePose } from "./data";
import { type Fitted, samplesOf } from "./stage/framing";
import { homeDirection } from "./stage/home";
import { isOfCamera, type Upward, upwards } from "./stage/upward";
import type { Home } from "./stage/viewer";

export class Survey {
  readonly upwards: Upward[];
  private readonly points: Vector3[];
  private readonly ahead: Vector3;

  constructor(align: AlignData, source: Cloud, target: Cloud) {
    const surveyed = { ...target, zero: new Vector3(...align.zero) };
    this.upwards = upwards(surveyed);
    // A sensor that looks around: from above, with x to the right and y ahead.
    this.ahead = isOfCamera(surveyed) ? new Vector3(0, 0, 1) : new Vector3(0.35, 0.61, -0.71);
    const last = align.poses.at(-1);
    const moved: Fitted = { points: source.points, ...(isFinitePose(last) ? { pose: last } : {}) };
    this.points = samplesOf([{ points: target.points }, moved]);
  }

  home(index: number): Home {
    const up = this.upwards[index]?.up ?? new Vector3(0, 0, 1);
    return { points: this.points, toEye: homeDirection(up, this.ahead), up };
  }
}
