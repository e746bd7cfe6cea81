// SPDX-License-Identifier: MIT
// The package as packed by npm, and used in a Vite project.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { packageFolder, root } from "./native.mjs";

let folder;

before(() => {
  folder = mkdtempSync(join(tmpdir(), "graze-package-"));
});
after(() => rmSync(folder, { recursive: true }));

const run = (program, args, cwd) => execFileSync(program, args, { cwd, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

const pack = () => JSON.parse(run("npm", ["pack", "--json", "--pack-destination", folder], packageFolder))[0];

test("npm packs the module, its types, its page and its licence, and nothing else", () => {
  const packed = pack();
  assert.equal(packed.name, "graze");
  assert.deepEqual(packed.files.map(({ path }) => path).sort(), [
    "LICENSE", "README.md", "arguments.js", "casts.js", "core.js", "graze.d.ts", "graze.js", "graze_wasm.js", "graze_wasm.wasm", "indexes.js",
    "meshes.js", "options.js", "package.json", "pairs.js", "queries.js", "recordings.js", "scene.js", "scene_queries.js", "text.js",
  ]);
});

test("the package has the version of the library", () => {
  const version = /project\(graze VERSION (\S+)/.exec(readFileSync(join(root, "CMakeLists.txt"), "utf8"))[1];
  assert.equal(JSON.parse(readFileSync(join(packageFolder, "package.json"))).version, version);
});

test("a Vite project of five lines can use it", async () => {
  const { filename } = pack();
  const project = join(folder, "project");
  cpSync(fileURLToPath(new URL("vite", import.meta.url)), project, { recursive: true });
  run("npm", ["install", "--no-save", "--no-package-lock", "--no-audit", "--no-fund", join(folder, filename)], project);
  run("npx", ["vite", "build", "--logLevel", "warn"], project);
  const assets = join(project, "dist/assets");
  const built = readdirSync(assets);
  const wasm = built.find((name) => name.endsWith(".wasm"));
  assert.ok(wasm, `no module among ${built}`);
  assert.deepEqual(readFileSync(join(assets, wasm)), readFileSync(join(packageFolder, "graze_wasm.wasm")));
  await import(join(assets, built.find((name) => name.endsWith(".js"))));
  assert.equal(globalThis.answer, 2);
});
