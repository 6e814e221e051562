// SPDX-License-Identifier: MIT
// Several estimates over the ground truth: each in the views, in the curves and in the table.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { changes, inPage } from "./browser.mjs";
import { cutTables, ink } from "./picture.mjs";
import { augicp, browserForTests, folder, hasScript, plainAugicp, report, sequence } from "./reports.mjs";

const browser = await browserForTests();
const truth = join(sequence, "groundtruth.txt");
const run = (name, options) => {
  const done = spawnSync(augicp, ["odometry", sequence, "--camera", "tum-fr1", "--output", name, "--quiet", ...options], { cwd: folder, encoding: "utf8" });
  assert.equal(done.status, 0, done.stderr);
  return `${name}/trajectory.txt`;
};
const every = run("every", []), second = run("second", ["--every", "2"]);
// Off by two metres along x from the middle of its time: no alignment hides that.
const posesIn = (file) => readFileSync(file, "utf8").split("\n").filter((line) => line !== "" && !line.startsWith("#")).map((line) => line.split(" "));
const tracked = posesIn(join(folder, every));
const lines = posesIn(truth).filter(([t]) => Number(t) >= Number(tracked[0][0]) && Number(t) <= Number(tracked.at(-1)[0]));
const jump = "jump <b>.txt";
writeFileSync(join(folder, jump), lines.map(([t, x, ...rest], i) => [t, 2 * i < lines.length ? x : Number(x) + 2, ...rest].join(" ")).join("\n"));
const options = ["evaluate", every, truth, "--beside", second, jump, "--quiet"];
const page = report("runs.html", options);
const plain = report("plain.html", options, { program: plainAugicp });

test("every trajectory fills the first view, and can be hidden", () => inPage(browser, page, {}, async (shown) => {
  const press = (name) => shown.getByRole("button", { name, exact: true }).click();
  await press("Grid");
  const seen = await ink(shown);
  assert.ok(seen.left > 0 && seen.right < 1 && seen.top > 0 && seen.bottom < 1, JSON.stringify(seen));
  assert.ok(Math.max(seen.right - seen.left, seen.bottom - seen.top) > 0.6, JSON.stringify(seen));
  for (const name of [every, second, jump, "ground truth"]) assert.ok(await changes(shown, () => press(name)), name);
  assert.ok((await ink(shown)).share < seen.share / 2);
  assert.ok(await changes(shown, async () => { await press("ground truth"); await shown.getByRole("button", { name: "Top", exact: true }).click(); }));
}));

test("curves show each estimate's error at the pointer", () => inPage(browser, page, {}, async (shown) => {
  const plot = shown.locator(".plot").first();
  const { width, height } = await plot.boundingBox();
  const errorsAt = async (share) => {
    await plot.hover({ position: { x: 70 + share * (width - 80), y: height / 2 } });
    return (await shown.locator(".tooltip").first().innerText()).split("\n").slice(1).map((line) => Number(line.split(": ").at(-1)));
  };
  for (const share of [0.2, 0.8]) {
    const errors = await errorsAt(share);
    assert.equal(errors.length, 3);
    assert.ok(errors[0] < 0.03 && errors[1] < 0.03 && errors[2] > 0.1, `${errors}`);
  }
}));

test("without a script the page has table, curves and the view from above", () => inPage(browser, plain, {}, async (shown) => {
  assert.ok(!hasScript(plain));
  const text = await shown.locator("body").innerText();
  for (const name of [every, second, jump, "ground truth"]) assert.ok(text.includes(name), name);
  assert.match(text, /No 3D view/);
  assert.equal(await shown.locator("svg path.curve.s2").count() > 0, true);
}));

test("errors without alignment are a column only where an estimate is in the frame of the truth", async () => {
  const headings = (shown) => shown.locator("th").allInnerTexts();
  const elsewhere = report("elsewhere.html", ["evaluate", every, truth, "--beside", second, "--quiet"]);
  await inPage(browser, page, {}, async (shown) => assert.ok((await headings(shown)).includes("not aligned")));
  await inPage(browser, elsewhere, {}, async (shown) => assert.ok(!(await headings(shown)).includes("not aligned")));
});

test("the table is whole beside the picture, and a number keeps its unit", () => inPage(browser, page, { viewport: { width: 1280, height: 720 } }, async (shown) => {
  assert.deepEqual(await cutTables(shown), []);
  const texts = await shown.locator("tbody td").allTextContents();
  assert.ok(texts.some((text) => /\d\u00a0m, /.test(text)), `${texts}`);
}));
