// SPDX-License-Identifier: MIT
// Scenes from files, in the viewer and in report pages: the page's counts equal the program's.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { basename } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";

import { drag, figure, graze, numberIn, openBrowser, openPage, placeOf, program, root, serveViewer, viewer } from "./browser.mjs";

let browser, server, folder;
before(async () => {
  [browser, server] = await Promise.all([openBrowser(), serveViewer()]);
  folder = `${await mkdtemp(`${tmpdir()}/graze-viewer-`)}/`;
});
after(async () => {
  await browser?.close();
  server?.close();
  await rm(folder, { recursive: true });
});

const files = {
  workshop: ["workshop.json"],
  level: ["platform_level.tmx", "platform_props.tsx", "platform_tiles.tsx", "templates/coin.tx", "templates/crate.tx", "templates/spike.tx"],
};

async function openScene(paths, body) {
  const { page, heard } = await openPage(browser, `${server.address}#scene`);
  try {
    if (paths.length > 0) {
      await page.setInputFiles("#scene-file", paths);
      await page.waitForFunction((name) => document.querySelector("#figure-source")?.textContent === name, basename(paths[0]));
    }
    await body(page);
    assert.deepEqual(heard.complaints, []);
  } finally {
    await page.close();
  }
}

/** The boxes of a frame of a 2D recording, as a table. */
function tableOf(bytes, frame) {
  const count = bytes.readInt32LE(256);
  const rows = Array.from({ length: count }, (_, i) => {
    const at = 304 + 32 * (frame * count + i);
    return [`b${i}`, ...[0, 4, 16, 20].map((offset) => bytes.readFloatLE(at + offset))].join(",");
  });
  return ["id,min_x,min_y,max_x,max_y", ...rows].join("\n");
}

/** The page's counts equal those of `graze check`. */
async function assertSameCounts(page, path) {
  const report = JSON.parse(graze("check", "--format", "json", path));
  assert.equal(await numberIn(page, "pairs"), report.summary.pairs);
  assert.equal(await numberIn(page, "objects"), report.objects);
  assert.equal(await numberIn(page, "candidates"), report.summary.candidates);
  return report;
}

for (const [name, [scene, ...others]] of Object.entries(files)) {
  test(`the counts of ${scene} are those of the program`, async () => {
    const paths = [scene, ...others].map((file) => `${root}data/${file}`);
    await openScene(paths, async (page) => {
      const report = await assertSameCounts(page, paths[0]);
      const first = page.locator("#pair-list button").first();
      assert.equal(await first.textContent(), `${report.pairs[0].a} · ${report.pairs[0].b}${report.pairs[0].relation}`, name);
    });
  });
}

// The limits are for a busy machine without a GPU.
for (const world of ["2d:brownian:100k", "brownian:100k"]) {
  test(`a hundred thousand boxes, ${world}, open and stay usable, and their counts are those of the program`, { timeout: 240_000 }, async () => {
    const path = `${folder}boxes.csv`;
    graze("generate", world, "--output", path);
    const start = performance.now();
    await openScene([path], async (page) => {
      assert.ok(performance.now() - start < 60_000, `${performance.now() - start} ms`);
      await assertSameCounts(page, path);
      assert.ok((await page.locator("#panel .list button").count()) < 80, "only rows that are seen are in the page");
      await page.evaluate(() => {
        document.querySelector("#zoom-in").click();
        return new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      });
      await page.locator("#search").evaluate((input) => {
        input.value = "b99998";
        input.dispatchEvent(new Event("input"));
      });
      assert.deepEqual(await page.locator('.list[aria-label="Objects"] button').allTextContents(), ["b99998aabb"]);
      await page.locator('.list[aria-label="Objects"] button').evaluate((button) => button.click());
      assert.match(await page.locator("#inspector").textContent(), /^b99998type/);
      assert.ok(performance.now() - start < 120_000, `${performance.now() - start} ms`);
    });
  });
}

