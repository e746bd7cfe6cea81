// SPDX-License-Identifier: MIT
// The examples of the package's README print the output in their comments.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { inspect } from "node:util";

import { packageFolder } from "./native.mjs";

const page = readFileSync(join(packageFolder, "README.md"), "utf8");
const examples = [...page.matchAll(/^## (.*)$|^```js\n([^]*?)^```$/gm)];

let heading = "the beginning";
for (const [, title, code] of examples) {
  if (title) {
    heading = title;
    continue;
  }
  test(`README, ${heading}: the output equals the comments`, async (context) => {
    const folder = mkdtempSync(join(tmpdir(), "graze-readme-"));
    context.after(() => rmSync(folder, { recursive: true }));
    const file = join(folder, "example.mjs");
    writeFileSync(file, code.replace('"graze"', JSON.stringify(join(packageFolder, "graze.js"))));
    const printed = [];
    context.mock.method(console, "log", (value) => printed.push(typeof value === "string" ? value : inspect(value)));
    await import(file);
    assert.deepEqual(printed, [...code.matchAll(/^console\.log.*\/\/ (.*)$/gm)].map((match) => match[1]));
    assert.ok(printed.length > 0);
  });
}
