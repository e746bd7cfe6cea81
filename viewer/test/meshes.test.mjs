// SPDX-License-Identifier: MIT
// Meshes from files and samples: faces, contacts, slices and reports.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { colourAt, drag, figure, numberIn, openBrowser, openPage, placeOf, serveViewer } from "./browser.mjs";
import { binaryStl, cube, glb, gltf, obj, ply, sheet, textStl } from "./mesh_files.mjs";

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
  const { page, heard } = await openPage(browser, `${server.address}${hash}`, { viewport: { width: 800, height: 480 }, ...options });
  try {
    await body(page, heard);
    assert.deepEqual(heard.complaints, []);
  } finally {
    await page.close();
  }
}

const named = (name, content) => ({ name, mimeType: "application/octet-stream", buffer: Buffer.from(content) });

/** Opens files by the button, and waits until they are shown. */
async function openFiles(page, ...files) {
  await page.setInputFiles("#mesh-file", files);
  await page.waitForFunction((name) => document.querySelector("#figure-source")?.textContent.includes(name), files[0].name);
}

async function refusal(page, ...files) {
  await page.evaluate(() => document.querySelector("#mesh-error")?.remove());
  await page.setInputFiles("#mesh-file", files);
  await page.waitForSelector("#mesh-error");
  return page.locator("#mesh-error").textContent();
}

const chooseMode = (page, name) => page.locator("#mesh-modes").getByRole("button", { name }).click();
const partNames = (page) => page.locator("#part-list button > span:first-child").allTextContents();

/** The middle of the drawing. */
async function middleOf(page) {
  const { x, y, width, height } = await page.locator("#canvas").boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
}

test("files of every format open, with corners joined: a closed cube of 8 vertices and 12 faces", async () => {
  await on("#meshes", async (page) => {
    const files = [
      named("binary.stl", binaryStl(cube())), named("text.stl", textStl(cube())), named("cube.ply", ply(cube())),
      named("cube.obj", obj({ cube: cube() })), named("cube.glb", glb([[cube()]], [{ mesh: 0 }])),
    ];
    for (const file of files) {
      await openFiles(page, file);
      assert.equal(await figure(page, "vertices"), "8, 12", file.name);
      assert.equal(await figure(page, "closed"), "yes", file.name);
      assert.equal(await figure(page, "components"), "1", file.name);
    }
  });
});

test("the nodes of a glTF are parts, with their transforms, turned to z up; its pictures are not needed", async () => {
  // The second primitive closes the first; the second node is mirrored, and far away.
  const { vertices, faces } = cube();
  const meshes = [[{ vertices, faces: faces.slice(0, 5) }, { vertices, faces: faces.slice(5) }]];
  const nodes = [
    { name: "base", mesh: 0, translation: [0, 0, 0] },
    { name: "arm", mesh: 0, translation: [1.5, 2, 0], scale: [-1, 1, 1] },
  ];
  await on("#meshes?mode=contacts", async (page) => {
    await openFiles(page, named("robot.glb", glb(meshes, nodes)));
    assert.deepEqual(await partNames(page), ["base", "arm"]);
    assert.equal(await figure(page, "closed"), "yes");
    // Above each other by a height of 1.
    assert.equal(await figure(page, "touched"), "nothing");
    assert.equal(await figure(page, "distance"), "1.000");
    await chooseMode(page, "Inside");
    await page.locator("#part-list button").nth(1).click();
    assert.equal(await figure(page, "closed"), "yes");
    const { json, buffer } = gltf(meshes, nodes, "deep/robot.bin");
    assert.equal(await refusal(page, named("robot.gltf", JSON.stringify(json))), "robot.gltf: it refers to robot.bin; drop that file together with it");
    await openFiles(page, named("robot.gltf", JSON.stringify(json)), named("robot.bin", buffer));
    assert.deepEqual(await partNames(page), ["base", "arm"]);
    assert.equal(await page.locator("#mesh-error").count(), 0);
  });
});