test("a recording opens, and every frame has the pairs that the program finds in its boxes", async () => {
  const path = `${folder}moving.aabbs`;
  graze("generate", "2d:brownian:800", "--frames", "4", "--output", path);
  const bytes = await readFile(path);
  await openScene([path], async (page) => {
    assert.equal(await numberIn(page, "objects"), 800);
    const found = [];
    for (const frame of [0, 3, 1]) {
      await page.getByRole("slider", { name: "Frame", exact: true }).fill(String(frame));
      assert.match(await page.locator("#frames").textContent(), new RegExp(`${frame} of 3`));
      await writeFile(`${folder}frame.csv`, tableOf(bytes, frame));
      const { summary } = JSON.parse(graze("check", "--format", "json", `${folder}frame.csv`));
      assert.equal(await numberIn(page, "pairs"), summary.pairs, `frame ${frame}`);
      found.push(summary.pairs);
    }
    assert.ok(new Set(found).size > 1, String(found));
    await page.locator("#canvas").focus();
    await page.keyboard.press(".");
    assert.match(await page.locator("#frames").textContent(), /2 of 3/);
    await page.keyboard.press(",");
    await page.keyboard.press(",");
    assert.equal(await numberIn(page, "pairs"), found[0]);
    await page.getByRole("button", { name: "Play" }).click();
    await page.waitForFunction(() => !document.querySelector("#frames").textContent.includes("0 of 3"));
  });
});

test("a truncated recording is refused with a helpful message", async () => {
  const path = `${folder}cut.aabbs`;
  graze("generate", "2d:brownian:10", "--frames", "3", "--output", path);
  await writeFile(path, (await readFile(path)).subarray(0, 500));
  await openScene([], async (page) => {
    await page.setInputFiles("#scene-file", path);
    await page.locator("#scene-error").waitFor();
    assert.match(await page.locator("#scene-error").textContent(), /^cut\.aabbs: holds 500 bytes, but its header announces 304 bytes and 3 frames of 10/);
    assert.equal(await figure(page, "source"), "workshop.json");
  });
});

test("objects with velocities touch frame by frame as in graze simulate", async () => {
  const lines = graze("simulate", `${root}data/crossing.json`, "--frames", "200").trimEnd().split("\n").map((line) => JSON.parse(line));
  const { page, heard } = await openPage(browser, `${server.address}#scene?example=crossing&frame=169`);
  assert.equal(await numberIn(page, "pairs"), lines[169].touching);
  assert.ok(lines[169].touching > 0);
  const [[a, b]] = lines[169].began;
  assert.ok((await page.locator("#pair-list button").allTextContents()).includes(`${a} · ${b}touching`) ||
    (await page.locator("#pair-list button").allTextContents()).includes(`${a} · ${b}overlapping`), `${a} · ${b}`);
  for (const frame of [0, 54, 200]) {
    await page.getByRole("slider", { name: "Frame", exact: true }).fill(String(frame));
    assert.equal(await numberIn(page, "pairs"), lines[frame].touching, `frame ${frame}`);
  }
  await page.waitForFunction(() => location.hash.includes("frame=200"));
  assert.deepEqual(heard.complaints, []);
  await page.close();
});

test("a pair chosen in the list is selected in the scene, and so is a search result", async () => {
  await openScene([], async (page) => {
    await page.locator("#pair-list button").first().click();
    assert.equal(await page.locator("#inspector").count(), 2);
    await page.fill("#search", "rafter 3");
    await page.getByRole("button", { name: /^rafter 3/ }).first().click();
    assert.match(await page.locator("#inspector").textContent(), /^rafter 3type/);
    await page.keyboard.press("z");
    await page.waitForTimeout(400);
    assert.match(page.url(), /select=rafter\+3/);
  });
});

