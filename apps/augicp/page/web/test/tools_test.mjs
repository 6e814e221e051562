// SPDX-License-Identifier: MIT
// The tools of the view.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { changes, inPage, pixels, settled } from "./browser.mjs";
import { augicp, browserForTests, folder, report, room } from "./reports.mjs";

const browser = await browserForTests();
const roomPage = report("room.html", ["align", ...room]);
// Three points a metre apart along x, and a floor below them, far from zero.
const kZero = [400000, 5000000, 100];
const corner = [0, 1, 2].flatMap((axis) => Array.from({ length: 900 }, (_, i) => {
  const [u, v] = [(i % 30) / 10, Math.floor(i / 30) / 10];
  return [[u, v, 0], [u, 0, v], [0, u, v]][axis].map((value, k) => value + kZero[k]);
}));
writeFileSync(join(folder, "corner.xyz"), corner.map((point) => point.map((value) => value.toFixed(3)).join(" ")).join("\n"));
const cornerPage = report("corner.html", ["align", "corner.xyz", "corner.xyz"], { codes: [0, 4, 5] });
const canvasOf = (page) => page.locator(".view > canvas");

test("a click reads a point in both frames, a second one the distance", () => inPage(browser, cornerPage, {}, async (page) => {
  const { width, height } = await canvasOf(page).boundingBox();
  const read = async (x, y) => {
    await canvasOf(page).click({ position: { x: width * x, y: height * y } });
    const text = await page.locator(".readout").innerText();
    const [, ...numbers] = text.match(/target frame \((-?[\d.]+), (-?[\d.]+), (-?[\d.]+)\) m/) ?? [];
    return { text, place: numbers.map(Number) };
  };
  let first = null;
  let second = null;
  for (let i = 3; i < 18 && !second; ++i) {
    const found = await read(i / 20, 0.6).catch(() => null);
    if (found?.place.length === 3 && !first) first = found;
    else if (found?.place.length === 3 && found.place.join() !== first?.place.join()) second = found;
  }
  const nearest = (place) => Math.min(...corner.map((point) => Math.hypot(...point.map((value, k) => value - place[k]))));
  for (const { place } of [first, second]) assert.ok(nearest(place) < 2e-3, `${place}`);
  const [, number, unit] = second.text.match(/([\d.]+) (m|cm) from the point before/);
  const expected = Math.hypot(...first.place.map((value, k) => value - second.place[k]));
  assert.ok(Math.abs(Number(number) * (unit === "m" ? 1 : 0.01) - expected) < 2e-3, second.text);
  await page.getByTitle("Forget the points").click();
  assert.ok(!(await page.locator(".readout").isVisible()));
}));

test("section, point size, and before beside after change the picture and back", () => inPage(browser, roomPage, {}, async (page) => {
  const first = await pixels(page);
  await page.getByText("Section", { exact: true }).click();
  const whole = await pixels(page);
  assert.ok(await changes(page, () => page.getByLabel("Section x, upper end").fill("200")));
  await page.getByRole("button", { name: "Whole" }).click();
  assert.equal(await pixels(page), whole);
  await page.getByText("Section", { exact: true }).click();
  assert.ok(await changes(page, () => page.getByLabel("Point size").fill("3")));
  await page.getByLabel("Point size").fill("1");
  const split = page.getByRole("button", { name: "Before and after" });
  assert.ok(await changes(page, () => split.click()));
  await split.click();
  assert.equal(await pixels(page), first);
}));

test("the picture is saved as a PNG of its size", () => inPage(browser, roomPage, {}, async (page) => {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "PNG" }).click()]);
  const file = join(folder, download.suggestedFilename());
  await download.saveAs(file);
  const png = readFileSync(file);
  assert.equal(png.toString("latin1", 1, 4), "PNG");
  assert.equal(png.readUInt32BE(16), await canvasOf(page).evaluate((canvas) => canvas.width));
  assert.ok(png.length > 20000, "it is not empty");
}));

test("a copied address opens the same view", async () => {
  let address = "";
  let picture = "";
  await inPage(browser, roomPage, {}, async (page) => {
    await page.getByLabel("Colour", { exact: true }).selectOption("height");
    await page.keyboard.press("Home");
    await canvasOf(page).focus();
    for (const key of ["ArrowLeft", "ArrowUp", "+"]) await page.keyboard.press(key);
    await page.getByText("Section", { exact: true }).click();
    await page.getByLabel("Section y, lower end").fill("150");
    await page.waitForFunction(() => /camera=.*/.test(window.location.hash) && /section=/.test(window.location.hash));
    await page.getByText("Section", { exact: true }).click();
    await page.locator(".steps input").fill("1");
    await page.waitForFunction(() => /step=1/.test(window.location.hash));
    await canvasOf(page).blur();
    address = await page.evaluate(() => window.location.hash);
    picture = await pixels(page);
  });
  await inPage(browser, roomPage, { hash: address }, async (page) => {
    assert.equal(await page.locator(".steps input").inputValue(), "1");
    assert.equal(await page.getByLabel("Colour", { exact: true }).inputValue(), "height");
    assert.equal(await pixels(page), picture);
  });
  for (const hash of ["#camera=1,2,NaN", "#step=1e9&colour=x&range=5", "#section=1,2&camera=0,0,0,0,0,0,0,0,0", "#%E0%A4%A"])
    await inPage(browser, roomPage, { hash }, async (page) => assert.ok(await canvasOf(page).isVisible()));
});

