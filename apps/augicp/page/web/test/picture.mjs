// SPDX-License-Identifier: MIT
// What a picture shows, from its pixels.
import { settled } from "./browser.mjs";

const overlays = ".gizmo, .scale-bar, .depth, .wheel-hint, .view-tools, .readout { visibility: hidden !important; }";

// The box of all that is drawn on the ground of a view, as shares of its width and height: left, right, top, bottom; and the
// mean place across of its topmost part and of its middle; the mean saturation in its three thirds, from the left, and the mean red, green and blue, 0 to 255.
export async function ink(page, selector = ".view > canvas") {
  const style = await page.addStyleTag({ content: overlays });
  await settled(page);
  const png = (await page.locator(selector).first().screenshot()).toString("base64");
  await style.evaluate((element) => element.remove());
  return page.evaluate(async (base64) => {
    const image = new window.Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const { width, height } = image;
    const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const ground = [...data.subarray(4 * (2 * width + 2), 4 * (2 * width + 2) + 3)];
    const rows = Array.from({ length: height }, (_, y) =>
      Array.from({ length: width }, (_, x) => x).filter((x) => ground.some((value, k) => Math.abs(data[4 * (y * width + x) + k] - value) > 24)));
    const filled = rows.flatMap((row, y) => (row.length > 0 ? [y] : []));
    const places = rows.flat();
    const mean = (from, to) => { const part = rows.slice(from, to).flat(); return part.reduce((sum, x) => sum + x, 0) / Math.max(1, part.length) / width; };
    const [top, bottom] = [filled[0] ?? 0, filled.at(-1) ?? 0];
    const saturation = (x, y) => { const rgb = [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)]; return Math.max(...rgb) - Math.min(...rgb); };
    const meanSaturation = (third) => {
      const [low, high] = [Math.min(...places.slice(0, 1e5)), Math.max(...places.slice(0, 1e5))];
      const all = rows.flatMap((row, y) => row.filter((x) => Math.floor((3 * (x - low)) / (high - low + 1)) === third).map((x) => saturation(x, y)));
      return all.reduce((sum, value) => sum + value, 0) / Math.max(1, all.length) / 255;
    };
    const at = (share) => Math.round(top + share * (bottom - top));
    return {
      left: places.reduce((least, x) => Math.min(least, x), width) / width,
      right: (1 + places.reduce((most, x) => Math.max(most, x), 0)) / width,
      top: top / height,
      bottom: (bottom + 1) / height,
      mean: [0, 1, 2].map((k) => rows.reduce((sum, row, y) => sum + row.reduce((part, x) => part + data[4 * (y * width + x) + k], 0), 0) / Math.max(1, places.length)),
      saturation: [0, 1, 2].map((third) => meanSaturation(third)),
      share: places.length / (width * height),
      topX: mean(top, at(0.06)),
      upperX: mean(at(0.2), at(0.3)),
    };
  }, png);
}

// The tables that scroll sideways.
export const cutTables = (page) => page.locator(".scroll").evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.innerText));

// The smallest height of the letters in a drawing, in pixels of the page: a drawing shrinks with its text.
export const smallestLetters = (page) => page.locator("svg text").evaluateAll((all) => Math.min(...all.map((text) => {
  const drawing = text.ownerSVGElement;
  return (parseFloat(window.getComputedStyle(text).fontSize) * drawing.clientWidth) / drawing.viewBox.baseVal.width;
}).filter((size) => size > 0)));
