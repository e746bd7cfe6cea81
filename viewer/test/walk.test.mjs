// SPDX-License-Identifier: MIT
// The capsule that walks through a level.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { drag, figure, openBrowser, openPage, placeOf, serveViewer } from "./browser.mjs";

let browser, server;
before(async () => {
  [browser, server] = await Promise.all([openBrowser(), serveViewer()]);
});
after(async () => {
  await browser?.close();
  server?.close();
});

/** In a small window, because software draws the pictures. */
async function on(hash, body, options) {
  const { page, heard } = await openPage(browser, `${server.address}${hash}`, { viewport: { width: 780, height: 420 }, ...options });
  try {
    await body(page);
    assert.deepEqual(heard.complaints, []);
  } finally {
    await page.close();
  }
}

/** Waits until the capsule stands still, and returns its place in the link, which is written a few times a second. */
async function restingPlace(page) {
  let last = "";
  for (let same = 0; same < 3;) {
    await page.waitForTimeout(400);
    const now = await page.evaluate(() => location.hash);
    same = now === last ? same + 1 : 0;
    last = now;
  }
  const parameters = new URLSearchParams(last.split("?")[1]);
  return ["x", "y", "z"].filter((axis) => parameters.has(axis)).map((axis) => Number(parameters.get(axis)));
}

async function holdUntilStill(page, key) {
  await page.keyboard.down(key);
  const place = await restingPlace(page);
  await page.keyboard.up(key);
  return place;
}

/** A third of the clearance. */
const isNear = (a, b) => Math.abs(a - b) < 0.0035;
const assertAt = (place, wanted) => assert.ok(place.length === wanted.length && place.every((value, axis) => isNear(value, wanted[axis])), `${place} is not ${wanted}`);

test("the capsule stops at a wall, at its clearance, and tells what it touches", async () => {
  await on("#walk?x=0&y=0.01&shapes=half_space:0,1,0;aabb:1,0,2,3;aabb:-2,0,-1,3", async (page) => {
    assert.equal(await figure(page, "ground"), "half-space");
    assert.equal(await figure(page, "touches"), "1");
    assertAt(await holdUntilStill(page, "ArrowRight"), [0.69, 0.01]);
    assert.equal(await page.locator("#caption").textContent(), "The capsule stands on half-space, touches 1 other shape");
    assert.deepEqual(await page.locator(".list .tag").allTextContents(), ["ground, 0°", "wall, 90°"]);
    assert.equal(await figure(page, "touches"), "2");
    assertAt(await holdUntilStill(page, "ArrowLeft"), [-0.69, 0.01]);
    const shown = page.url();
    await page.goto("about:blank");
    await page.goto(shown);
    await page.waitForSelector("html[data-chapter]");
    assert.equal(await figure(page, "touches"), "2");
  });
});

test("it climbs steps and slopes up to their limits, and not beyond", async () => {
  const level = "shapes=half_space:0,1,0;aabb:1,0,3,0.3;aabb:3,0,4,3;triangle:-1,0,-3,0,-3,1.4;aabb:-4,0,-3,5&x=0&y=0.01";
  await on(`#walk?step=0&slope=20&${level}`, async (page) => {
    assertAt(await holdUntilStill(page, "ArrowRight"), [0.69, 0.01]);
    const [x, y] = await holdUntilStill(page, "ArrowLeft");
    assert.ok(x > -1 && isNear(y, 0.01), `${x} ${y}`);
    assert.match(page.url(), /slope=20&step=0&/);
    await page.getByRole("slider", { name: "Highest step" }).fill("0.35");
    await page.getByRole("slider", { name: "Steepest ground" }).fill("40");
    await page.evaluate(() => document.activeElement.blur());
    assertAt(await holdUntilStill(page, "ArrowRight"), [2.69, 0.31]);
    assert.match(await page.locator("#caption").textContent(), /stands on box 1/);
    const [, top] = await holdUntilStill(page, "ArrowLeft");
    assert.ok(top > 1.2, String(top));
    assert.equal(await figure(page, "slope"), "35°");
    assert.match(page.url(), /slope=40/);
    assert.doesNotMatch(page.url(), /step=/);
  });
});

test("it jumps, lands and stands again; a step makes it fall to the ground", async () => {
  await on("#walk?shapes=half_space:0,1,0;aabb:-1,0,0.5,2&x=0&y=2.01", async (page) => {
    assert.equal(await figure(page, "ground"), "box");
    const start = await placeOf(page, "walker");
    await page.keyboard.press(" ");
    await page.waitForFunction(() => document.querySelector("#figure-ground").textContent === "nothing");
    await page.waitForFunction(() => document.querySelector("#figure-ground").textContent === "box");
    assertAt(await restingPlace(page), [0, 2.01]);
    assert.ok(Math.abs((await placeOf(page, "walker")).y - start.y) < 1);
    await page.keyboard.down("ArrowRight");
    await page.waitForFunction(() => document.querySelector("#figure-ground").textContent === "half-space");
    await page.keyboard.up("ArrowRight");
    const [x, y] = await restingPlace(page);
    assert.ok(x > 0.8 && isNear(y, 0.01), `${x} ${y}`);
  });
});

