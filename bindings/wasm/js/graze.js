// SPDX-License-Identifier: MIT
// graze for JavaScript. graze.d.ts documents the interface.
import { Arguments } from "./arguments.js";
import { casts } from "./casts.js";
import { Core } from "./core.js";
import loadModule from "./graze_wasm.js";
import { indexClasses } from "./indexes.js";
import { meshParts } from "./meshes.js";
import { pairFinderClass, pairFunctions } from "./pairs.js";
import { queries } from "./queries.js";
import { recordingParts } from "./recordings.js";
import { sceneParts } from "./scene.js";

/** Ids have 29 bits for the slot. */
const places = 2 ** 29;

/** Node reads files instead of fetching them; its modules are named so that bundlers for browsers do not find them. */
async function readFromDisk() {
  const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ ["node:fs", "promises"].join("/"));
  return readFile(new URL("graze_wasm.wasm", import.meta.url));
}

const isNode = () => typeof process === "object" && process.versions?.node !== undefined;

export async function createGraze({ wasmBinary, locateFile } = {}) {
  const options = {};
  if (locateFile) options.locateFile = locateFile;
  if (wasmBinary) options.wasmBinary = wasmBinary;
  else if (isNode() && !locateFile) options.wasmBinary = await readFromDisk();
  const module = await loadModule(options);
  const core = new Core(module);
  core.arguments = new Arguments(core);
  return Object.freeze({
    version: module.version(),
    ...queries(core),
    ...casts(core),
    ...meshParts(core),
    ...pairFunctions(core),
    PairFinder: pairFinderClass(core),
    ...indexClasses(core),
    ...sceneParts(core),
    ...recordingParts(core),
    slotOf: (id) => id % places,
    get memoryBytes() {
      return module.HEAPU8.length;
    },
    get usedBytes() {
      return module.usedBytes();
    },
  });
}

export default createGraze;
