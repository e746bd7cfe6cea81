// SPDX-License-Identifier: MIT
// Files that are dropped on the page, and the scenes bundled with it.
import levelMap from "../../../data/platform_level.tmx?raw";
import levelProps from "../../../data/platform_props.tsx?raw";
import levelTiles from "../../../data/platform_tiles.tsx?raw";
import coin from "../../../data/templates/coin.tx?raw";
import crate from "../../../data/templates/crate.tx?raw";
import spike from "../../../data/templates/spike.tx?raw";
import crossing from "../../../data/crossing.json?raw";
import workshop from "../../../data/workshop.json?raw";
import type { CheckReport } from "graze";
import type { SceneSource } from "./scene_model";

export const examples: Readonly<Record<string, SceneSource>> = {
  workshop: { name: "workshop.json", content: workshop },
  crossing: { name: "crossing.json", content: crossing },
  "platform level": {
    name: "platform_level.tmx",
    content: levelMap,
    files: {
      "platform_props.tsx": levelProps,
      "platform_tiles.tsx": levelTiles,
      "templates/coin.tx": coin,
      "templates/crate.tx": crate,
      "templates/spike.tx": spike,
    },
  },
};

const scenes = /\.(json|csv|tmx|tmj|xml|aabbs)$/i;

/** Whether a file is a scene, by its name. */
export function isSceneFile(file: File): boolean {
  return scenes.test(file.name);
}

/** The scene among files that were dropped together; a Tiled map may refer to the others. */
export async function sourceOf(files: readonly File[]): Promise<SceneSource> {
  const scene = files.find(isSceneFile) ?? files[0];
  if (scene === undefined) throw new Error("no file was given");
  const others = files.filter((file) => file !== scene);
  const texts = new Map<string, string>();
  for (const file of others) texts.set(file.name, await file.text());
  const content = new Uint8Array(await scene.arrayBuffer());
  if (others.length === 0) return { name: scene.name, content };
  const all = [new TextDecoder().decode(content), ...texts.values()].join("\n");
  const named = [...texts].flatMap(([name, text]) => pathsOf(name, all).map((path) => [path, text] as const));
  return { name: scene.name, content, files: Object.fromEntries(named) };
}

/** The paths by which other files may refer to a dropped file, whose folder is unknown. */
function pathsOf(name: string, text: string): string[] {
  const escaped = name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  const quoted = text.matchAll(new RegExp(`"((?:[^"\\n]*/)?${escaped})"`, "g"));
  return [...new Set([name, ...Array.from(quoted, (match) => match[1] ?? name)])];
}

const report = document.getElementById("graze-report")?.textContent?.trim() ?? "";

/** True for a page that `graze view` or `graze check --html` wrote. */
export const isReport = report !== "";

/** The scene in such a page, with the result of its check. */
export function reportedSource(): SceneSource {
  const data = JSON.parse(report) as { source: string; scene: string; check: CheckReport };
  return { name: data.source, content: data.scene, check: data.check };
}
