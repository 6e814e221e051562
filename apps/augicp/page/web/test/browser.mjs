// SPDX-License-Identifier: MIT
// A page in a real browser, watched: what it asks the network for, and what it complains about.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { pathToFileURL } from "node:url";

const kPatience_ms = 120_000; // a busy machine without a graphics card draws slowly
const kSkipped = 77; // as CTest is told
const flags = ["--no-sandbox", "--disable-gpu-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];

function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(kSkipped);
}

export async function launch() {
  const executablePath = [process.env.AUGICP_CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser"].find((path) => path && existsSync(path));
  if (!executablePath) skip("no Chromium; scripts/install-dependencies --browser brings it");
  const { chromium } = await import("playwright-core").catch(() => skip("no playwright-core; scripts/build-report brings it"));
  return chromium.launch({ executablePath, args: flags });
}

// check(page) in a page of its own, with options of the browser's context, the hash of the address, an initScript, and withoutWebGl, of which nothing may be loaded but the file, and no error logged.
export async function inPage(browser, file, options, check) {
  const { hash = "", withoutWebGl = false, initScript = null, ...given } = options;
  // A little wider than where the page puts its parts side by side: without a graphics card the time to draw goes with the pixels.
  const context = await browser.newContext({ viewport: { width: 960, height: 540 }, ...given });
  context.setDefaultTimeout(kPatience_ms);
  const page = await context.newPage();
  const url = pathToFileURL(file).href;
  if (initScript) await page.addInitScript(initScript);
  if (withoutWebGl) await page.addInitScript(() => {
    const { getContext } = window.HTMLCanvasElement.prototype;
    window.HTMLCanvasElement.prototype.getContext = function (kind, ...others) { return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...others); };
  });
  const faults = [];
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) faults.push(message.text()); });
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("dialog", (dialog) => { faults.push(`dialog: ${dialog.message()}`); void dialog.dismiss(); });
  page.on("request", (request) => { if (request.url().split("#")[0] !== url && !/^(data|blob):/.test(request.url())) faults.push(`request: ${request.url()}`); });
  try {
    await page.goto(url + hash);
    if (options.javaScriptEnabled !== false) {
      await page.waitForFunction(() => document.scripts.length === 0 || document.documentElement.classList.contains("ready"));
      await settled(page);
    }
    await check(page);
    // The driver of a graphics card that is a program reports that reading pixels is slow.
    assert.deepEqual(faults.filter((fault) => !fault.includes("GPU stall") && !(withoutWebGl && fault.includes("WebGL"))), []);
  } finally {
    await context.close();
  }
}

// After what was asked for has been drawn.
export function settled(page) {
  return page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 30))); }));
}

export async function pixels(page, selector = ".view > canvas") {
  await settled(page);
  return (await page.locator(selector).first().screenshot()).toString("base64");
}

// Whether an action changes what is drawn.
export async function changes(page, action, selector) {
  const before = await pixels(page, selector);
  await action();
  return before !== (await pixels(page, selector));
}
