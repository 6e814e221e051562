// SPDX-License-Identifier: MIT
// Clouds of known shape, as text.

export const kFloorSide = 48; // points

// A floor of 1.2 x 1.2 m, four metres ahead, with a thin pole of 2 m in its middle: x to the right, y ahead, z up.
export function floorAndPole() {
  const points = [];
  for (let i = 0; i < kFloorSide; ++i) for (let k = 0; k < kFloorSide; ++k) points.push([-0.6 + i / 40, 3.4 + k / 40, -1.2]);
  for (let i = 0; i < 400; ++i) for (const turn of [0, 2, 4]) points.push([0.02 * Math.cos(turn), 4 + 0.02 * Math.sin(turn), -1.2 + i / 200]);
  return points;
}

// The same as a camera has it that looks down by an angle: x to the right, y down, z ahead.
export function seenByCamera(points, down_rad) {
  const [c, s] = [Math.cos(down_rad), Math.sin(down_rad)];
  return points.map(([x, y, z]) => [x, -c * z - s * y, c * y - s * z]);
}

// Across the yz plane by an angle.
export function tilted(points, angle_rad) {
  const [c, s] = [Math.cos(angle_rad), Math.sin(angle_rad)];
  return points.map(([x, y, z]) => [x, c * y - s * z, s * y + c * z]);
}

export const asText = (points) => points.map((point) => point.map((value) => value.toFixed(5)).join(" ")).join("\n");