test("what is not a mesh is refused with the reason, and what was shown stays", async () => {
  await on("#meshes", async (page) => {
    const refused = [
      ["notes.txt", "Dear diary", "notes.txt: it is not a mesh; the formats are STL, OBJ, PLY, glTF and GLB"],
      ["cloud.ply", ply({ ...cube(), faces: [] }), "cloud.ply: there are no triangles in it"],
      ["short.stl", binaryStl(cube()).subarray(0, 300), /^short\.stl: (it is not a mesh|it is not a valid STL file|there are no triangles)/],
      ["empty.obj", "", "empty.obj: it is not a mesh; the formats are STL, OBJ, PLY, glTF and GLB"],
      ["scene.gltf", "{", /^scene\.gltf: it is not a valid glTF file: /],
      ["old.gltf", '{"asset": {"version": "1.0"}}', /^old\.gltf: it is not a valid glTF file: /],
      ["holes.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n", /^holes\.obj: vertex 2 of .* has a coordinate that is missing or not a finite number$/],
    ];
    for (const [name, content, message] of refused) {
      const said = await refusal(page, named(name, content));
      if (typeof message === "string") assert.equal(said, message);
      else assert.match(said, message);
      assert.equal(await figure(page, "source"), "gears");
    }
    await openFiles(page, named("cube.stl", textStl(cube())));
    assert.equal(await page.locator("#mesh-error").count(), 0);
  });
});

test("files dropped on any tab open here, several at once, and a scene opens in its own tab", async () => {
  await on("#rays", async (page) => {
    const drop = (files) => page.evaluate((all) => {
      const transfer = new DataTransfer();
      for (const [name, text] of all) transfer.items.add(new File([text], name));
      window.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }, files);
    await drop([["a.obj", obj({ left: cube(0), right: cube(3) })], ["b.ply", ply(cube(6))]]);
    await page.waitForFunction(() => document.querySelector("#figure-source")?.textContent === "a.obj, b.ply");
    assert.deepEqual(await partNames(page), ["left", "right", "b"]);
    await drop([["table.csv", "id,min_x,min_y,max_x,max_y\na,0,0,1,1\n"]]);
    await page.waitForSelector('html[data-chapter="scene"]');
  });
});

test("the face under the pointer is found, with its normal and where on it, and a link shows it again", async () => {
  await on("#meshes?mode=faces", async (page) => {
    await openFiles(page, named("cube.stl", textStl(cube())));
    const { x, y } = await middleOf(page);
    await page.mouse.move(x, y - 60);
    await page.waitForFunction(() => document.querySelector("#figure-face")?.textContent !== "–");
    assert.equal(await figure(page, "normal"), "(0, 0, 1.000)");
    assert.match(await figure(page, "face"), /^[23]$/);
    const weights = (await figure(page, "barycentric")).slice(1, -1).split(", ").map(Number);
    assert.ok(Math.abs(weights.reduce((sum, value) => sum + value, 0) - 1) < 0.002, String(weights));
    const point = (await figure(page, "point")).slice(1, -1).split(", ").map(Number);
    assert.equal(point[2], 1);
    assert.match(await page.locator("#overlay text").textContent(), /^face [23]$/);
    await page.mouse.move(x - 60, y + 40);
    await page.waitForFunction(() => document.querySelector("#figure-normal")?.textContent !== "(0, 0, 1.000)");
  });
  await on("#meshes?example=knot", async (page) => {
    const { x, y } = await middleOf(page);
    for (let i = 0; i < 12 && (await figure(page, "face")) === "–"; ++i) await page.mouse.move(x + 12 * i, y - 9 * i);
    const face = await figure(page, "face");
    await page.waitForFunction(() => location.hash.includes("to-x="));
    const shown = page.url();
    await page.goto("about:blank");
    await page.goto(shown);
    await page.waitForSelector("html[data-chapter]");
    assert.equal(await figure(page, "face"), face);
  });
});

