// SPDX-License-Identifier: MIT
// A cloud as the page uses it: one entry a point in each array, in an order in which every beginning is spread over the whole.
import type { CloudData } from "./data";
import { unpackedBytes, unpackedDirections, unpackedNumbers, unpackedPoints } from "./packed";

export interface Cloud {
  count: number;
  points: Float32Array<ArrayBuffer>; // three a point
  directions: Int8Array<ArrayBuffer>; // three a point, 127 for 1
  structures: Uint8Array<ArrayBuffer>; // 0 none, 1 planar, 2 edge
  intensities: Float32Array<ArrayBuffer> | null; // NaN: unknown
  colours: Uint8Array<ArrayBuffer> | null; // red, green and blue, three a point
  distances: Float32Array<ArrayBuffer> | null; // from the target's surface under the final pose, metres; NaN: no overlap
  distanceDirections: Int8Array<ArrayBuffer> | null; // in the page, three a point
}

type Numbers = Float32Array<ArrayBuffer> | Int8Array<ArrayBuffer> | Uint8Array<ArrayBuffer>;

// A fixed order without a pattern: steps of the golden section of the count, made prime to it.
export function spreadOrder(count: number): Uint32Array {
  const divisor = (one: number, other: number): number => (other === 0 ? one : divisor(other, one % other));
  let step = Math.max(1, Math.floor(count * 0.6180339887));
  while (divisor(count, step) !== 1) ++step;
  const order = new Uint32Array(count);
  for (let i = 0, place = 0; i < count; ++i, place = (place + step) % count) order[i] = place;
  return order;
}

function reordered<Values extends Numbers>(values: Values, order: Uint32Array, width: number): Values {
  const made = values.slice() as Values;
  order.forEach((from, to) => {
    for (let k = 0; k < width; ++k) made[width * to + k] = values[width * from + k] ?? 0;
  });
  return made;
}

async function unpackedColours(base64: string): Promise<Uint8Array<ArrayBuffer>> {
  const planes = await unpackedBytes(base64);
  const count = planes.length / 3;
  return new Uint8Array(planes.length).map((_, i) => planes[(i % 3) * count + Math.floor(i / 3)] ?? 0);
}

export async function cloudOf(data: CloudData): Promise<Cloud> {
  const points = await unpackedPoints(data.points);
  const count = points.length / 3;
  const order = spreadOrder(count);
  const directions = data.directions === undefined ? new Int8Array(3 * count) : await unpackedDirections(data.directions);
  const structures = data.structures === undefined ? new Uint8Array(count) : await unpackedBytes(data.structures);
  const numbers = async (text?: string): Promise<Float32Array<ArrayBuffer> | null> =>
    text === undefined ? null : reordered(await unpackedNumbers(text), order, 1);
  return {
    count,
    points: reordered(points, order, 3),
    directions: reordered(directions, order, 3),
    structures: reordered(structures, order, 1),
    intensities: await numbers(data.intensities),
    colours: data.colours === undefined ? null : reordered(await unpackedColours(data.colours), order, 3),
    distances: await numbers(data.distances),
    distanceDirections: data.distance_directions === undefined ? null : reordered(await unpackedDirections(data.distance_directions), order, 3),
  };
}
