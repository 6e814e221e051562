// SPDX-License-Identifier: MIT
// The map along a trajectory, of a depth camera and of a LiDAR.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { changes, inPage } from "./browser.mjs";
import { cutTables, ink, smallestLetters } from "./picture.mjs";
import { browserForTests, folder, report, sequence } from "./reports.mjs";
import { asPly, hallScan } from "./scenes.mjs";

const browser = await browserForTests();
mkdirSync(join(folder, "hall"));
for (let i = 0; i < 8; ++i) writeFileSync(join(folder, "hall", `${String(i).padStart(6, "0")}.ply`), asPly(hallScan([-1.5 + 0.3 * i, 0.1 * i, -1])));
const pages = {
  camera: report("camera.html", ["odometry", sequence, "--camera", "tum-fr1", "--output", "camera"]),
  lidar: report("lidar.html", ["odometry", "hall", "--sensor", "lidar", "--output", "lidar"], { codes: [0, 5] }),
};

for (const [sensor, file] of Object.entries(pages)) {
  test(`${sensor}: map and trajectory fill the first view; each can be hidden and coloured`, () => inPage(browser, file, {}, async (page) => {
    const toggle = (name) => page.getByRole("button", { name, exact: true }).click();
    await toggle("Grid");
    const seen = await ink(page);
    assert.ok(seen.left > 0 && seen.right < 1 && seen.top > 0 && seen.bottom < 1, JSON.stringify(seen));
    assert.ok(Math.max(seen.right - seen.left, seen.bottom - seen.top) > 0.7, JSON.stringify(seen));
    for (const colour of ["status", "time", "one colour"])
      assert.ok(await changes(page, () => page.getByLabel("Colour", { exact: true }).selectOption(colour)), colour);
    for (const name of ["Map", sensor === "lidar" ? "Scan" : "Local model"]) assert.ok(await changes(page, () => toggle(name)), name);
  }));
  test(`${sensor}: what was seen follows the frame`, () => inPage(browser, file, {}, async (page) => {
    await page.getByRole("button", { name: "Map", exact: true }).click();
    assert.ok(await changes(page, () => page.keyboard.press("Home")));
    assert.match(await page.locator("output").innerText(), /Frame 0, 0.00 s: started/);
    assert.equal(await page.locator(".depth").isVisible(), sensor === "camera");
  }));
}

// From the wall, a pillar, floor or ceiling of the hall; the world is the frame of the first scan.
function offHall([x, y, z]) {
  const [px, py, pz] = [x - 1.5, y, z - 1];
  const pillars = [[3, 2, 0.5], [-2, -1.5, 0.4]].map(([cx, cy, r]) => Math.abs(Math.hypot(px - cx, py - cy) - r));
  return Math.min(...[[px, 6], [py, 4], [pz, 2.5]].map(([value, half]) => Math.abs(Math.abs(value) - half)), ...pillars);
}

test("a click reads a point of the map, a second one the distance", () => inPage(browser, pages.lidar, {}, async (page) => {
  const canvas = page.locator(".view > canvas");
  const { width, height } = await canvas.boundingBox();
  const found = [];
  for (let i = 4; i < 17 && found.length < 2; ++i) {
    await canvas.click({ position: { x: (width * i) / 20, y: height / 2 } });
    if (!(await page.locator(".readout").isVisible())) continue;
    const text = await page.locator(".readout").innerText();
    const place = text.match(/world frame \((-?[\d.]+), (-?[\d.]+), (-?[\d.]+)\) m/).slice(1).map(Number);
    if (place.join() !== found.at(-1)?.place.join()) found.push({ text, place });
  }
  assert.equal(found.length, 2);
  for (const { place } of found) assert.ok(offHall(place) < 0.1, `${place}`);
  const [, number, unit] = found[1].text.match(/([\d.]+) (m|cm) from the point before/);
  const expected = Math.hypot(...found[0].place.map((value, k) => value - found[1].place[k]));
  assert.ok(Math.abs(Number(number) * (unit === "m" ? 1 : 0.01) - expected) < 2e-3 * Math.max(1, expected), found[1].text);
}));

test("section, point size and PNG work on the map", () => inPage(browser, pages.lidar, {}, async (page) => {
  for (const name of ["Grid", "Map"]) await page.getByRole("button", { name, exact: true }).click();
  await page.getByText("Section", { exact: true }).click();
  assert.ok(await changes(page, () => page.getByLabel("Section x, upper end").fill("150")));
  await page.getByTitle("First (Home)").click();
  const cut = (await ink(page)).share; // of a scan that came into the picture after the cut
  await page.getByRole("button", { name: "Whole" }).click();
  assert.ok((await ink(page)).share > 1.3 * cut);
  assert.ok(await changes(page, () => page.getByLabel("Point size").fill("3")));
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "PNG" }).click()]);
  assert.equal(download.suggestedFilename(), "odometry.png");
}));

test("a LiDAR's page says what it is", () => inPage(browser, pages.lidar, {}, async (page) => {
  assert.match(await page.locator("header").innerText(), /LiDAR odometry[\s\S]*8 frames, 8 with a pose[\s\S]*Times of the points/);
  assert.match(await page.locator("main").innerText(), /Overlap with the map/);
}));

test("beside the picture the table of errors is whole", () => inPage(browser, pages.camera, { viewport: { width: 1280, height: 720 } }, async (page) => {
  assert.ok((await page.locator("table").count()) > 0);
  assert.deepEqual(await cutTables(page), []);
}));

test("on a phone the numbers of a drawing can be read", () => inPage(browser, pages.camera, { viewport: { width: 390, height: 844 }, isMobile: true }, async (page) => {
  const size = await smallestLetters(page);
  assert.ok(size >= 9.5 && size < 20, `${size}`);
}));
