// SPDX-License-Identifier: MIT
// Shared by the tests of the viewer: the built page, served on this machine, a browser, and the program graze.
import { execFileSync } from "node:child_process";
import { existsSync, statSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";

import { chromium } from "playwright-core";

export const root = fileURLToPath(new URL("../../", import.meta.url));
export const viewer = `${root}build/web/viewer/`;

const browserProgram = process.env.GRAZE_BROWSER ?? "/usr/bin/chromium";
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };

/** The program to compare with: $GRAZE_PROGRAM, otherwise the most recently built one. */
export function program() {
  const named = process.env.GRAZE_PROGRAM;
  const places = named === undefined ? ["release", "gcc", "debug"].map((name) => `${root}build/${name}/bin/graze`) : [named];
  const built = places.filter((place) => existsSync(place)).sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs);
  const [found] = built;
  if (found === undefined) throw new Error("build the program first, or name it in GRAZE_PROGRAM");
  return found;
}

/** The standard output of the program. */
export function graze(...options) {
  const env = { ...process.env, GRAZE_REPORT_TEMPLATE: `${viewer}report.html` };
  return execFileSync(program(), options, { encoding: "utf8", env, maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] });
}

/** Serves the built viewer; `address` ends in a slash. */
export async function serveViewer() {
  const server = createServer(async (request, response) => {
    const path = request.url === "/" ? "/index.html" : new URL(request.url, "http://localhost").pathname;
    try {
      const content = await readFile(`${viewer}${path.slice(1)}`);
      response.writeHead(200, { "Content-Type": types[extname(path)] ?? "application/octet-stream" }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export function openBrowser() {
  return chromium.launch({
    executablePath: browserProgram,
    args: [
      "--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic",
      "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
    ],
  });
}

/** A page whose errors and requests are recorded. */
export async function openPage(browser, address, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1000, height: 640 }, colorScheme: "light", ...options });
  const heard = { complaints: [], requests: [] };
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) heard.complaints.push(message.text());
  });
  page.on("pageerror", (error) => heard.complaints.push(String(error)));
  page.on("request", (request) => heard.requests.push(request.url()));
  await page.goto(address);
  await page.waitForSelector("html[data-chapter]", { timeout: 60_000 });
  return { page, heard };
}

/** The text of a figure in the panel. */
export function figure(page, id) {
  return page.locator(`#figure-${id}`).textContent();
}

/** An integer as the page shows it, with thin spaces. */
export async function numberIn(page, id) {
  return Number((await figure(page, id)).replaceAll(/\s/g, ""));
}

/** The position of an overlay handle on the page. */
export async function placeOf(page, key) {
  const box = await page.locator(`#overlay circle[data-key="${key}"]`).boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

export async function drag(page, from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2);
  await page.mouse.move(to.x, to.y);
  await page.mouse.up();
}

/** The colour of a pixel of the page: red, green, blue. */
export async function colourAt(page, { x, y }) {
  const picture = (await page.screenshot({ clip: { x, y, width: 1, height: 1 } })).toString("base64");
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d");
    context.drawImage(image, 0, 0);
    return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
  }, picture);
}
