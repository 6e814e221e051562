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

export interface CloudData {
  points: string; // float32, three a point
  directions?: string; // int8, three a point
  structures?: string; // uint8: 0 none, 1 planar, 2 edge
  partners?: string; // float32, three a point, in the page's frame; NaN: none
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
  zero: [number, number, number]; // of the page, in the target's frame, metres
  extent: number; // metres
  residual_scale: number; // metres
  direction_length: number; // metres
  free_motions: FreeMotion[];
}

export interface FrameData {
  text: string;
  time: Maybe; // seconds since the first
  pose: Maybe[] | null; // 4x4, columns first: from the camera to the page's frame
  top: [number, number] | null; // its place in the top view
}

export interface KeptFrame {
  frame: number;
  width: number;
  height: number;
  depth?: string; // uint8 a pixel; 0: no reading, 1: near, 255: far
  text: string;
  model?: CloudData;
  model_extent?: number; // metres
  model_pose: Maybe[];
}

export interface OdometryData {
  frames: FrameData[];
  kept: KeptFrame[];
  estimate: string; // float32, three a point, two points a line
  truth: string;
  extent: number;
  view: ViewData;
}

export interface ReportData {
  kind: "align" | "odometry" | "experiment";
  charts: ChartData[];
  align?: AlignData;
  odometry?: OdometryData;
}

export function readReport(): ReportData {
  return JSON.parse(document.getElementById("report")?.textContent ?? "{}") as ReportData;
}

function bytes(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const values = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) values[i] = text.charCodeAt(i);
  return values;
}

export const floats = (base64: string): Float32Array<ArrayBuffer> => new Float32Array(bytes(base64).buffer);
export const unsignedBytes = bytes;
export const signedBytes = (base64: string): Int8Array<ArrayBuffer> => new Int8Array(bytes(base64).buffer);

export function isFinitePose(pose: Maybe[] | null | undefined): pose is number[] {
  return pose?.length === 16 && pose.every((value) => value !== null && Math.abs(value) < 1e30);
}
