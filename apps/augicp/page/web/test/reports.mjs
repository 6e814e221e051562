// SPDX-License-Identifier: MIT
// Reports that the command writes for a test, in a folder that is removed after it.
//
//   node SOME_test.mjs AUGICP AUGICP_WITHOUT_SCRIPT PROJECT
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";
import { launch } from "./browser.mjs";

export const [augicp, plainAugicp, project] = process.argv.slice(2);
export const folder = mkdtempSync(join(tmpdir(), "augicp report "));
const desk = join(project, "data/tum_fr1_desk_30");
export const images = ["1305031455.374120.png", "1305031455.210307.png"].map((name) => join(desk, "depth", name));
export const room = ["source.ply", "target.ply"].map((name) => join(project, "data/room_pair", name));
export const sequence = desk;
const kLargest = 15e6; // bytes

export function report(name, words, { program = augicp, codes = [0] } = {}) {
  const file = join(folder, name);
  const done = spawnSync(program, [...words, "--report", file], { encoding: "utf8", cwd: folder });
  assert.ok(codes.includes(done.status), `${words}: ${done.status} ${done.stderr}`);
  assert.ok(statSync(file).size < kLargest, `${name}: ${statSync(file).size} bytes`);
  return file;
}

// The report of a cloud on itself.
export function ofItself(name, text) {
  const cloud = join(folder, `${name}.xyz`);
  writeFileSync(cloud, text);
  return report(`${name}.html`, ["align", cloud, cloud], { codes: [0, 4, 5] });
}

export const hasScript = (file) => readFileSync(file, "utf8").includes("<script");

// A browser for the tests of a file. Where the command has no script, the file is skipped by its first line.
export async function browserForTests() {
  const browser = await launch();
  after(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
  });
  return browser;
}
