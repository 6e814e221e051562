// SPDX-License-Identifier: MIT
// What moves in the drawings that the command made: the frame shown, in the status strip and in the top view.

const kSvg = "http://www.w3.org/2000/svg";

// The function given back marks a frame.
export function markStrip(numFrames: number, onPick: (frame: number) => void): (frame: number) => void {
  const strip = document.querySelector<SVGSVGElement>("svg.strip");
  if (!strip) return () => undefined;
  const { width, height } = strip.viewBox.baseVal;
  const cursor = document.createElementNS(kSvg, "rect");
  cursor.setAttribute("class", "cursor");
  cursor.setAttribute("height", String(height));
  cursor.setAttribute("width", String(Math.max(2, width / numFrames)));
  strip.append(cursor);
  strip.addEventListener("click", (event) => {
    const box = strip.getBoundingClientRect();
    onPick(Math.floor(((event.clientX - box.left) / box.width) * numFrames));
  });
  return (frame) => {
    cursor.setAttribute("x", String((frame * width) / numFrames));
  };
}

export function markTopView(place: [number, number] | null): void {
  const group = document.querySelector<SVGGElement>("g.marker");
  if (!group) return;
  group.replaceChildren();
  const { x = "0", y = "0", scale = "1" } = group.dataset;
  if (!place) return;
  const dot = document.createElementNS(kSvg, "circle");
  dot.setAttribute("r", "4.5");
  dot.setAttribute("cx", String(Number(x) + Number(scale) * place[0]));
  dot.setAttribute("cy", String(Number(y) - Number(scale) * place[1]));
  group.append(dot);
}