test("a 3D object is moved, resized and rotated by handles and keys, and its contacts are updated", async () => {
  const path = `${folder}space.json`;
  const objects = [
    { name: "ball", type: "sphere", center: [0, 0, 0], radius: 1 },
    { name: "plank", type: "obb", center: [4, 0, 0], half_extents: [2, 0.5, 0.5] },
  ];
  await writeFile(path, JSON.stringify({ schema: "graze.scene/1", dimension: 3, objects }));
  await openScene([path], async (page) => {
    assert.equal(await numberIn(page, "pairs"), 0);
    await page.getByRole("button", { name: /^ball/ }).first().click();
    const [ball, size] = [await placeOf(page, "move"), await placeOf(page, "size")];
    await drag(page, size, { x: ball.x + 2 * (size.x - ball.x), y: ball.y });
    const radius = async () => Number((await page.locator("#inspector #figure-radius").textContent()));
    assert.ok(Math.abs((await radius()) - 2) < 0.06, String(await radius()));
    assert.equal(await numberIn(page, "pairs"), 1);
    await page.keyboard.press("<");
    assert.ok((await radius()) < 1.95);
    assert.equal(await numberIn(page, "pairs"), 0);

    await page.getByRole("button", { name: /^plank/ }).first().click();
    const axis = () => page.locator("#inspector #figure-axes-1").textContent();
    const [plank, turn, before] = [await placeOf(page, "move"), await placeOf(page, "turn"), await axis()];
    await drag(page, turn, { x: plank.x + 46, y: plank.y });
    assert.notEqual(await axis(), before);
    for (let i = 0; i < 18; ++i) await page.keyboard.press("[");
    await page.locator('#overlay circle[data-key="move"]').focus();
    for (let i = 0; i < 60 && (await numberIn(page, "pairs")) === 0; ++i) await page.keyboard.press("Shift+ArrowLeft");
    const { x } = await placeOf(page, "move");
    assert.ok(x < plank.x, `${x}`);
  });
});

test("an object pressed in the drawing is selected in the list", async () => {
  const path = `${folder}two.json`;
  const box = (name, x) => ({ name, type: "aabb", min: [x, 0], max: [x + 1, 1] });
  await writeFile(path, JSON.stringify({ schema: "graze.scene/1", dimension: 2, objects: [box("left", 0), box("right", 3)] }));
  await openScene([path], async (page) => {
    const stage = await page.locator("#canvas").boundingBox();
    await page.mouse.click(stage.x + stage.width * 0.15, stage.y + stage.height / 2);
    assert.match(await page.locator("#inspector").textContent(), /^lefttype/);
    assert.equal(await page.locator('.list [aria-current="true"]').first().textContent(), "leftaabb");
  });
});

test("objects on a hidden layer are neither listed nor found, and the view zooms to a selection", async () => {
  const path = `${folder}layers.json`;
  const box = (name, x, layer) => ({ name, type: "aabb", min: [x, 0], max: [x + 1, 1], layer });
  const objects = [box("crate", 0, "crates"), box("rock", 0.5, "rocks"), box("far rock", 30, "rocks")];
  const layers = ["crates", "rocks"];
  await writeFile(path, JSON.stringify({ schema: "graze.scene/1", dimension: 2, layers, objects }));
  await openScene([path], async (page) => {
    const listed = () => page.locator("#object-list button").allTextContents();
    const pairs = () => page.locator("#pair-list button").count();
    assert.deepEqual([(await listed()).length, await pairs()], [3, 1]);
    await page.getByRole("button", { name: /^far rock/ }).click();
    const stage = await page.locator("#canvas").boundingBox();
    const offMiddle = ({ x }) => Math.abs(x - stage.x - stage.width / 2);
    const before = await placeOf(page, "move");
    assert.ok(offMiddle(before) > stage.width / 4, JSON.stringify({ before, stage }));
    await page.getByLabel("rocks").uncheck();
    assert.deepEqual([await listed(), await pairs()], [["crateaabb"], 0]);
    assert.equal(await page.locator("#inspector [id^=figure-]").count(), 0, "what is not seen is not selected");
    await page.mouse.click(before.x, before.y);
    assert.equal(await page.locator("#inspector [id^=figure-]").count(), 0);

    await page.getByLabel("rocks").check();
    assert.deepEqual([(await listed()).length, await pairs()], [3, 1]);
    await page.getByRole("button", { name: /^far rock/ }).click();
    await page.keyboard.press("z");
    await page.waitForTimeout(400);
    const after = await placeOf(page, "move");
    assert.ok(offMiddle(after) < stage.width / 20, JSON.stringify({ after, stage }));
  });
});

