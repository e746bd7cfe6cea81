// SPDX-License-Identifier: MIT
// The chapters of the playground in a real browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { colourAt, drag, figure, numberIn, openBrowser, openPage, placeOf, serveViewer } from "./browser.mjs";

let browser, server;
before(async () => {
  [browser, server] = await Promise.all([openBrowser(), serveViewer()]);
});
after(async () => {
  await browser?.close();
  server?.close();
});

/** Runs a test on a new page, which must not report errors. */
async function on(hash, body, options) {
  const { page, heard } = await openPage(browser, `${server.address}${hash}`, options);
  try {
    await body(page, heard);
    assert.deepEqual(heard.complaints, []);
  } finally {
    await page.close();
  }
}

/** Follows another link on the same page. */
function follow(page, hash) {
  return page.evaluate((next) => new Promise((resolve) => {
    window.addEventListener("hashchange", () => setTimeout(resolve), { once: true });
    location.hash = next;
  }), hash);
}

const chapters = ["intersections", "closest-points", "rays", "walk", "bounding-volumes", "trees", "broad-phase", "meshes", "scene"];
const twoCircles = "#intersections?shapes=sphere:-2,0,1;sphere:2,0,1";
const isOrange = ([red, green, blue]) => red > 200 && red - blue > 60 && green > blue;

test("every tab opens without errors, fills the panel and requests nothing from other hosts", async () => {
  await on("", async (page, heard) => {
    assert.deepEqual(await page.locator("#tabs a").evaluateAll((tabs) => tabs.map((tab) => tab.dataset.chapter)), chapters);
    for (const chapter of chapters) {
      await page.click(`#tabs a[data-chapter="${chapter}"]`);
      await page.waitForSelector(`html[data-chapter="${chapter}"]`);
      assert.ok((await page.locator("#panel .figures dd").count()) >= 3, chapter);
      await page.waitForTimeout(150);
      const solid = page.getByRole("button", { name: "3D", exact: true });
      const hasSwitch = !["meshes", "scene"].includes(chapter);
      assert.equal(await solid.count(), hasSwitch ? 1 : 0, chapter);
      if (!hasSwitch) continue;
      if ((await page.locator("#play").count()) > 0) await page.click("#play");
      await solid.click();
      await page.waitForFunction(() => location.hash.includes("dimension=3"));
    }
    assert.ok(heard.requests.length > 2);
    for (const request of heard.requests) assert.match(request, new RegExp(`^(${server.address}|data:)`));
  });
});

test("a drag makes a pair overlap and turn orange, and dragging further separates it again", async () => {
  await on(twoCircles, async (page) => {
    assert.equal(await figure(page, "pairs"), "0");
    const [left, right] = [await placeOf(page, "shape-0"), await placeOf(page, "shape-1")];
    const middle = { x: right.x + 20, y: right.y + 13 };
    assert.ok(!isOrange(await colourAt(page, middle)));
    const near = { x: left.x + 0.6 * (right.x - left.x), y: left.y };
    await drag(page, left, near);
    assert.equal(await figure(page, "pairs"), "1");
    assert.match(await page.locator("#pairs").textContent(), /circle 1 · circle 2overlapping/);
    assert.ok(isOrange(await colourAt(page, middle)), String(await colourAt(page, middle)));
    await drag(page, near, left);
    assert.equal(await figure(page, "pairs"), "0");
  });
});

test("circles that touch at a point count as a pair with depth 0 and turn green, not orange", async () => {
  await on("#intersections?shapes=sphere:-1,0,1;sphere:1,0,1", async (page) => {
    assert.equal(await figure(page, "pairs"), "1");
    assert.match(await page.locator("#pairs").textContent(), /touching/);
    assert.equal(await page.locator("#overlay text").textContent(), "0");
    const circle = await placeOf(page, "shape-1");
    const [red, green, blue] = await colourAt(page, { x: circle.x + 20, y: circle.y + 13 });
    assert.ok(green > red + 10 && green > blue, `${red} ${green} ${blue}`);
  });
});

