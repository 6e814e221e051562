// SPDX-License-Identifier: MIT
// The state of the view in the page's address, so that a copied address opens the same view.
import { Vector3 } from "three";
import type { Viewer } from "../stage/viewer";

const kDelay_ms = 150;
const kDigits = 10;

export type LinkState = Record<string, string>;

export const numbersText = (values: readonly number[]): string => values.map((value) => Number(value.toPrecision(kDigits))).join(",");

// Nothing where a value is no number.
export function numbersOf(text: string | undefined, count: number): number[] | null {
  const values = text?.split(",").map(Number) ?? [];
  return values.length === count && values.every(Number.isFinite) ? values : null;
}

export const readLink = (): LinkState => Object.fromEntries(new URLSearchParams(location.hash.slice(1)));

// stateOf: of all else than the camera; an empty text is left out.
export function keepLink(viewer: Viewer, stateOf: () => LinkState): () => void {
  let timer = 0;
  const write = (): void => {
    const { eye, target, up } = viewer.state;
    const camera = viewer.isHome ? "" : numbersText([...eye.toArray(), ...target.toArray(), ...up.toArray()]);
    const entries = Object.entries({ ...stateOf(), camera }).filter(([, value]) => value !== "");
    history.replaceState(null, "", `#${new URLSearchParams(entries).toString()}`);
  };
  return () => {
    window.clearTimeout(timer);
    timer = window.setTimeout(write, kDelay_ms);
  };
}

export function restoreCamera(viewer: Viewer, text: string | undefined): void {
  const values = numbersOf(text, 9);
  if (!values) return;
  const [eye, target, up] = [0, 3, 6].map((at) => new Vector3().fromArray(values, at));
  if (eye && target && up && eye.distanceTo(target) > 0 && up.length() > 0.5) viewer.lookFrom({ eye, target, up });
}
