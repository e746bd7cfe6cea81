// SPDX-License-Identifier: MIT
// Makes build/web/viewer/report.html of the built viewer: one page with styles, scripts and WebAssembly inlined, which opens
// from disk, and an empty element for the data that `graze view` fills in.
import { readFile, readdir, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const folder = fileURLToPath(new URL("../build/web/viewer/", import.meta.url));

/** The one file among the assets that ends so. */
async function asset(ending) {
  const found = (await readdir(`${folder}assets`)).filter((name) => name.endsWith(ending));
  if (found.length !== 1) throw new Error(`one asset should end in ${ending}, but there are: ${found.join(", ")}`);
  return readFile(`${folder}assets/${found[0]}`);
}

/** Replaces exactly one piece of the page; what is put in is taken as it is. */
function replaced(page, pattern, text) {
  const count = [...page.matchAll(new RegExp(pattern, "g"))].length;
  if (count !== 1) throw new Error(`${pattern} should be in index.html once, but is ${count} times`);
  return page.replace(pattern, () => text);
}

// Within a script only these would be read as HTML; in JavaScript they can only stand in strings and patterns.
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
