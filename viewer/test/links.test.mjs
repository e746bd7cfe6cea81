// SPDX-License-Identifier: MIT
// The cookbook's links to the viewer: each names a tab, and opening it shows the state in the link.
import assert from "node:assert/strict";
import { readdir, readFile } from "node:fs/promises";
import { after, before, test } from "node:test";

import { openBrowser, openPage, root, serveViewer } from "./browser.mjs";

let browser, server;
before(async () => {
  [browser, server] = await Promise.all([openBrowser(), serveViewer()]);
});
after(async () => {
  await browser?.close();
  server?.close();
});

/** The links of the cookbook, as [page, text after the address of the viewer]. */
async function links() {
  const folder = `${root}docs/cookbook/`;
  const found = [];
  for (const name of await readdir(folder)) {
    const text = await readFile(`${folder}${name}`, "utf8");
    for (const [, hash] of text.matchAll(/\(\.\.\/\.\.\/viewer\/index\.html(#[^)\s]*)\)/g)) found.push([name, hash]);
  }
  return found;
}

/** The content of an address: the tab, and for each parameter its words and numbers, independent of their notation. */
function saidBy(hash) {
  const [tab, query = ""] = hash.slice(1).split("?");
  const parameters = [...new URLSearchParams(query)].map(([name, text]) => {
    const parts = text.split(/([,;:|])/).map((part) => (part.trim() === "" || Number.isNaN(Number(part)) ? part : Number(part)));
    return [name, name === "show" ? text.split(",").sort().join() : parts.join("")];
  });
  return { tab, parameters: new Map(parameters) };
}

test("every link of the cookbook opens its tab, whose address then has the same content", async () => {
  const all = await links();
  assert.ok(all.length >= 30);
  const { page, heard } = await openPage(browser, server.address);
  await page.evaluate(() => {
    window.written = [];
    const replace = history.replaceState.bind(history);
    history.replaceState = (state, title, address) => {
      window.written.push(String(address));
      replace(state, title, address);
    };
  });
  for (const [name, hash] of all) {
    const wanted = saidBy(hash);
    await page.evaluate((next) => {
      window.written.length = 0;
      location.hash = next;
    }, hash);
    await page.waitForFunction((tab) => window.written.some((address) => address.startsWith(`#${tab}`)), wanted.tab);
    const shown = saidBy(await page.evaluate(() => window.written.at(-1)));
    assert.equal(shown.tab, wanted.tab, name);
    for (const [parameter, value] of wanted.parameters) assert.equal(shown.parameters.get(parameter), value, `${name}: ${parameter}`);
  }
  assert.deepEqual(heard.complaints, []);
  await page.close();
});
