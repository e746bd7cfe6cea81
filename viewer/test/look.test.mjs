// SPDX-License-Identifier: MIT
// Appearance and accessibility: contrast, headings, sizes, labels, and a camera that stays above the floor.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { colourAt, openBrowser, openPage, placeOf, serveViewer } from "./browser.mjs";

let browser, server;
before(async () => {
  [browser, server] = await Promise.all([openBrowser(), serveViewer()]);
});
after(async () => {
  await browser?.close();
  server?.close();
});

const tabs = [
  "#intersections?selected=1", "#intersections?dimension=3&selected=2", "#closest-points", "#closest-points?dimension=3&selected=1", "#rays?mode=all",
  "#rays?mode=cast", "#rays?mode=cast&dimension=3", "#walk?x=-5", "#walk?dimension=3&x=-2.5", "#bounding-volumes", "#trees?play=no", "#trees?play=no&dimension=3", "#broad-phase?play=no&count=200",
  "#meshes", "#meshes?example=knot&x=-3.6937&y=-6.0066&z=5.0479&to-x=-0.6519&to-y=-0.6237&to-z=1.539", "#meshes?example=broken", "#scene?example=crossing&frame=54", "#scene?example=workshop&select=rafter+3",
];
const phone = { viewport: { width: 390, height: 760 }, hasTouch: true, isMobile: true };

/** Runs a check on every tab, each on a new page. */
async function onEachTab(check, options) {
  for (const tab of tabs) {
    const { page } = await openPage(browser, `${server.address}${tab}`, options);
    try {
      await check(page, tab);
    } finally {
      await page.close();
    }
  }
}

/** Runs in the page: finds every text of the header, the panel and the caption whose contrast with its background is
 * below 4.5 (WCAG 2, success criterion 1.4.3), except disabled controls. */
