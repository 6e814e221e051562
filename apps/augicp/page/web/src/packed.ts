// SPDX-License-Identifier: MIT
// Reads the arrays that page/packing.h describes.

const kChunk = 1024;

async function bytes(base64: string): Promise<Uint8Array<ArrayBuffer>> {
  if (base64 === "") return new Uint8Array(0);
  const text = atob(base64);
  const packed = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export const unpackedBytes = bytes;

// Three floats a point.
export async function unpackedPoints(base64: string): Promise<Float32Array<ArrayBuffer>> {
  const raw = await bytes(base64);
  if (raw.length < 4) return new Float32Array(0);
  const view = new DataView(raw.buffer);
  const count = view.getUint32(0, true);
  const heads = Math.ceil(count / kChunk);
  const points = new Float32Array(3 * count);
  for (let axis = 0; axis < 3; ++axis) {
    const low = 4 + 16 * heads + 2 * count * axis;
    let value = 0;
    let least = 0;
    let step = 1;
    for (let i = 0; i < count; ++i) {
      if (i % kChunk === 0) {
        const head = 4 + (16 * i) / kChunk;
        least = view.getFloat32(head + 4 * axis, true);
        step = view.getFloat32(head + 12, true);
        value = 0;
      }
      value = (value + (raw[low + i] ?? 0) + 256 * (raw[low + count + i] ?? 0)) & 65535;
      points[3 * i + axis] = least + step * value;
    }
  }
  return points;
}

// NaN where there is none.
export async function unpackedNumbers(base64: string): Promise<Float32Array<ArrayBuffer>> {
  const raw = await bytes(base64);
  const count = Math.max(0, (raw.length - 4) / 2);
  const numbers = new Float32Array(count);
  if (count === 0) return numbers;
  const step = new DataView(raw.buffer).getFloat32(0, true) / 32767;
  for (let i = 0; i < count; ++i) {
    const value = (raw[4 + i] ?? 0) + 256 * (raw[4 + count + i] ?? 0);
    numbers[i] = value === 32768 ? NaN : step * (value > 32768 ? value - 65536 : value);
  }
  return numbers;
}

const sign = (value: number): number => (value < 0 ? -1 : 1);

// Three int8 a direction, 127 for 1; zero for none.
export async function unpackedDirections(base64: string): Promise<Int8Array<ArrayBuffer>> {
  const places = new Int8Array((await bytes(base64)).buffer);
  const count = places.length / 2;
  const directions = new Int8Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const [u, v] = [(places[i] ?? 0) / 127, (places[count + i] ?? 0) / 127];
    if (u === 0 && v === 0) continue;
    const z = 1 - Math.abs(u) - Math.abs(v);
    const [x, y] = z < 0 ? [(1 - Math.abs(v)) * sign(u), (1 - Math.abs(u)) * sign(v)] : [u, v];
    const scale = 127 / Math.hypot(x, y, z);
    directions.set([x * scale, y * scale, z * scale].map(Math.round), 3 * i);
  }
  return directions;
}
