// SPDX-License-Identifier: MIT
// The reports as their readers meet them: see reports.mjs for the arguments.
import assert from "node:assert/strict";
import { copyFileSync, mkdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { changes, inPage, settled } from "./browser.mjs";
import { browserForTests, folder, hasScript as isWithScript, plainAugicp, report, room, sequence as desk } from "./reports.mjs";

const browser = await browserForTests();
const alignment = report("align.html", ["align", ...room]);
const hasScript = isWithScript(alignment);

if (hasScript) {
  test("alignment: the slider moves the source, by mouse and by keys", () => inPage(browser, alignment, {}, async (page) => {
    const slider = page.locator(".steps input[type=range]");
    const last = await slider.inputValue();
    assert.ok(Number(last) >= 2);
    assert.ok(!(await changes(page, () => settled(page))), "nothing changes by itself");
    assert.ok(await changes(page, () => page.keyboard.press("Home")));
    assert.equal(await slider.inputValue(), "0");
    assert.ok(await changes(page, () => page.keyboard.press("ArrowRight")));
    assert.equal(await slider.inputValue(), "1");
    assert.ok(await changes(page, () => slider.fill("0")));
    await page.getByTitle("Last (End)").click();
    assert.equal(await slider.inputValue(), last);
    assert.match(await page.locator("output").innerText(), /Iteration \d+ of \d+: \d+ correspondences/);
  }));

  test("alignment: every toggle changes the picture", () => inPage(browser, alignment, {}, async (page) => {
    for (const name of ["Target", "Source", "Correspondences", "Normals, tangents", "Grid"]) {
      const toggle = page.getByRole("button", { name, exact: true });
      const before = await toggle.getAttribute("aria-pressed");
      assert.ok(await changes(page, () => toggle.click()), name);
      assert.notEqual(await toggle.getAttribute("aria-pressed"), before);
      assert.ok(await changes(page, () => toggle.click()), `${name}, back`);
    }
    assert.equal(await page.getByRole("button", { name: "Free motions" }).count(), 0);
  }));

  test("alignment: the view turns by keys and the mouse; charts show values and set the step", () => inPage(browser, alignment, {}, async (page) => {
    const canvas = page.locator(".view > canvas");
    await canvas.focus();
    const step = await page.locator(".steps input[type=range]").inputValue();
    assert.ok(await changes(page, () => page.keyboard.press("ArrowLeft")));
    assert.ok(await changes(page, () => page.keyboard.press("+")));
    assert.equal(await page.locator(".steps input[type=range]").inputValue(), step);
    const box = await canvas.boundingBox();
    assert.ok(await changes(page, async () => {
      await page.mouse.move(box.x + 200, box.y + 200);
      await page.mouse.down();
      await page.mouse.move(box.x + 260, box.y + 220, { steps: 4 });
      await page.mouse.up();
    }));
    const chart = page.locator("figure .u-over").first();
    await chart.scrollIntoViewIfNeeded();
    await chart.click({ position: { x: 4, y: 20 } });
    assert.match(await page.locator(".tooltip:visible").innerText(), /iteration: 1\s+cost: \d/);
    assert.equal(await page.locator(".steps input[type=range]").inputValue(), "1");
  }));

  test("alignment: readable in the dark and on a telephone", async () => {
    for (const options of [{ colorScheme: "dark" }, { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true }])
      await inPage(browser, alignment, options, async (page) => {
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
        const [text, ground] = await page.evaluate(() => {
          const style = window.getComputedStyle(document.body);
          return [style.color, style.backgroundColor].map((colour) => colour.match(/\d+/g).slice(0, 3).reduce((sum, part) => sum + Number(part), 0));
        });
        assert.ok(Math.abs(text - ground) > 400);
      });
  });

  test("a wall: what is free has arrows", () => {
    const wall = (z) => Array.from({ length: 3600 }, (_, i) => `${(i % 60) / 20} ${Math.floor(i / 60) / 20} ${z}`).join("\n");
    writeFileSync(join(folder, "wall_a.xyz"), wall(2));
    writeFileSync(join(folder, "wall_b.xyz"), wall(2.01));
    const file = report("wall.html", ["align", "wall_b.xyz", "wall_a.xyz"], { codes: [5] });
    return inPage(browser, file, {}, async (page) => {
      assert.equal(await page.locator(".badge").innerText(), "degenerate");
      assert.match(await page.locator("main").innerText(), /Free: translation along/);
      assert.ok(await changes(page, () => page.getByRole("button", { name: "Free motions" }).click()));
    });
  });

  test("odometry: the frame is chosen by slider, strip and chart", () => {
    const file = report("odometry.html", ["odometry", desk, "--camera", "tum-fr1", "--output", join(folder, "odometry")]);
    return inPage(browser, file, {}, async (page) => {
      const slider = page.locator(".steps input[type=range]");
      assert.ok(await changes(page, () => page.keyboard.press("Home")));
      assert.ok(await changes(page, () => page.keyboard.press("End"), ".depth canvas"));
      await page.locator("svg.strip").click({ position: { x: 3, y: 10 } });
      assert.equal(await slider.inputValue(), "0");
      assert.ok(await changes(page, () => page.keyboard.press("End"), "g.marker circle"));
      assert.ok(await changes(page, () => page.getByRole("button", { name: "Top" }).click()));
      assert.ok(await changes(page, () => page.getByRole("button", { name: "Local model" }).click()));
      await page.locator("figure[data-chart] .u-over").first().click({ position: { x: 5, y: 30 } });
      assert.ok(Number(await slider.inputValue()) < 3);
      assert.equal(await page.locator("table tbody tr").count(), 4);
    });
  });

  test("odometry: one frame, or one that was lost, is no error", () => {
    const file = report("one.html", ["odometry", desk, "--camera", "tum-fr1", "--last", "1", "--output", join(folder, "one")]);
    return inPage(browser, file, {}, async (page) => { assert.match(await page.locator("output").innerText(), /Frame 0.*started/); });
  });

  test("experiment: curves have values at the pointer, quantities can be chosen", () => {
    const file = report("synthetic.html", ["experiment", "synthetic", "--points", "2000", "--seeds", "2", "--iterations", "5",
      "--outliers-percent", "0,50", "--point-noise", "0.01", "--output", join(folder, "synthetic.csv")]);
    return inPage(browser, file, {}, async (page) => {
      assert.equal(await page.locator("figure:visible .uplot").count(), 6);
      await page.locator(".u-over").first().hover({ position: { x: 100, y: 50 } });
      assert.match(await page.locator(".tooltip:visible").innerText(), /iteration: \d\s+.*augmented: [\d.e-]+/s);
      await page.getByRole("button", { name: "Quantity: Rotation" }).or(page.getByTitle(/Rotation error/)).first().click();
      assert.match(await page.locator("section:visible h2").first().innerText(), /Rotation/);
    });
  });
}

test("hostile names stay text", () => {
  mkdirSync(join(folder, "<"));
  const names = ["<script>alert(1)<script>.ply", "</script>.ply", "\"'><img src=x onerror=alert(1)>&amp;\u2028.ply", "--><!--<script>\u{1F642}.ply"];
  return names.reduce(async (before, name, index) => {
    await before;
    copyFileSync(room[0], join(folder, name));
    const file = report(`hostile${index}.html`, ["align", "--source", `./${name}`, "--target", room[1]]);
    await inPage(browser, file, {}, async (page) => {
      assert.ok((await page.locator("header").evaluate((header) => header.textContent)).includes(name));
      assert.equal(await page.locator("img").count(), 0);
      assert.equal(await page.locator("script").count(), hasScript ? 2 : 0);
    });
  }, Promise.resolve());
});

test("little or nothing to draw is no error", async () => {
  writeFileSync(join(folder, "one.xyz"), "1 2 3\n");
  writeFileSync(join(folder, "same.xyz"), "1 2 3\n".repeat(5000));
  writeFileSync(join(folder, "huge.xyz"), Array.from({ length: 500 }, (_, i) => `${i}e30 ${i * i}e30 ${i % 7}e30`).join("\n"));
  for (const name of ["one.xyz", "same.xyz", "huge.xyz"])
    for (const pair of [[name, room[1]], [name, name]]) {
      const file = report("odd.html", ["align", ...pair], { codes: [0, 4, 5] });
      await inPage(browser, file, {}, async (page) => { assert.ok(await page.locator("#matrix").isVisible()); });
    }
});

test("without scripts there are curves and tables", async () => {
  const files = [alignment, report("plain.html", ["align", ...room], { program: plainAugicp })];
  assert.ok(!readFileSync(files[1], "utf8").includes("<script"));
  assert.ok(statSync(files[1]).size < 1e5);
  for (const file of files)
    await inPage(browser, file, { javaScriptEnabled: false }, async (page) => {
      assert.equal(await page.locator("figure svg path.curve").count(), 4);
      assert.ok(await page.locator("dl").first().isVisible());
      assert.ok(!(await page.locator("#stage").isVisible()));
      assert.match(await page.locator(".notice").innerText(), /No 3D view: .*script/);
    });
});
