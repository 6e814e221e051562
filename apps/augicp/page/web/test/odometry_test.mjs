// SPDX-License-Identifier: MIT
// The map along a trajectory, of a depth camera and of a LiDAR.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { changes, inPage } from "./browser.mjs";
import { ink } from "./picture.mjs";
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

test("a LiDAR's page says what it is", () => inPage(browser, pages.lidar, {}, async (page) => {
  assert.match(await page.locator("header").innerText(), /LiDAR odometry[\s\S]*8 frames, 8 with a pose[\s\S]*Times of the points/);
  assert.match(await page.locator("main").innerText(), /Overlap with the map/);
}));