test("a hundred thousand faces open, and are picked in less than a millisecond each", { timeout: 120_000 }, async () => {
  await on("#meshes?mode=faces", async (page) => {
    await openFiles(page, named("sheet.stl", binaryStl(sheet(225))));
    assert.equal(await numberIn(page, "faces"), 2 * 224 ** 2);
    const { x, y } = await middleOf(page);
    await page.mouse.move(x, y);
    await page.waitForFunction(() => document.querySelector("#figure-face")?.textContent !== "–");
    assert.match(await figure(page, "ray-time"), /µs$|^0\.\d+ ms$/);
    assert.equal(await figure(page, "closed"), "no");
    assert.equal(await numberIn(page, "open"), 4 * 224);
  });
});

test("a finger picks a face by a tap, and turns the view by a drag", async () => {
  await on("#meshes?example=knot", async (page) => {
    const { x, y } = await middleOf(page);
    for (let i = 0; i < 12 && (await figure(page, "face")) === "–"; ++i) await page.touchscreen.tap(x + 8 * i, y - 5 * i);
    assert.match(await figure(page, "part"), /^(trefoil|ring)$/);
  }, { viewport: { width: 390, height: 760 }, hasTouch: true, isMobile: true });
});

const twoCubes = obj({ low: cube(0), high: cube(0.25, 0.5) });

test("a part that is dragged into another touches it, and the faces that touch turn orange", async () => {
  await on("#meshes?mode=contacts", async (page) => {
    // Beside each other as seen by the camera, whose right is about (0.83, -0.56, 0).
    await openFiles(page, named("cubes.obj", obj({ low: cube(0), high: cube([1.5, -0.75, 0.25], 0.5) })));
    await page.locator("#part-list button").nth(1).click();
    assert.equal(await figure(page, "touched"), "nothing");
    assert.equal(await figure(page, "distance"), Math.hypot(0.5, 0.25).toFixed(4));
    const from = await placeOf(page, "move");
    await drag(page, from, { x: from.x - 130, y: from.y });
    await page.waitForFunction(() => document.querySelector("#figure-touched")?.textContent === "low");
    assert.ok((await numberIn(page, "pairs")) > 0);
    assert.ok((await numberIn(page, "points")) > 0);
    assert.notEqual(await figure(page, "depth"), "–");
    assert.match(await page.locator("#caption").textContent(), /^high touches 1 part: low$/);
    await page.getByRole("button", { name: "Back to the start" }).click();
    assert.equal(await figure(page, "touched"), "nothing");
  });
});

test("contacts are moved by keys and restored by a link", async () => {
  await on("#meshes?dx=3", async (page) => {
    assert.equal(await figure(page, "touched"), "nothing");
    const before = await figure(page, "distance");
    await page.locator('#overlay circle[data-key="move"]').focus();
    for (let i = 0; i < 4; ++i) await page.keyboard.press("Shift+ArrowLeft");
    await page.waitForFunction((old) => document.querySelector("#figure-distance").textContent !== old, before);
    await page.keyboard.press("[");
    await page.waitForFunction(() => /q[xyz]=/.test(location.hash));
    await page.waitForFunction(() => document.querySelector("#figure-distance").textContent !== "…");
    const [pose, distance] = [page.url(), await figure(page, "distance")];
    await page.goto("about:blank");
    await page.goto(pose);
    await page.waitForSelector("html[data-chapter]");
    const restored = await figure(page, "distance");
    assert.ok(Math.abs(Number(restored) - Number(distance)) < 0.01, `${restored} and ${distance}: ${pose}`);
  });
});

