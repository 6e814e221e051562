// SPDX-License-Identifier: MIT
// Of the picture as a whole: as a file, on the whole screen, and on paper.
import { button, element } from "../dom";
import type { Viewer } from "../stage/viewer";

async function save(viewer: Viewer, name: string): Promise<void> {
  const picture = await viewer.png();
  if (!picture) return;
  const link = element("a");
  link.href = URL.createObjectURL(picture);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

// A printer does not see what a graphics card draws: for it the picture becomes an image.
function preparePrint(viewer: Viewer): void {
  const image = element("img", "printed");
  image.alt = "The 3D view";
  window.addEventListener("beforeprint", () => {
    viewer.drawNow();
    image.src = viewer.canvas.toDataURL();
    viewer.element.append(image);
  });
  window.addEventListener("afterprint", () => { image.remove(); });
}

// stage: what fills the screen, controls included.
export function pictureTools(viewer: Viewer, stage: HTMLElement, name: string): HTMLElement[] {
  preparePrint(viewer);
  const whole = button("Full screen", "Fill the screen; Escape ends it", () => {
    if (document.fullscreenElement) void document.exitFullscreen();
    else void stage.requestFullscreen();
  });
  return [button("PNG", "Save the picture", () => { void save(viewer, name); }), whole];
}
