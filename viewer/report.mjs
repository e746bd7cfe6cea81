// SPDX-License-Identifier: MIT
// Creates build/web/viewer/report.html from the built viewer: one page with inlined styles, scripts and WebAssembly,
// which opens from disk, and an empty element for the data that `graze view` inserts.
import { readFile, readdir, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const folder = fileURLToPath(new URL("../build/web/viewer/", import.meta.url));

/** The single asset with this ending. */
async function asset(ending) {
  const found = (await readdir(`${folder}assets`)).filter((name) => name.endsWith(ending));
  if (found.length !== 1) throw new Error(`exactly one asset should end in ${ending}, but found: ${found.join(", ")}`);
  return readFile(`${folder}assets/${found[0]}`);
}

/** Replaces exactly one match in the page; the replacement is inserted literally. */
function replaced(page, pattern, text) {
  const count = [...page.matchAll(new RegExp(pattern, "g"))].length;
  if (count !== 1) throw new Error(`${pattern} should match once in index.html, but matches ${count} times`);
  return page.replace(pattern, () => text);
}

// Only these would be parsed as HTML inside a script; in JavaScript they occur only in strings and patterns.
const script = String(await asset(".js")).replaceAll("</script", "<\\/script").replaceAll("<!--", "\\x3c!--");
const wasm = gzipSync(await asset(".wasm"), { level: 9 }).toString("base64");

let page = await readFile(`${folder}index.html`, "utf8");
page = replaced(page, /<link rel="stylesheet"[^>]*>/, `<style>${await asset(".css")}</style>`);
page = replaced(page, /<script type="module"[^>]*><\/script>/, "");
page = replaced(
  page,
  /<\/body>/,
  `<script type="application/json" id="graze-report"></script>\n` +
    `<script type="text/plain" id="graze-wasm">${wasm}</script>\n<script type="module">${script}</script>\n</body>`,
);
await writeFile(`${folder}report.html`, page);
console.log(`report.html: ${(page.length / 1e6).toFixed(1)} MB`);
