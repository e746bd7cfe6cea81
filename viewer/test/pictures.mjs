// SPDX-License-Identifier: MIT
// Creates the pictures docs/pictures/viewer_*.png: run `npm run pictures` and check them.
import { openBrowser, openPage, root, serveViewer } from "./browser.mjs";

/** Used for busy drawings, so that no picture exceeds 200 kB. */
const small = { viewport: { width: 940, height: 600 } };

const views = [
  ["intersections", "#intersections?selected=3", {}],
  ["intersections_space", "#intersections?dimension=3&selected=2", {}],
  ["closest_points", "#closest-points", {}],
  ["rays", "#rays?mode=fan", {}],
  ["rays_space", "#rays?mode=fan&dimension=3&rays=1440", {}],
  ["casts_space", "#rays?mode=cast&dimension=3&moving=obb&size=0.5&turn=90&x=-2.6&y=-0.7&z=1.4&to-x=2.4&to-y=0.9&to-z=1.2", {}],
  ["casts", "#rays?mode=cast&moving=obb&size=0.5&turn=90&x=-4.4&y=0.3&to-x=3.4&to-y=0.5", {}],
  ["walk", "#walk", {}, { key: "ArrowRight", until: ({ x }) => x > 1.9 }],
  ["walk_space", "#walk?dimension=3&x=-1.11&y=2&z=0.61", {}],
  ["bounding_volumes", "#bounding-volumes", {}],
  ["quad_tree", "#trees?play=no", {}],
  ["octree", "#trees?play=no&dimension=3&count=60&radius=0.6", small],
  ["broad_phase", "#broad-phase?play=no&count=1000&crowd=0.15", small],
  ["meshes_contacts", "#meshes", small],
  ["meshes_faces", "#meshes?example=broken&mode=faces&x=-2.9465&y=-4.5013&z=3.8741&to-x=-0.5616&to-y=-0.4459&to-z=1.7178", small],
  ["meshes_inside", "#meshes?example=broken", small],
  ["scene", "#scene?example=workshop", small],
  ["scene_2d", "#scene?example=platform+level&select=giant+slime", {}],
  ["frames", "#scene?example=crossing&frame=54", {}],
  ["object", "#scene?example=workshop&select=rafter+3", small],
  ["dark", "#intersections?show=manifold", { colorScheme: "dark" }],
  ["phone", "#trees?play=no", { viewport: { width: 390, height: 760 } }],
];

/** Holds a key down until the place in the link fulfils a condition. */
async function walkTo(page, { key, until }) {
  const place = async () => Object.fromEntries([...new URLSearchParams(new URL(page.url()).hash.split("?")[1])].map(([name, text]) => [name, Number(text)]));
  await page.keyboard.down(key);
  for (let i = 0; i < 100 && !until(await place()); ++i) await page.waitForTimeout(100);
  await page.keyboard.up(key);
}

const only = process.argv.slice(2);
const folder = process.env.GRAZE_PICTURES ?? `${root}docs/pictures/`;
const [browser, server] = await Promise.all([openBrowser(), serveViewer()]);
for (const [name, hash, options, walk] of views) {
  if (only.length > 0 && !only.includes(name)) continue;
  const { page, heard } = await openPage(browser, `${server.address}${hash}`, { viewport: { width: 1100, height: 660 }, ...options });
  if (walk !== undefined) await walkTo(page, walk);
  for (let i = 0; i < 8 && hash.includes("play=no"); ++i) await page.keyboard.press(".");
  await page.waitForTimeout(500);
  await page.screenshot({ path: `${folder}viewer_${name}.png` });
  for (const complaint of heard.complaints) console.error(`${name}: ${complaint}`);
  await page.close();
}
await browser.close();
server.close();
