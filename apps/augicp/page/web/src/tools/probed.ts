// SPDX-License-Identifier: MIT
// What the tools need to know of a view with points.
import type { Vector3 } from "three";
import type { CloudPoints } from "../cloud_points";
import type { Viewer } from "../stage/viewer";
import type { Picked } from "./pick";

export interface Bounds {
  low: Vector3; // in the page
  high: Vector3;
}

export interface Probed {
  readonly viewer: Viewer;
  readonly clouds: readonly CloudPoints[]; // those that are drawn now
  readonly zero: readonly number[]; // of the page, in the frame of the coordinates that are shown, metres
  box: Bounds; // what lies outside is not drawn
  describe(point: Picked): string[]; // the first line is its title
}

export const coordinates = (place: Vector3): string => `(${place.toArray().map((value) => value.toFixed(4)).join(", ")}) m`;

export const kStructures = ["no structure", "planar", "edge"] as const;
