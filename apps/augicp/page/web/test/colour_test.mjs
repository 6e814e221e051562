// SPDX-License-Identifier: MIT
// Colours of points, their legends, and the words beside the numbers.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { changes, inPage } from "./browser.mjs";
import { ink } from "./picture.mjs";
import { browserForTests, folder, images, report, room } from "./reports.mjs";
import { asText, landscape } from "./scenes.mjs";

const browser = await browserForTests();
const pages = { room: report("room.html", ["align", ...room]), depth: report("depth.html", ["align", ...images, "--camera", "tum-fr1"]) };
const kDistance = "distance from the target's surface";
const colour = (page, name) => page.getByLabel("Colour", { exact: true }).selectOption(name);

const kMetres = { km: 1000, m: 1, cm: 0.01, mm: 0.001, "\u00b5m": 1e-6 };
function metres(text) {
  const [, number, unit] = text.match(/(-?[\d.e-]+)\s(km|cm|mm|\u00b5m|m)/);
  return Number(number) * kMetres[unit];
}

for (const [name, file] of Object.entries(pages))
  test(`${name}: distances have the colours of their noise, with units and a histogram`, () => inPage(browser, file, {}, async (page) => {
    assert.ok(await changes(page, () => colour(page, kDistance)));
    const ends = (await page.locator(".range-control .span-end").allInnerTexts()).map(metres);
    assert.equal(ends[0], -ends[1]);
    const median = metres(await page.locator("dl div", { hasText: "Distance from the target" }).locator("dd").innerText());
    assert.ok(ends[1] > 2.5 * median && ends[1] < 15 * median, `${ends} ${median}`);
    const bars = () => page.locator(".range-control canvas").evaluate((canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.filter((_, i) => i % 4 === 3).reduce((sum, alpha) => sum + alpha / 255, 0));
    assert.ok((await bars()) > 500);
    assert.ok(await changes(page, () => page.getByLabel("Colour range, upper end").fill("300")));
    assert.match(await page.locator(".view-legend").innerText(), /grey: no overlap/);
  }));

test("what does not overlap is grey", async () => {
  for (const [name, from] of [["left", 0], ["right", 0.7]]) writeFileSync(join(folder, `${name}.xyz`), asText(landscape(from)));
  const file = report("halves.html", ["align", "left.xyz", "right.xyz"], { codes: [0, 4, 5] });
  await inPage(browser, file, {}, async (page) => {
    for (const name of ["Grid", "Target"]) await page.getByRole("button", { name, exact: true }).click();
    await colour(page, kDistance);
    const { saturation } = await ink(page);
    assert.ok(saturation[0] < 0.12 && saturation[2] > 0.3, `${saturation}`);
    await colour(page, "height");
    assert.ok((await ink(page)).saturation[0] > 0.2, "heights are known everywhere");
  });
});

test("an intensity can be shown if it was compared", async () => {
  const cloud = landscape(0).map(([x, y, z], i) => [x, y, z, i % 97].join(" "));
  const header = `ply\nformat ascii 1.0\nelement vertex ${cloud.length}\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity\nend_header\n`;
  writeFileSync(join(folder, "bright.ply"), `${header}${cloud.join("\n")}\n`);
  await inPage(browser, report("bright.html", ["align", "bright.ply", "bright.ply", "--intensity"]), {}, async (page) => {
    assert.ok(await changes(page, () => colour(page, "intensity")));
    const [low, high] = (await page.locator(".range-control .span-end").allInnerTexts()).map(Number);
    assert.ok(low >= 0 && low < 20 && high > 76 && high <= 97, `${low} ${high}`);
  });
  await inPage(browser, pages.room, {}, async (page) => {
    assert.ok(!(await page.getByLabel("Colour", { exact: true }).locator("option").allInnerTexts()).includes("intensity"));
  });
});

// Two squares, red and blue; what a page shows of them has these colours, and the one without stays grey.
test("the colours of files can be shown", async () => {
  const properties = ["x", "y", "z"].map((name) => `property float ${name}`).concat(["red", "green", "blue"].map((name) => `property uchar ${name}`));
  const write = (name, rgb) => {
    const rows = landscape(0).map((point) => [...point.map((value) => value.toFixed(5)), ...rgb].join(" "));
    writeFileSync(join(folder, name), `ply\nformat ascii 1.0\nelement vertex ${rows.length}\n${properties.join("\n")}\nend_header\n${rows.join("\n")}\n`);
  };
  write("red.ply", [250, 10, 10]);
  write("blue.ply", [10, 10, 250]);
  writeFileSync(join(folder, "bare.xyz"), asText(landscape(0)));
  const shown = async (page, hidden) => {
    for (const name of ["Grid", hidden]) await page.getByRole("button", { name, exact: true }).click();
    await colour(page, "colour of the file");
    return ink(page);
  };
  const files = [report("coloured.html", ["align", "red.ply", "blue.ply"]), report("half.html", ["align", "bare.xyz", "blue.ply"])];
  await inPage(browser, files[0], {}, async (page) => {
    const { mean } = await shown(page, "Target");
    assert.ok(mean[0] > 3 * mean[2], `${mean}`);
  });
  await inPage(browser, files[0], {}, async (page) => {
    const { mean } = await shown(page, "Source");
    assert.ok(mean[2] > 3 * mean[0], `${mean}`);
  });
  await inPage(browser, files[1], {}, async (page) => {
    const { saturation } = await shown(page, "Target");
    assert.ok(saturation[2] < 0.15, `${saturation}`);
    assert.match(await page.locator(".view-legend").innerText(), /grey: no colour/);
  });
  await inPage(browser, pages.room, {}, async (page) => {
    assert.ok(!(await page.getByLabel("Colour", { exact: true }).locator("option").allInnerTexts()).includes("colour of the file"));
  });
});

test("every number has a sentence; no word of the code is left", () => inPage(browser, pages.room, {}, async (page) => {
  const facts = page.locator("section dl").first().locator("div");
  assert.ok((await facts.count()) >= 9);
  for (let i = 0; i < (await facts.count()); ++i) {
    const meaning = facts.nth(i).locator(".meaning");
    assert.ok(!(await meaning.isVisible()));
    await facts.nth(i).locator(".explained").focus();
    assert.ok(await meaning.isVisible());
    assert.match(await meaning.innerText(), /^[A-Z].{20,}\.$/);
  }
  const text = await page.evaluate(() => document.body.textContent.replace(/\{.*\}/s, ""));
  assert.doesNotMatch(text, /strain|partner|kernel K|Pairs/);
}));

test("axes have a zero, or say that they have none", async () => {
  for (const file of Object.values(pages))
    await inPage(browser, file, {}, async (page) => {
      const charts = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).charts);
      assert.ok(charts.length >= 3);
      for (const { title, log_y, y_range, y_label } of charts) {
        assert.ok(log_y || (y_range[0] <= 0 && y_range[1] >= 0), title);
        assert.equal(/logarithmic/.test(y_label), log_y, title);
      }
    });
});
