// SPDX-License-Identifier: MIT
// Buttons that show and hide parts of the picture.
import { element, toggle } from "../dom";
import type { AlignScene } from "./scene";

export function layerToggles(scene: AlignScene): HTMLElement {
  const row = element("div", "toggles");
  const add = (text: string, title: string, pressed: boolean, change: (on: boolean) => void): void => {
    row.append(toggle(text, title, pressed, (on) => { change(on); scene.viewer.invalidate(); }));
  };
  add("Target", "The fixed cloud", true, (on) => { scene.target.visible = on; });
  add("Source", "The moving cloud", true, (on) => { scene.source.visible = on; });
  add("Correspondences", "Lines from source points to their target points under the final pose", false, (on) => { scene.pairs.visible = on; });
  add("Normals, tangents", "Directions of some points", false, (on) => { for (const lines of scene.directions) lines.visible = on; });
  if (scene.arrows.children.length > 0) add("Free motions", "Motions that the data do not constrain", true, (on) => { scene.arrows.visible = on; });
  add("Grid", "Lines on the ground", true, (on) => { scene.viewer.showGround(on); });
  return row;
}
