// SPDX-License-Identifier: MIT
// Normals and tangents of some of a cloud's points, as short lines in their structure's colour.
import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments } from "three";
import type { Cloud } from "./cloud";
import { cssColour } from "./dom";

const kMaxLines = 1500; // of each structure
const kPlanar = 1;
const kEdge = 2;

function chosen(structures: Uint8Array, structure: number): number[] {
  const all: number[] = [];
  structures.forEach((value, index) => { if (value === structure) all.push(index); });
  const stride = Math.max(1, Math.ceil(all.length / kMaxLines));
  return all.filter((_, place) => place % stride === 0);
}

// Normals stand on their point, tangents lie on both sides of it.
export function directionLines({ points, directions, structures }: Cloud, length: number): LineSegments {
  const positions: number[] = [];
  const colours: number[] = [];
  for (const [structure, name, back] of [[kPlanar, "--planar", 0], [kEdge, "--edge", 1]] as const) {
    const colour = new Color(cssColour(name)).toArray();
    for (const i of chosen(structures, structure)) {
      const along = (share: number): number[] =>
        [0, 1, 2].map((k) => (points[3 * i + k] ?? 0) + (share * length * (directions[3 * i + k] ?? 0)) / 127);
      positions.push(...along(-back), ...along(1));
      colours.push(...colour, ...colour);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(colours), 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
  lines.matrixAutoUpdate = false;
  lines.frustumCulled = false;
  return lines;
}