test("the transform has the forms of other programs, all with the same numbers", () => inPage(browser, roomPage, {}, async (page) => {
  const textOf = async (form) => { await page.getByLabel("Form").selectOption(form); return page.locator("#matrix").innerText(); };
  const transform = join(folder, "T.txt");
  spawnSync(augicp, ["align", ...room, "--transform", transform, "--quiet"]);
  const numbers = readFileSync(transform, "utf8").split("\n").filter((line) => !line.startsWith("#")).join(" ").trim().split(/\s+/).map(Number);
  const near = (found, expected, tolerance = 1e-8) => { assert.equal(found.length, expected.length); found.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < tolerance, `${value} ${expected[i]}`)); };
  near((await textOf("CloudCompare")).trim().split(/\s+/).map(Number), numbers);
  near(JSON.parse(await textOf("PDAL")).pipeline[1].matrix.split(" ").map(Number), numbers);
  const python = spawnSync("python3", ["-c", (await textOf("Python")).replace("import numpy as np", "class np:\n array = staticmethod(list)").split("\npoints_in_target")[0] + "\nprint(*sum(T_target_source, []))"], { encoding: "utf8" });
  near(python.stdout.trim().split(/\s+/).map(Number), numbers);
  near((await textOf("C++")).match(/<<([^;]*);/)[1].split(",").map(Number), numbers);
  const ros = Object.fromEntries([...(await textOf("ROS 2")).matchAll(/--(q?[xyzw]) (\S+)/g)].map(([, key, value]) => [key, Number(value)]));
  near([ros.x, ros.y, ros.z], [numbers[3], numbers[7], numbers[11]]);
  const { qx, qy, qz, qw } = ros;
  near([1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy - qz * qw), 2 * (qx * qz + qy * qw)], numbers.slice(0, 3));
  near([2 * (qx * qz - qy * qw), 2 * (qy * qz + qx * qw), 1 - 2 * (qx * qx + qy * qy)], numbers.slice(8, 11));
}));

test("on paper there is an image of the view, and no controls", () => inPage(browser, roomPage, {}, async (page) => {
  await page.evaluate(() => window.dispatchEvent(new window.Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.locator(".printed").isVisible());
  for (const part of [".tools", ".steps", ".copy"]) assert.ok(!(await page.locator(part).first().isVisible()), part);
  assert.ok((await page.locator(".printed").getAttribute("src")).length > 20000);
}));

test("on a phone nothing is cut, what scrolls shows it, and numbers keep their units", () => inPage(browser, roomPage, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, async (page) => {
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  const matrix = page.locator("#matrix");
  assert.ok(await matrix.evaluate((pre) => pre.scrollWidth > pre.clientWidth && window.getComputedStyle(pre).backgroundImage.includes("radial-gradient")));
  for (const value of await page.locator("dd").all())
    assert.ok(await value.evaluate((dd) => {
      const text = dd.firstChild;
      return [...text.data.matchAll(/\u00a0/g)].every(({ index }) => {
        const range = document.createRange();
        range.setStart(text, Math.max(0, index - 1));
        range.setEnd(text, Math.min(text.length, index + 2));
        return new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size === 1;
      });
    }), await value.innerText());
}));

test("without WebGL the page says what is missing and why", () => inPage(browser, roomPage, { withoutWebGl: true }, async (page) => {
  assert.match(await page.locator(".notice").innerText(), /The clouds cannot be drawn: this browser has no WebGL 2[\s\S]*Everything else/);
  await page.getByTitle("First (Home)").click();
  assert.equal(await page.locator(".steps input").inputValue(), "0");
  assert.ok(await page.locator(".uplot").first().isVisible());
}));

test("many points: fewer while the view moves, all at rest", () => {
  const points = Array.from({ length: 150000 }, (_, i) => { const [u, v] = [(i % 500) / 100, Math.floor(i / 500) / 100]; return `${u} ${v} ${(0.3 * Math.sin(u) * Math.cos(2 * v)).toFixed(4)}`; });
  writeFileSync(join(folder, "many.xyz"), points.join("\n"));
  const file = report("many.html", ["align", "many.xyz", "many.xyz", "--voxel-size", "0.002", "--radius", "0.04"], { codes: [0, 4, 5] });
  return inPage(browser, file, { viewport: { width: 700, height: 500 } }, async (page) => {
    const { x, y } = await canvasOf(page).boundingBox();
    await page.mouse.move(x + 200, y + 100);
    await page.mouse.down();
    await page.mouse.move(x + 230, y + 110, { steps: 3 });
    await settled(page);
    const moving = await pixels(page);
    await page.mouse.up();
    assert.notEqual(await pixels(page), moving);
  });
});
