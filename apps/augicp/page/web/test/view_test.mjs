// SPDX-License-Identifier: MIT
// The first view, and the ways around it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { changes, inPage, pixels, settled } from "./browser.mjs";
import { ink } from "./picture.mjs";
import { browserForTests, images, ofItself, report, room } from "./reports.mjs";
import { asText, floorAndPole, kFloorSide, seenByCamera, tilted } from "./scenes.mjs";

const browser = await browserForTests();
const roomPage = report("room.html", ["align", ...room]);
const kPhone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const hideGrid = (page) => page.getByRole("button", { name: "Grid" }).click();

for (const [name, file] of [["a room", roomPage], ["depth images", report("depth.html", ["align", ...images, "--camera", "tum-fr1"])]])
  for (const [screen, options] of [["wide screen", {}], ["phone", kPhone]])
    test(`${name} on a ${screen}: all is in the first view, and fills it`, () => inPage(browser, file, options, async (page) => {
      await hideGrid(page);
      const seen = await ink(page);
      assert.ok(seen.left > 0.005 && seen.right < 0.995 && seen.top > 0.005 && seen.bottom < 0.995, JSON.stringify(seen));
      assert.ok(Math.max(seen.right - seen.left, seen.bottom - seen.top) > 0.85, JSON.stringify(seen));
    }));

for (const [name, points, floor] of [
  ["a scanner's frame, z up", floorAndPole(), true],
  ["a scanner that leans by 20 degrees", tilted(floorAndPole(), 0.35), true],
  ["a camera that looks ahead", seenByCamera(floorAndPole(), 0.1), true],
  ["a camera that looks down by 35 degrees", seenByCamera(floorAndPole(), 0.6), true],
  ["no floor, only a pole", floorAndPole().slice(kFloorSide ** 2), false],
])
  test(`up is up: ${name}`, () => inPage(browser, ofItself(name.replaceAll(/\W/g, "_"), asText(points)), {}, async (page) => {
    await hideGrid(page);
    const seen = await ink(page);
    assert.ok(Math.abs(seen.topX - seen.upperX) < 0.02, JSON.stringify(seen));
    assert.equal(await page.getByLabel("Up", { exact: true }).evaluate((list) => list.options[0].text), floor ? "floor" : "z");
  }));

test("another axis may be up; a double click shows all again", () => inPage(browser, roomPage, {}, async (page) => {
  const canvas = page.locator(".view > canvas");
  const first = await pixels(page);
  assert.ok(await changes(page, () => page.getByLabel("Up", { exact: true }).selectOption("x")));
  await page.getByLabel("Up", { exact: true }).selectOption("floor");
  assert.equal(await pixels(page), first);
  await canvas.focus();
  for (const key of ["ArrowLeft", "Shift+ArrowUp", "+", "ArrowDown"]) assert.ok(await changes(page, () => page.keyboard.press(key)), key);
  await canvas.dblclick({ position: { x: 30, y: 30 } });
  await canvas.blur();
  assert.equal(await pixels(page), first);
}));

test("the wheel scrolls the page until the picture has the focus", () => inPage(browser, roomPage, { viewport: { width: 800, height: 500 } }, async (page) => {
  const canvas = page.locator(".view > canvas");
  const scrolled = () => page.evaluate(() => window.scrollY);
  const turnWheel = async () => {
    const { x, y } = await canvas.boundingBox();
    await page.mouse.move(x + 200, y + 100);
    await page.mouse.wheel(0, 60);
    await settled(page);
  };
  await turnWheel();
  const after = await scrolled();
  assert.ok(after > 0);
  assert.ok(await page.getByText("Click the picture to zoom").isVisible());
  await canvas.focus();
  const focused = await scrolled();
  assert.ok(await changes(page, turnWheel));
  assert.equal(await scrolled(), focused);
}));

test("a finger scrolls the page until the picture was tapped", () => inPage(browser, roomPage, kPhone, async (page) => {
  const canvas = page.locator(".view > canvas");
  const action = () => canvas.evaluate((element) => window.getComputedStyle(element).touchAction);
  assert.equal(await action(), "pan-y");
  await canvas.tap();
  assert.equal(await action(), "none");
}));

// At a size at which one step of zooming keeps the bar's length a round number of metres.
test("grid, axes and scale bar follow the view", () => inPage(browser, roomPage, { viewport: { width: 1280, height: 720 } }, async (page) => {
  assert.ok(await changes(page, () => hideGrid(page)));
  const length = () => page.locator(".scale-bar").evaluate((bar) => [parseFloat(bar.querySelector("i").style.width), bar.innerText.trim()]);
  const [width, text] = await length();
  const canvas = page.locator(".view > canvas");
  await canvas.focus();
  await page.keyboard.press("+");
  await settled(page);
  const [wider, same] = await length();
  assert.equal(text, same);
  assert.ok(Math.abs(wider / width - 1 / 0.9) < 1e-3, `${wider} ${width}`);
  assert.ok(await changes(page, () => page.locator(".gizmo .z").press("Enter")));
  const places = await page.locator(".gizmo circle").evaluateAll((discs) => discs.map((disc) => Math.hypot(disc.getAttribute("cx"), disc.getAttribute("cy"))));
  assert.ok(Math.min(...places) < 0.5, "the axis points at the eye");
}));