function textsOfLowContrast() {
  const context = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });
  const known = new Map();
  const channels = (colour) => {
    if (known.has(colour)) return known.get(colour);
    context.clearRect(0, 0, 1, 1);
    context.fillStyle = colour;
    context.fillRect(0, 0, 1, 1);
    const [red, green, blue, alpha] = context.getImageData(0, 0, 1, 1).data;
    known.set(colour, { colour: [red, green, blue], alpha: alpha / 255 });
    return known.get(colour);
  };
  const luminance = (colour) => {
    const [red, green, blue] = colour.map((value) => (value <= 10.3 ? value / 3294.6 : ((value / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  };
  const ground = (element) => {
    const behind = element.parentElement === null ? [255, 255, 255] : ground(element.parentElement);
    const { colour, alpha } = channels(getComputedStyle(element).backgroundColor);
    return colour.map((value, i) => alpha * value + (1 - alpha) * behind[i]);
  };
  const poor = [];
  for (const element of document.querySelectorAll("header *, #panel *, #caption, #overlay text")) {
    const hasText = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim() !== "");
    if (!hasText || element.closest(":disabled") !== null || element.getClientRects().length === 0) continue;
    const style = getComputedStyle(element);
    const isDrawn = element instanceof SVGElement;
    const behind = isDrawn ? channels(style.stroke).colour : ground(element);
    const [dark, bright] = [luminance(channels(isDrawn ? style.fill : style.color).colour), luminance(behind)].sort((a, b) => a - b);
    const contrast = (bright + 0.05) / (dark + 0.05);
    if (contrast < 4.5) poor.push(`${element.textContent.trim()}: ${contrast.toFixed(2)}`);
  }
  return poor;
}

/** Includes hovered tags and tags in a selected row. */
async function checkContrast(page, tab) {
  assert.deepEqual(await page.evaluate(textsOfLowContrast), [], tab);
  const row = page.locator(".list button:is(.touching, .overlapping):visible").first();
  if ((await row.count()) === 0) return;
  await row.hover();
  assert.deepEqual(await page.evaluate(textsOfLowContrast), [], `${tab}, a row under the pointer`);
  await row.click();
  assert.deepEqual(await page.evaluate(textsOfLowContrast), [], `${tab}, a chosen row`);
}

/** There is one first-level heading, and no level is skipped. */
async function checkHeadings(page, tab) {
  const ranks = await page.locator("h1, h2, h3, h4").evaluateAll((all) => all.filter((one) => one.closest("dialog") === null).map((one) => Number(one.tagName[1])));
  assert.equal(ranks[0], 1, tab);
  assert.deepEqual(ranks.slice(1).filter((rank) => rank !== 2), [], tab);
}

/** The buttons of a choice stay on one line and inside their panel, with all of their text. */
async function checkChoices(page, tab) {
  const broken = await page.locator(".choice").evaluateAll((choices) =>
    choices.filter((one) => one.getClientRects().length > 0).flatMap((one) => {
      const buttons = [...one.children].map((button) => button.getBoundingClientRect());
      const isWhole = [...one.children].every((button) => button.scrollWidth <= button.clientWidth + 1);
      const isOneLine = buttons.every(({ top, height }) => top === buttons[0].top && height < 40);
      const fits = buttons.at(-1).right <= document.querySelector("#panel").getBoundingClientRect().right - 10;
      return isWhole && isOneLine && fits ? [] : [one.textContent];
    }),
  );
  assert.deepEqual(broken, [], tab);
}

/** Labels do not cover handles and stay inside the picture. */
async function checkLabels(page, tab) {
  const bad = await page.evaluate(() => {
    const stage = document.querySelector("#overlay").getBoundingClientRect();
    const knobs = [...document.querySelectorAll("#overlay .knob")].map((knob) => knob.getBoundingClientRect());
    return [...document.querySelectorAll("#overlay text")].flatMap((text) => {
      const box = text.getBoundingClientRect();
      const covers = knobs.some((knob) => knob.left < box.right && knob.right > box.left && knob.top < box.bottom - 3 && knob.bottom > box.top + 3);
      const isWithin = box.left >= stage.left && box.right <= stage.right && box.top >= stage.top - 3 && box.bottom <= stage.bottom + 3;
      return covers || !isWithin ? [text.textContent] : [];
    });
  });
  assert.deepEqual(bad, [], tab);
}

/** Touch targets are at least 32 pixels wide and high. */
async function checkTargets(page, tab) {
  const small = await page.evaluate(() => {
    const targets = document.querySelectorAll("a, button, label, input:not([type=checkbox]):not([hidden]), #overlay [role=button]");
    return [...targets].filter((target) => target.getClientRects().length > 0).flatMap((target) => {
      const { width, height } = target.getBoundingClientRect();
      return width >= 31.99 && height >= 31.99 ? [] : [`${target.outerHTML.slice(0, 80)}: ${width} x ${height}`];
    });
  });
  assert.deepEqual(small, [], tab);
}

test("every text has a contrast of 4.5:1 in light and dark mode, heading levels are right, choices stay on one line and labels off handles", async () => {
  await onEachTab(async (page, tab) => {
    await checkHeadings(page, tab);
    await checkChoices(page, tab);
    await checkLabels(page, tab);
    await checkContrast(page, tab);
    await page.emulateMedia({ colorScheme: "dark" });
    await page.waitForSelector("html[data-theme=dark]");
    await checkContrast(page, `${tab} in dark mode`);
  });
});

test("on a phone touch targets are 32 pixels wide and high, choices stay on one line and labels inside the picture", async () => {
  await onEachTab(async (page, tab) => {
    await checkTargets(page, tab);
    await checkChoices(page, tab);
    await checkLabels(page, tab);
  }, phone);
});

test("nothing moves if the system requests reduced motion, until play is pressed", async () => {
  for (const tab of ["#trees", "#broad-phase?count=300&crowd=3&play=yes"]) {
    const { page } = await openPage(browser, `${server.address}${tab}`, { reducedMotion: "reduce" });
    const shown = () => page.locator("#panel .figures").textContent();
    assert.match(await page.locator("#play").textContent(), /Play/);
    const before = await shown();
    await page.waitForTimeout(400);
    assert.equal(await shown(), before, tab);
    await page.click("#play");
    await page.waitForFunction((old) => document.querySelector("#panel .figures").textContent !== old, before);
    await page.close();
  }
});

test("the camera stays above the floor, however it is dragged, moved and rotated", async () => {
  const hash = "#rays?dimension=3&x=-2&y=-2.6&z=1&to-x=2&to-y=2.6&to-z=1&shapes=sphere:0,0,5,0.1";
  const { page } = await openPage(browser, `${server.address}${hash}`);
  /** Of two points of the floor, the nearer one appears lower as long as the camera is above the floor. */
  const isAbove = async () => {
    const feet = await page.locator("#overlay .hollow").evaluateAll((dots) => dots.map((dot) => Number(dot.getAttribute("cy"))));
    assert.equal(feet.length, 2);
    return feet[0] > feet[1];
  };
  const stage = await page.locator("#canvas").boundingBox();
  const swipe = async (button, by) => {
    await page.mouse.move(stage.x + stage.width - 60, stage.y + 300);
    await page.mouse.down({ button });
    await page.mouse.move(stage.x + stage.width - 60, stage.y + 300 + by, { steps: 4 });
    await page.mouse.up({ button });
  };
  assert.ok(await isAbove());
  for (const by of [-250, -250, -250]) await swipe("left", by);
  assert.ok(await isAbove(), "dragged");
  for (let i = 0; i < 40; ++i) await page.keyboard.press("ArrowDown");
  assert.ok(await isAbove(), "turned by keys");
  await page.keyboard.press("0");
  for (let i = 0; i < 4; ++i) await swipe("right", -200);
  const feet = await page.locator("#overlay .hollow").count();
  if (feet === 2) assert.ok(await isAbove(), "moved");
  await page.close();
});

test("in 3D shapes cast shadows on the floor", async () => {
  // The lamp is in direction (-0.35, -0.55, 0.75): the shadow of a sphere 1 above the floor is offset by (0.47, 0.73).
  const brightness = async (x, y) => {
    const { page } = await openPage(browser, `${server.address}#closest-points?dimension=3&show=nearest&shapes=sphere:0,0,1,0.8&x=${x}&y=${y}&z=0`);
    const { x: left, y: top } = await placeOf(page, "probe");
    await page.waitForTimeout(200);
    const [red, green, blue] = await colourAt(page, { x: left + 12, y: top + 9 });
    await page.close();
    return red + green + blue;
  };
  const [shaded, lit] = [await brightness(0.6, 0.9), await brightness(-1.6, 0.4)];
  assert.ok(lit - shaded > 30, `${lit} ${shaded}`);
});
