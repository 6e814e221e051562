// SPDX-License-Identifier: MIT
// Colours for numbers. Their lightness alone orders the sequential ones; the others have their middle at zero.
import { ClampToEdgeWrapping, Color, DataTexture, LinearFilter, RGBAFormat } from "three";

export type Palette = readonly string[]; // equally far apart, from low to high

export const kSigned: Palette = ["#1f4fa3", "#4f9bd8", "#e6c445", "#e8743b", "#a8123e"];
export const kSequential: Palette = ["#3d1259", "#3b528b", "#21918c", "#5ec962", "#e6d628"];

const kColumns = 256;

export function colourAt(palette: Palette, share: number): [number, number, number] {
  const place = Math.max(0, Math.min(1, share)) * (palette.length - 1);
  const at = (index: number): Color => new Color().setStyle(palette[Math.min(palette.length - 1, index)] ?? "#000000", "srgb-linear");
  const { r, g, b } = at(Math.floor(place)).lerp(at(Math.floor(place) + 1), place - Math.floor(place));
  return [r, g, b];
}

export const cssColourAt = (palette: Palette, share: number): string =>
  `rgb(${colourAt(palette, share).map((part) => Math.round(255 * part)).join(" ")})`;

export const gradient = (palette: Palette): string => `linear-gradient(90deg, ${palette.join(", ")})`;

export function paletteTexture(palette: Palette): DataTexture {
  const bytes = new Uint8Array(4 * kColumns);
  for (let i = 0; i < kColumns; ++i) bytes.set([...colourAt(palette, i / (kColumns - 1)).map((part) => Math.round(255 * part)), 255], 4 * i);
  const texture = new DataTexture(bytes, kColumns, 1, RGBAFormat);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.wrapS = ClampToEdgeWrapping;
  texture.needsUpdate = true;
  return texture;
}
