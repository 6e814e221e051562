// SPDX-License-Identifier: MIT
// In place of a 3D view: what is missing, why, and what to do.
import { element } from "./dom";

function hasWebGl(): boolean {
  return element("canvas").getContext("webgl2") !== null;
}

export function noView(what: string, reason: unknown): HTMLElement {
  const box = element("div", "notice");
  const why = hasWebGl()
    ? `the picture could not be made (${reason instanceof Error ? reason.message : String(reason)}).`
    : "this browser has no WebGL 2, or it is switched off.";
  box.append(
    element("p", "", `${what}: ${why}`),
    element("p", "", "Everything else on this page works. Another browser, or hardware acceleration in this one's settings, brings the picture."),
  );
  return box;
}
