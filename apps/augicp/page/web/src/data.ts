// SPDX-License-Identifier: MIT
// What the command writes for this page, and how its packed arrays are read.

export type Maybe = number | null; // a number that is not finite is null in JSON

export interface SeriesData {
  name: string;
  y: Maybe[];
  low?: Maybe[];
  high?: Maybe[];
}

export interface ChartData {
  title: string;
  x_label: string;
  y_label: string;
  log_y: boolean;
  x: number[];
  y_range: [number, number];
  series: SeriesData[];
}

// Packed arrays; see packed.ts. One entry a point in each.
export interface CloudData {
  points: string;
  directions?: string;
  structures?: string; // 0 none, 1 planar, 2 edge
  intensities?: string;
  colours?: string; // all red bytes, then the green and the blue ones
  distances?: string; // from the target's surface under the final pose, metres
  distance_directions?: string; // in which they are measured, in the page's frame
}

export interface FreeMotion {
  kind: "translation" | "rotation" | "screw";
  axis: Maybe[];
  point: Maybe[];
}

// The camera's directions, in the page's frame, unit length.
export interface ViewData {
  up: [number, number, number];
  ahead: [number, number, number]; // across up, where it looks most
}

export interface AlignData {
  source: CloudData;
  target: CloudData;
  poses: Maybe[][]; // 4x4, columns first: from source points to the page's frame; of the guess and after each iteration
  step_texts: string[]; // as many
  transform: number[][]; // 4x4, rows: from source to target, with all digits
  zero: [number, number, number]; // of the page, in the target's frame, metres
  source_zero: [number, number, number]; // the source's origin in its frame, metres
  pairs: string; // packed points: of the source and of the target in the page, in turn
  extent: number; // metres
  direction_length: number; // metres
  free_motions: FreeMotion[];
}

export interface FrameData {
  text: string;
  time: Maybe; // seconds since the first
  pose: Maybe[] | null; // 4x4, columns first: from the camera to the page's frame
  top: [number, number] | null; // its place in the top view
  status: string; // a name in the style sheet
  segment: number; // poses of different segments have no measured motion between them
}

export interface KeptFrame {
  frame: number;
  width: number;
  height: number;
  depth?: string; // packed bytes, one a pixel; 0: no reading, 1: near, 255: far
  text: string;
  model?: CloudData;
  model_extent?: number; // metres
  model_pose: Maybe[];
}

export interface OdometryData {
  frames: FrameData[];
  kept: KeptFrame[];
  lidar: boolean;
  has_truth: boolean;
  truth: string; // packed points, two a line
  extent: number;
  zero: [number, number, number]; // of the page in the ground truth's frame, or in the world without one, metres
  view: ViewData;
}

export interface TrajectoriesData {
  paths: { name: string; lines: string }[]; // packed points, two a line; the ground truth last
  zero: [number, number, number]; // of the page in the ground truth's frame, metres
  view: ViewData;
}

export interface ReportData {
  kind: "align" | "odometry" | "trajectories" | "experiment";
  charts: ChartData[];
  align?: AlignData;
  odometry?: OdometryData;
  trajectories?: TrajectoriesData;
}

export function readReport(): ReportData {
  return JSON.parse(document.getElementById("report")?.textContent ?? "{}") as ReportData;
}

export function isFinitePose(pose: Maybe[] | null | undefined): pose is number[] {
  return pose?.length === 16 && pose.every((value) => value !== null && Math.abs(value) < 1e30);
}
