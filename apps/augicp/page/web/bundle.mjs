// SPDX-License-Identifier: MIT
// One script from src/ and the packages it uses, with their licences in front, and its hash for the page's policy:
//
//   node bundle.mjs FOLDER     writes report.js and report.js.sha256
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = fileURLToPath(new URL(".", import.meta.url));
const folder = process.argv[2] ?? ".";
const packages = Object.entries(JSON.parse(readFileSync(join(here, "package.json"), "utf8")).dependencies);
const licence = ([name, version]) =>
  `${name} ${version}\n\n${readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim()}\n`;

const result = await build({
  absWorkingDir: here,
  entryPoints: ["src/main.ts"],
  bundle: true,
  minify: true,
  charset: "ascii",
  format: "iife",
  target: "es2022",
  loader: { ".css": "text" },
  legalComments: "inline",
  banner: { js: `/*!\nThis script contains:\n\n${packages.map(licence).join("\n")}*/` },
  write: false,
});
// A script element ends where this word stands, in a string or a comment too.
const script = result.outputFiles[0].text.replace(/<(?=\/script|!--)/gi, "\\x3c");
mkdirSync(folder, { recursive: true });
writeFileSync(join(folder, "report.js"), script);
writeFileSync(join(folder, "report.js.sha256"), createHash("sha256").update(script).digest("base64"));