test("the link restores the view, also after a drag", async () => {
  await on(twoCircles, async (page) => {
    const left = await placeOf(page, "shape-0");
    await drag(page, left, { x: left.x + 40, y: left.y - 60 });
    await page.waitForTimeout(400);
    const moved = await placeOf(page, "shape-0");
    const link = page.url();
    assert.notEqual(link, `${server.address}${twoCircles}`);
    await page.goto("about:blank");
    await page.goto(link);
    await page.waitForSelector("html[data-chapter]");
    const again = await placeOf(page, "shape-0");
    assert.ok(Math.hypot(again.x - moved.x, again.y - moved.y) < 1, `${again.x},${again.y} is not ${moved.x},${moved.y}`);
  });
});

test("an invalid link opens the default scene", async () => {
  await on("#intersections?shapes=sphere:0,0,-1;nonsense", async (page) => {
    assert.equal(await figure(page, "objects"), "8");
  });
});

test("everything works from the keyboard: a chapter, a shape that moves and is removed, help", async () => {
  await on("#rays", async (page) => {
    await page.keyboard.press("1");
    await page.waitForSelector('html[data-chapter="intersections"]');
    await page.locator('#overlay circle[data-key="shape-1"]').focus();
    const before = await placeOf(page, "shape-1");
    await page.keyboard.press("Shift+ArrowRight");
    const moved = await placeOf(page, "shape-1");
    assert.ok(Math.abs(moved.x - before.x - 40) < 1.5, `${moved.x - before.x}`);
    await page.keyboard.press("Delete");
    assert.equal(await figure(page, "objects"), "7");
    await page.keyboard.press("?");
    assert.ok(await page.locator("#help-dialog").isVisible());
    await page.keyboard.press("Escape");
    assert.ok(!(await page.locator("#help-dialog").isVisible()));
  });
});

test("a link followed while a write of the address is pending is not lost", async () => {
  await on("#intersections", async (page) => {
    await page.waitForTimeout(500); // until the address of what was opened is written
    const address = await page.evaluate(async () => {
      const circle = document.querySelector('#overlay circle[data-key="shape-1"]');
      circle.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true, cancelable: true }));
      history.replaceState(null, "", "#trees"); // the page hears of a link in a later task: here, in the one below
      await new Promise((resolve) => setTimeout(resolve, 500));
      const found = location.hash;
      window.dispatchEvent(new HashChangeEvent("hashchange"));
      return found;
    });
    assert.equal(address, "#trees");
    await page.waitForSelector('html[data-chapter="trees"]');
  });
});

test("a probe inside a circle is contained, and its distance is negative", async () => {
  await on("#closest-points?shapes=sphere:0,0,2&x=0.5&y=0", async (page) => {
    assert.equal(await figure(page, "contains"), "1");
    assert.equal(await figure(page, "distance"), "\u22121.500");
  });
});

test("a ray hits one wall first, and both in order", async () => {
  const walls = "shapes=segment:1,-1,1,1;segment:3,-1,3,1&x=0&y=0&to-x=1&to-y=0";
  await on(`#rays?mode=first&${walls}`, async (page) => {
    assert.equal(await figure(page, "hits"), "1");
    assert.equal(await figure(page, "t"), "1.000");
    await page.getByRole("button", { name: "All hits" }).click();
    assert.equal(await figure(page, "hits"), "2");
  });
});

test("a moving circle stops at the first contact with a wall, with and without rotation", async () => {
  const wall = "shapes=aabb:2,-3,3,3&x=-2&y=0&to-x=4&to-y=0";
  await on(`#rays?mode=cast&moving=sphere&size=1&${wall}`, async (page) => {
    // The circle has radius 0.8: it touches after 3.2 of 6.
    assert.equal(await figure(page, "t"), "0.5333");
    assert.equal(await figure(page, "hits"), "1");
    await page.getByRole("slider", { name: "Size" }).fill("0.5");
    assert.equal(await figure(page, "t"), "0.6000");
    await page.getByRole("slider", { name: "Rotation along the path" }).fill("180");
    assert.equal(await figure(page, "t"), "0.6000");
    await page.getByRole("button", { name: "oriented box" }).first().click();
    await page.waitForFunction(() => document.querySelector("#figure-t").textContent !== "0.6000");
    assert.match(await page.locator("#caption").textContent(), /^The oriented box touches box at t = 0\.\d+$/);
    const target = await placeOf(page, "target");
    await drag(page, target, { x: target.x - 180, y: target.y });
    assert.equal(await figure(page, "t"), "–");
    await page.waitForFunction(() => location.hash.includes("mode=cast") && location.hash.includes("turn=180"));
  });
});