test("dragged into a wall, it stays before it, and then the arrow keys walk", async () => {
  await on("#walk?shapes=half_space:0,1,0;aabb:1,0,1.1,8&x=0&y=0.01", async (page) => {
    const from = await placeOf(page, "walker");
    await drag(page, from, { x: from.x + 300, y: from.y - 20 });
    const [x, y] = await restingPlace(page);
    assert.ok(isNear(x, 0.69) && isNear(y, 0.01), `${x} ${y}`);
    const [back] = await holdUntilStillFor(page, "ArrowLeft", 500);
    assert.ok(back < 0.5, String(back));
  });
});

/** A level without an end on this side. */
async function holdUntilStillFor(page, key, milliseconds) {
  await page.keyboard.down(key);
  await page.waitForTimeout(milliseconds);
  await page.keyboard.up(key);
  return restingPlace(page);
}

/** However few frames a second there are. */
async function holdUntil(page, key, isFarEnough) {
  await page.keyboard.down(key);
  while (!(await isFarEnough())) await page.waitForTimeout(50);
  await page.keyboard.up(key);
  return restingPlace(page);
}

test("in 3D the arrow keys walk as seen by the camera, along a wall and around it", async () => {
  await on("#walk?dimension=3&x=0&y=0&z=0.01&shapes=half_space:0,0,1,0;sphere:9,9,9,1", async (page) => {
    const at = () => placeOf(page, "walker");
    const before = await at();
    await holdUntil(page, "ArrowUp", async () => (await at()).y < before.y - 5);
    const ahead = await at();
    assert.ok(Math.abs(ahead.x - before.x) < 0.6 * (before.y - ahead.y), `${ahead.x - before.x} ${ahead.y - before.y}`);
    await holdUntil(page, "ArrowRight", async () => (await at()).x > ahead.x + 5);
    const right = await at();
    assert.ok(Math.abs(right.y - ahead.y) < right.x - ahead.x, `${right.x - ahead.x} ${right.y - ahead.y}`);
    await page.getByRole("button", { name: "2D", exact: true }).click();
    assert.equal(await figure(page, "ground"), "half-space");
    await page.getByRole("button", { name: "3D", exact: true }).click();
    assert.ok(Math.abs((await at()).x - right.x) < 1);
  });
  const level = "half_space:0,0,1,0;aabb:1,-9,0,2,1,3";
  await on(`#walk?dimension=3&x=0&y=-1&z=0.01&shapes=${level}`, async (page) => {
    // From the camera's place, right is about (0.83, -0.56): into the wall, and along it.
    const [x, y, z] = await holdUntilStillFor(page, "ArrowRight", 2500);
    assert.ok(isNear(x, 0.69) && y < -1.3 && isNear(z, 0.01), `${x} ${y} ${z}`);
    assert.match(await page.locator("#caption").textContent(), /stands on half-space, touches 1 other shape/);
  });
});

test("links leave out defaults", async () => {
  await on("#walk", async (page) => {
    await page.waitForTimeout(600);
    assert.equal(await page.evaluate(() => location.hash), "#walk");
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => /^#walk\?x=-5\.4\d*&y=0\.01$/.test(location.hash));
    await page.getByRole("button", { name: "Back to the start" }).click();
    await page.waitForFunction(() => location.hash === "#walk");
    await page.getByRole("button", { name: "3D", exact: true }).click();
    await page.waitForFunction(() => location.hash === "#walk?dimension=3");
    await page.getByRole("button", { name: "sphere", exact: true }).click();
    await page.waitForFunction(() => /&shapes=/.test(location.hash));
  });
});

test("a finger walks by the buttons, as long as it holds them", async () => {
  const phone = { viewport: { width: 390, height: 760 }, hasTouch: true, isMobile: true };
  await on("#walk?x=0&y=0.01&shapes=half_space:0,1,0;aabb:1,0,2,3", async (page) => {
    const session = await page.context().newCDPSession(page);
    const { x, y, width, height } = await page.getByRole("button", { name: "Walk right" }).boundingBox();
    await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x: x + width / 2, y: y + height / 2 }] });
    const place = await restingPlace(page);
    await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    assertAt(place, [0.69, 0.01]);
    await page.getByRole("button", { name: "Jump", exact: true }).tap();
    await page.waitForFunction(() => document.querySelector("#figure-ground").textContent === "nothing");
    await page.waitForFunction(() => document.querySelector("#figure-ground").textContent === "half-space");
  }, phone);
});

test("a shape that is moved into the capsule pushes it out", async () => {
  await on("#walk?x=0&y=0.01&shapes=half_space:0,1,0;aabb:1,0,2,3", async (page) => {
    await page.locator('#overlay circle[data-key="shape-1"]').focus();
    await page.keyboard.press("Shift+ArrowLeft");
    const [x] = await restingPlace(page);
    const [left, , right] = /aabb:([^;&]*)/.exec(page.url())[1].split(",").map(Number);
    assert.ok(left < 0.3, String(left));
    assert.ok(isNear(x, left - 0.31) || isNear(x, right + 0.31), `${x} beside ${left} to ${right}`);
    assert.equal(await figure(page, "touches"), "2");
    assert.equal(await figure(page, "ground"), "half-space");
  });
});
