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

// A flat square of 2 x 2 m from x, with the waves of the same landscape wherever it is cut out.
export function landscape(from) {
  const points = [];
  for (let i = 0; i < 80; ++i) for (let k = 0; k < 80; ++k) {
    const [x, y] = [from + i / 40, k / 40];
    points.push([x, y, 0.1 * Math.sin(3 * x) + 0.15 * Math.cos(4 * y + x)]);
  }
  return points;
}

// What a LiDAR at a place sees of a hall of 12 x 8 x 5 m with two pillars, in its own frame: 16 rings of 240 points.
export function hallScan([px, py, pz]) {
  const pillars = [[3, 2, 0.5], [-2, -1.5, 0.4]];
  const points = [];
  for (let ring = 0; ring < 16; ++ring)
    for (let turn = 0; turn < 240; ++turn) {
      const [rise, angle] = [((ring - 8) * 3 * Math.PI) / 180, (turn * 2 * Math.PI) / 240];
      const ray = [Math.cos(rise) * Math.cos(angle), Math.cos(rise) * Math.sin(angle), Math.sin(rise)];
      const walls = [6, 4, 2.5].map((half, k) => (Math.sign(ray[k]) * half - [px, py, pz][k]) / ray[k]).filter((t) => t > 0);
      const hits = pillars.map(([x, y, r]) => {
        const [dx, dy] = [px - x, py - y];
        const [a, b, c] = [ray[0] ** 2 + ray[1] ** 2, dx * ray[0] + dy * ray[1], dx * dx + dy * dy - r * r];
        const root = b * b - a * c;
        return root > 0 ? (-b - Math.sqrt(root)) / a : Infinity;
      }).filter((t) => t > 0);
      const range = Math.min(...walls, ...hits);
      points.push(ray.map((part) => range * part));
    }
  return points;
}

export const asPly = (points) =>
  `ply\nformat ascii 1.0\nelement vertex ${points.length}\nproperty float x\nproperty float y\nproperty float z\nend_header\n${asText(points)}\n`;