test("in 3D a drag makes a pair overlap and turn orange, and the numbers are correct", async () => {
  const isWarm = ([red, green, blue]) => red - blue > 40 && green > blue;
  await on("#intersections?dimension=3&shapes=sphere:-1.5,0,1,1;sphere:1.5,0,1,1&selected=0", async (page) => {
    assert.equal(await figure(page, "pairs"), "0");
    assert.equal(await page.locator("#overlay text").textContent(), "1.000");
    const [left, right] = [await placeOf(page, "shape-0"), await placeOf(page, "shape-1")];
    const edge = { x: right.x + 38, y: right.y + 16 };
    assert.ok(!isWarm(await colourAt(page, edge)), String(await colourAt(page, edge)));
    await drag(page, left, right);
    assert.equal(await figure(page, "pairs"), "1");
    assert.ok(isWarm(await colourAt(page, edge)), String(await colourAt(page, edge)));
    const moved = await placeOf(page, "shape-0");
    assert.ok(Math.hypot(moved.x - right.x, moved.y - right.y) < 15, `${moved.x},${moved.y} is not ${right.x},${right.y}`);
    await page.mouse.click(20, 100);
    assert.equal(await page.locator("#overlay circle.handle").count(), 0);
    await follow(page, "#intersections?dimension=3&shapes=sphere:0,0,1,1;obb:1.5,0,1,1,1,1,0,0,0");
    assert.equal(await page.locator("#overlay text").textContent(), "0.5000");
    assert.equal(await figure(page, "candidates"), "1");
    assert.match(await page.locator("#pairs").textContent(), /sphere · oriented boxoverlapping/);
    await page.getByRole("button", { name: "Manifold" }).click();
    assert.equal(await page.locator("#overlay text").count(), 0);
    assert.ok((await page.locator("#overlay circle.dot").count()) >= 1);
  });
});

test("in 3D a shape is moved, rotated, tilted and resized by keys, and the link restores it", async () => {
  await on("#intersections?dimension=3&shapes=obb:0,0,1,1,0.6,0.4,0,0,0;half_space:0,0,1,0", async (page) => {
    const axes = () => Promise.all([1, 2, 3].map((axis) => figure(page, `axes-${axis}`)));
    const grip = page.locator('#overlay circle[data-key="shape-0"]');
    await grip.focus();
    assert.deepEqual(await axes(), ["(1.000, 0, 0)", "(0, 1.000, 0)", "(0, 0, 1.000)"]);
    await page.keyboard.press("[");
    assert.deepEqual(await axes(), ["(0.9962, 0.0872, 0)", "(\u22120.0872, 0.9962, 0)", "(0, 0, 1.000)"]);
    for (let i = 0; i < 4; ++i) await page.keyboard.press("{");
    assert.notEqual((await axes())[2], "(0, 0, 1.000)");
    await page.keyboard.press(">");
    assert.equal(await figure(page, "half_extents"), "(1.080, 0.6480, 0.4320)");
    const before = await placeOf(page, "shape-0");
    await page.keyboard.press("Shift+ArrowDown");
    await page.keyboard.press("Shift+ArrowDown");
    const after = await placeOf(page, "shape-0");
    assert.ok(Math.abs(after.y - before.y - 80) < 3, `${after.y - before.y}`);
    assert.equal(await figure(page, "pairs"), "1");
    const turned = await axes();
    await page.waitForTimeout(400);
    const link = page.url();
    assert.match(link, /selected=0/);
    await page.goto("about:blank");
    await page.goto(link);
    await page.waitForSelector("html[data-chapter]");
    assert.deepEqual(await axes(), turned);
    assert.equal(await figure(page, "pairs"), "1");
    const turn = await placeOf(page, "grip-0-tilt");
    const middle = await placeOf(page, "shape-0");
    await drag(page, turn, { x: middle.x + 60, y: middle.y });
    assert.notDeepEqual(await axes(), turned);
    await page.locator('#overlay circle[data-key="grip-0-side 1"]').focus();
    await page.keyboard.press("Shift+ArrowRight");
    assert.match(await figure(page, "half_extents"), /, 0\.6480, 0\.4320\)$/);
    assert.doesNotMatch(await figure(page, "half_extents"), /^\(1\.080,/);
    await page.locator('#overlay circle[data-key="shape-0"]').focus();
    await page.keyboard.press("Delete");
    assert.equal(await figure(page, "objects"), "1");
  });
});

