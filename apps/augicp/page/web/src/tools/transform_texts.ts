// SPDX-License-Identifier: MIT
// The transform in the forms in which other programs take it.

export interface TransformText {
  name: string;
  use: string; // a sentence
  text: string;
}

type Matrix = readonly (readonly number[])[]; // 4x4, rows

// Shortest text that reads back as the same double.
const plain = (value: number): string => String(Object.is(value, -0) ? 0 : value);
const rows = (matrix: Matrix, between: string): string[] => matrix.map((row) => row.map(plain).join(between));

// After Shepperd: the largest of the four is computed first.
export function quaternionOf(matrix: Matrix): [number, number, number, number] {
  const at = (i: number, k: number): number => matrix[i]?.[k] ?? 0;
  const trace = at(0, 0) + at(1, 1) + at(2, 2);
  const candidates = [at(0, 0), at(1, 1), at(2, 2), trace];
  const largest = candidates.indexOf(Math.max(...candidates));
  if (largest === 3) {
    const w = 0.5 * Math.sqrt(1 + trace);
    return [(at(2, 1) - at(1, 2)) / (4 * w), (at(0, 2) - at(2, 0)) / (4 * w), (at(1, 0) - at(0, 1)) / (4 * w), w];
  }
  const [i, j, k] = [largest, (largest + 1) % 3, (largest + 2) % 3];
  const own = 0.5 * Math.sqrt(1 + at(i, i) - at(j, j) - at(k, k));
  const made: [number, number, number, number] = [0, 0, 0, (at(k, j) - at(j, k)) / (4 * own)];
  made[i] = own;
  made[j] = (at(j, i) + at(i, j)) / (4 * own);
  made[k] = (at(k, i) + at(i, k)) / (4 * own);
  return made;
}

function staticTransform(matrix: Matrix): string {
  const [x, y, z] = matrix.map((row) => plain(row[3] ?? 0));
  const [qx, qy, qz, qw] = quaternionOf(matrix).map(plain);
  return `ros2 run tf2_ros static_transform_publisher --x ${x} --y ${y} --z ${z} --qx ${qx} --qy ${qy} --qz ${qz} --qw ${qw} --frame-id target --child-frame-id source`;
}

function pipeline(matrix: Matrix): string {
  const filter = { type: "filters.transformation", matrix: rows(matrix, " ").join(" ") };
  return JSON.stringify({ pipeline: ["source.las", filter, "source_in_target.las"] }, null, 2);
}

const python = (matrix: Matrix): string =>
  `import numpy as np\nT_target_source = np.array([${rows(matrix, ", ").map((row) => `[${row}]`).join(",\n                            ")}])\npoints_in_target = points @ T_target_source[:3, :3].T + T_target_source[:3, 3]`;

const cpp = (matrix: Matrix): string =>
  `Eigen::Matrix4d target_from_source;\ntarget_from_source << ${rows(matrix, ", ").join(",\n    ")};`;

export function transformTexts(matrix: Matrix): TransformText[] {
  return [
    { name: "Matrix", use: "For augicp's --initial, and most programs.", text: rows(matrix, " ").join("\n") },
    { name: "CloudCompare", use: "Edit, Apply transformation, Matrix 4x4: paste it there.", text: rows(matrix, " ").join("\n") },
    { name: "PDAL", use: "A pipeline: pdal pipeline FILE.json.", text: pipeline(matrix) },
    { name: "ROS 2", use: "Publishes the source's frame in the target's.", text: staticTransform(matrix) },
    { name: "Python", use: "With points of shape (N, 3).", text: python(matrix) },
    { name: "C++", use: "With Eigen.", text: cpp(matrix) },
  ];
}