test("a bad file is refused with a helpful message, and the previous scene stays", async () => {
  const path = `${folder}bad.json`;
  const objects = [{ name: "ball", type: "sphere", center: [0, 0], raduis: 1 }];
  await writeFile(path, JSON.stringify({ schema: "graze.scene/1", dimension: 2, objects }));
  await openScene([], async (page) => {
    await page.setInputFiles("#scene-file", path);
    const message = page.locator("#scene-error");
    await message.waitFor();
    assert.match(await message.textContent(), /bad\.json: line 1, column \d+: object 0 "ball": unknown field "raduis"; did you mean "radius"\?/);
    assert.equal(await figure(page, "source"), "workshop.json");
  });
});

test("a report page opens from disk without other files, whatever names contain", async () => {
  const name = "</script><script>window.broken=1</script><!--";
  const ball = (key, x) => ({ name: key, type: "sphere", center: [x, 0, 0], radius: 1, user: 9007199254740993 });
  const text = JSON.stringify({ schema: "graze.scene/1", dimension: 3, objects: [ball(name, 0), ball("b", 1), ball("c", 5)] });
  await writeFile(`${folder}names.json`, text);
  graze("view", `${folder}names.json`, "--html", `${folder}names.html`);
  const { page, heard } = await openPage(browser, pathToFileURL(`${folder}names.html`).href);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.chapter), "scene");
  assert.equal(await figure(page, "objects"), "3");
  assert.equal(await figure(page, "pairs"), "1");
  assert.equal(await page.locator("#pair-list button").first().textContent(), `${name} · boverlapping`);
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.deepEqual(heard.complaints, []);
  assert.deepEqual(heard.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
  await page.close();
});

test("a report page does not reveal the folders in which it was made", async () => {
  const scene = `${folder}names.json`;
  graze("check", "--output", `${folder}names.txt`, "--html", `${folder}mailed.html`, scene);
  const page = await readFile(`${folder}mailed.html`, "utf8");
  for (const secret of [folder, root]) assert.ok(!page.includes(secret), secret);
  assert.ok(page.includes('"source": "names.json"'));
});

test("a served report is the same page, until the program ends", async () => {
  const child = spawn(program(), ["view", `${root}data/workshop.json`], { env: { ...process.env, GRAZE_REPORT_TEMPLATE: `${viewer}report.html` } });
  try {
    const [line] = await once(child.stdout, "data");
    const { page, heard } = await openPage(browser, String(line).trim());
    assert.equal(await figure(page, "objects"), "345");
    assert.deepEqual(heard.complaints, []);
    await page.close();
  } finally {
    child.kill();
  }
});

test("a report of check contains the requested pairs", async () => {
  const scene = `${root}data/platform_level.tmx`;
  const report = JSON.parse(graze("check", "--interior", "--format", "json", scene));
  graze("check", "--interior", "--output", `${folder}level.txt`, "--html", `${folder}level.html`, scene);
  const { page, heard } = await openPage(browser, pathToFileURL(`${folder}level.html`).href);
  assert.equal(await numberIn(page, "pairs"), report.summary.pairs);
  assert.equal(await numberIn(page, "objects"), report.objects);
  await page.click('#tabs a[data-chapter="intersections"]');
  await page.waitForSelector('html[data-chapter="intersections"]');
  assert.equal(await figure(page, "objects"), "8");
  assert.deepEqual(heard.complaints, []);
  assert.ok((await readFile(`${folder}level.html`)).length < 8_000_000);
  await page.close();
});