test("in 3D rays stop, a lamp lights what it reaches, and a moving shape stops at its first contact", async () => {
  const walls = "shapes=aabb:1,-1,-1,2,1,1;sphere:4,0,0,1;sphere:0,5,0,1";
  await on(`#rays?dimension=3&mode=first&x=0&y=0&z=0&to-x=1&to-y=0&to-z=0&${walls}`, async (page) => {
    assert.equal(await figure(page, "t"), "1.000");
    await page.getByRole("button", { name: "All hits" }).click();
    assert.deepEqual(await page.locator(".list .tag").allTextContents(), ["1.000", "3.000"]);
    await page.getByRole("button", { name: "Lamp" }).click();
    assert.equal(await figure(page, "hits"), "2");
    assert.equal(await page.locator("#caption").textContent(), "720 rays see 2 shapes");
    await follow(page, "#rays?dimension=3&mode=cast&moving=sphere&size=1&shapes=aabb:2,-3,-3,3,3,3&x=-2&y=0&z=1&to-x=4&to-y=0&to-z=1");
    assert.equal(await figure(page, "t"), "0.5333");
    await page.getByRole("slider", { name: "Rotation along the path" }).fill("180");
    assert.equal(await figure(page, "t"), "0.5333");
    await page.getByRole("button", { name: "oriented box" }).first().click();
    assert.match(await page.locator("#caption").textContent(), /^The oriented box touches box at t = 0\.\d+$/);
    const origin = await placeOf(page, "origin");
    await page.getByRole("button", { name: "2D", exact: true }).click();
    assert.match(await page.locator("#caption").textContent(), /^The oriented box touches /);
    await page.getByRole("button", { name: "3D", exact: true }).click();
    assert.deepEqual(await placeOf(page, "origin"), origin);
    assert.equal(await figure(page, "rays"), "1");
  });
});

test("in 3D the distance of a point is signed, and points of bounding volumes can be moved", async () => {
  await on("#closest-points?dimension=3&shapes=sphere:0,0,0,2;segment:5,0,0,5,0,4&x=0.5&y=0&z=0", async (page) => {
    assert.equal(await figure(page, "contains"), "1");
    assert.equal(await figure(page, "distance"), "\u22121.500");
    assert.deepEqual(await page.locator(".list .tag").allTextContents(), ["\u22121.500", "4.500"]);
    await follow(page, "#bounding-volumes?dimension=3&points=0,0,0;1,0,0;0,1,0;0,0,1");
    const size = async (id) => Number((await figure(page, id)).split(" ")[0]);
    assert.equal(await size("box"), 1);
    assert.ok(Math.abs((await size("hull")) - 1 / 6) < 1e-4);
    await page.locator('#overlay circle[data-key="point-3"]').focus();
    await page.keyboard.press("Shift+ArrowUp");
    assert.ok((await size("hull")) > 0.17);
  });
});

test("bounding volumes of three points have the correct sizes", async () => {
  await on("#bounding-volumes?points=0,0;2,0;0,2", async (page) => {
    const area = async (id) => Number((await figure(page, id)).split(" ")[0]);
    assert.equal(await area("box"), 4);
    assert.equal(await area("hull"), 2);
    assert.ok(Math.abs((await area("sphere")) - 2 * Math.PI) < 0.001);
  });
});