test("gears that are turned into each other overlap in hatched faces", async () => {
  await on("#meshes", async (page) => {
    assert.equal(await figure(page, "touched"), "left gear");
    assert.ok((await numberIn(page, "pairs")) > 4);
    const [{ x, y }] = [await placeOf(page, "move")];
    await page.mouse.move(x + 60, y + 20);
    await drag(page, { x: x + 30, y: y - 10 }, { x: x + 260, y: y - 10 });
    await page.waitForFunction(() => document.querySelector("#figure-touched").textContent === "nothing");
    assert.equal(await figure(page, "pairs"), "0");
  });
});

/** Moves the query point of a slice to a place in the drawing. */
async function moveProbe(page, to) {
  await drag(page, await placeOf(page, "probe"), to);
}

test("a slice shows winding numbers, and distances that are negative inside", async () => {
  await on("#meshes?mode=inside&example=knot", async (page) => {
    await openFiles(page, named("cubes.obj", twoCubes));
    await page.waitForFunction(() => /^65.536 of 65.536$/.test(document.querySelector("#figure-points")?.textContent ?? ""));
    assert.equal(await figure(page, "value"), "2.000");
    const middle = await placeOf(page, "probe");
    assert.match(await page.locator("#overlay text").allTextContents().then(String), /winding number 2\.000/);
    await page.getByRole("button", { name: "Signed distance" }).click();
    assert.equal(await figure(page, "value"), "−0.5000");
    await page.getByRole("button", { name: "Winding number" }).click();
    await moveProbe(page, { x: middle.x + 400, y: middle.y });
    assert.equal(await figure(page, "value"), "0");
    await page.waitForTimeout(300);
    const orange = await colourAt(page, { x: Math.round(middle.x) + 9, y: Math.round(middle.y) + 4 });
    assert.ok(orange[0] > orange[2] + 40, `where two cubes overlap: ${orange}`);
    await page.getByRole("slider", { name: "Position of the slice" }).fill("0.1");
    await page.waitForFunction(() => document.querySelector("progress").hidden);
    await page.waitForTimeout(300);
    assert.match(page.url(), /at=0\.1/);
  });
});

test("inside a broken mesh the winding number is between 0 and 1 near its holes, and its report counts them", async () => {
  await on("#meshes?example=broken", async (page) => {
    assert.equal(await figure(page, "closed"), "no");
    for (const fault of ["open", "non_manifold", "flipped"]) assert.ok((await numberIn(page, fault)) > 0, fault);
    assert.equal(await page.locator("#legend .swatch").count(), 3);
    const value = Number(await figure(page, "value"));
    assert.ok(value > 0.5 && value < 1 && !Number.isInteger(value), String(value));
    await page.getByRole("button", { name: "Find faces that cross others" }).click();
    assert.match(await figure(page, "crossings"), /pairs? in /);
  });
});

test("the page answers while a slice of a large mesh is calculated", { timeout: 120_000 }, async () => {
  await on("#meshes?example=knot", async (page) => {
    const ticks = await page.evaluate(async () => {
      let ticks = 0;
      const timer = setInterval(() => ++ticks, 5);
      [...document.querySelectorAll("#mesh-modes button")].find((button) => button.textContent === "Inside").click();
      [...document.querySelectorAll("button")].find((button) => button.textContent === "Signed distance").click();
      ticks = 0;
      while (!document.querySelector("progress").hidden) await new Promise((resolve) => setTimeout(resolve, 20));
      clearInterval(timer);
      return ticks;
    });
    assert.ok(ticks >= 5, `the page ran ${ticks} times`);
  });
});

test("solids and surfaces differ in what is inside", async () => {
  await on("#meshes?mode=inside", async (page) => {
    await openFiles(page, named("cube.stl", textStl(cube())));
    await page.getByRole("button", { name: "Signed distance" }).click();
    assert.equal(await figure(page, "value"), "−0.5000");
    await page.getByLabel("Solid: what is enclosed counts").uncheck();
    assert.equal(await figure(page, "value"), "0.5000");
    await page.waitForFunction(() => location.hash.includes("kind=surface"));
  });
});
