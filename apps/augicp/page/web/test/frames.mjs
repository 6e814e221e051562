// SPDX-License-Identifier: MIT
// Times of a report's pictures while the view is rotated, with the level of detail and with all points; not a test.
//
//   node frames.mjs REPORT.html
import { inPage, launch } from "./browser.mjs";

const kPictures = 25;

// Notes the points and the time of each picture, and draws those that the page leaves out if it is to draw all.
function watch() {
  const { drawArrays } = window.WebGL2RenderingContext.prototype;
  const most = []; // points of each cloud, at rest
  window.watched = { all: false, pictures: [] };
  let place = 0, last_ms = -1;
  window.WebGL2RenderingContext.prototype.drawArrays = function (mode, first, count) {
    if (mode !== this.POINTS) return drawArrays.call(this, mode, first, count);
    const now_ms = document.timeline.currentTime; // one value a picture
    place = now_ms === last_ms ? place + 1 : 0;
    last_ms = now_ms;
    most[place] = Math.max(most[place] ?? 0, count);
    const drawn = window.watched.all ? most[place] : count;
    if (place === 0) window.watched.pictures.push({ points: 0, now_ms });
    window.watched.pictures.at(-1).points += drawn;
    return drawArrays.call(this, mode, first, drawn);
  };
}

// Rotates the view without a pause until enough pictures were drawn; the median time from one to the next, and the points of
// the last one.
async function rotated(page, all) {
  const box = await page.locator(".view > canvas").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.evaluate((value) => { Object.assign(window.watched, { all: value, pictures: [] }); }, all);
  let pictures = [];
  for (let k = 0; pictures.length < kPictures; ++k) {
    await page.mouse.move(x + 40 * Math.sin(k / 5), y + 20 * Math.cos(k / 5));
    if (k % 10 === 0) pictures = await page.evaluate(() => window.watched.pictures);
  }
  await page.evaluate(() => { window.watched.all = false; });
  await page.mouse.up();
  const gaps = pictures.slice(1).map(({ now_ms }, i) => now_ms - pictures[i].now_ms).sort((one, other) => one - other);
  return { points: pictures.at(-1).points, median_ms: gaps[gaps.length >> 1] };
}

const browser = await launch();
await inPage(browser, process.argv[2], { initScript: watch }, async (page) => {
  const atRest = await page.evaluate(() => window.watched.pictures.at(-1).points);
  console.log(`at rest ${atRest} points`);
  for (const all of [true, false, true, false]) {
    const { points, median_ms } = await rotated(page, all);
    console.log(`${all ? "all points" : "level of detail"}: ${points} points, ${median_ms.toFixed(0)} ms a picture`);
  }
});
await browser.close();