test("a quad tree splits according to its capacity, and a hierarchy finds the same boxes", async () => {
  await on("#trees?play=no&count=200&capacity=32&depth=8&radius=0.5", async (page) => {
    const [coarse, found] = [await numberIn(page, "cells"), await numberIn(page, "found")];
    assert.ok(found > 0);
    await page.getByRole("slider", { name: "Capacity of a cell" }).fill("1");
    const fine = await numberIn(page, "cells");
    assert.ok(fine > 2 * coarse);
    assert.equal(await numberIn(page, "found"), found);
    await page.getByRole("slider", { name: "Greatest depth" }).fill("3");
    assert.ok((await numberIn(page, "cells")) < fine);
    assert.ok((await numberIn(page, "depth")) <= 4);
    assert.equal(await numberIn(page, "found"), found);
    await page.getByRole("button", { name: "BVH" }).click();
    assert.equal(await numberIn(page, "found"), found);
    const slider = page.getByRole("slider", { name: "Boxes" });
    await slider.focus();
    await page.keyboard.press("End");
    assert.ok((await numberIn(page, "boxes")) > 1000);
  });
});

for (const dimension of [2, 3]) {
  test(`all methods find the same pairs of moving boxes in ${dimension}D, step by step`, async () => {
    await on(`#broad-phase?play=no&count=400&crowd=3&dimension=${dimension}`, async (page) => {
      const start = await numberIn(page, "pairs");
      assert.ok(start > 100);
      for (let i = 0; i < 20; ++i) await page.keyboard.press(".");
      const found = await numberIn(page, "pairs");
      assert.notEqual(found, start);
      for (const method of ["Tree", "Dense", "Brute force"]) {
        await page.getByRole("button", { name: method }).click();
        assert.equal(await numberIn(page, "pairs"), found, method);
      }
      await page.getByRole("button", { name: /^Add/ }).click();
      assert.equal(await numberIn(page, "boxes"), 1400);
    });
  });
}

test("the moving shape starts with a path across the others and something to touch", async () => {
  for (const dimension of [2, 3]) {
    await on(`#rays?dimension=${dimension}`, async (page) => {
      await page.getByRole("button", { name: "Moving shape" }).click();
      const [from, to] = [await placeOf(page, "origin"), await placeOf(page, "target")];
      assert.ok(Math.hypot(to.x - from.x, to.y - from.y) > 150, `${dimension}D`);
      assert.match(await page.locator("#caption").textContent(), /^The oriented box touches .+ at t = 0\.\d+$/);
      await page.getByRole("button", { name: "First hit" }).click();
      assert.equal(await figure(page, "rays"), "1");
    });
  }
});

test("play runs by itself and pauses", async () => {
  await on("#broad-phase?count=300&crowd=3", async (page) => {
    const before = await numberIn(page, "pairs");
    await page.waitForFunction((old) => document.querySelector("#figure-pairs").textContent !== String(old), before);
    await page.click("#play");
    const paused = await numberIn(page, "pairs");
    await page.waitForTimeout(300);
    assert.equal(await numberIn(page, "pairs"), paused);
  });
});

test("everything fits the width of a phone, also in dark mode", async () => {
  const phone = { viewport: { width: 360, height: 740 }, colorScheme: "dark" };
  for (const chapter of chapters) {
    await on(`#${chapter}?play=no&dimension=3`, async (page) => {
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360, chapter);
      assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
      assert.ok((await page.locator("#stage").boundingBox()).height > 200);
    }, phone);
  }
});

test("a finger drags a shape in 3D, and rotates the view beside it", async () => {
  const phone = { viewport: { width: 390, height: 760 }, hasTouch: true, isMobile: true };
  await on("#intersections?dimension=3&shapes=sphere:-1.5,0,1,1;sphere:1.5,0,1,1", async (page) => {
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
    const swipe = async (from, to) => {
      await touch("touchStart", from);
      for (const share of [0.5, 1]) await touch("touchMove", { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) });
      await touch("touchEnd");
    };
    const [left, right] = [await placeOf(page, "shape-0"), await placeOf(page, "shape-1")];
    assert.ok(right.x - left.x > 60, `${left.x} ${right.x}`);
    assert.equal(await figure(page, "pairs"), "0");
    await swipe(left, right);
    assert.equal(await figure(page, "pairs"), "1");
    await swipe({ x: 40, y: 130 }, { x: 140, y: 130 });
    assert.ok(Math.abs((await placeOf(page, "shape-1")).x - right.x) > 20);
  }, phone);
});
