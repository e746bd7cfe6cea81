// SPDX-License-Identifier: MIT
// The locations of native programs, and comparisons. `./dev web test` sets the locations.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../../..", import.meta.url));
export const packageFolder = process.env.GRAZE_PACKAGE ?? join(root, "build/web/package");

const program = (variable, fallback) => {
  const path = process.env[variable] ?? join(root, fallback);
  assert.ok(existsSync(path), `${path} does not exist; ./dev web test builds it`);
  return path;
};

/** Runs the command-line program with the arguments and returns its output. */
export const graze = (...args) =>
  execFileSync(program("GRAZE_CLI", "build/gcc/bin/graze"), args, { cwd: root, encoding: "utf8", maxBuffer: 2 ** 30 });

/** The results of the native library: a function that reads one of its files. */
export function nativeAnswers() {
  const folder = mkdtempSync(join(tmpdir(), "graze-answers-"));
  process.on("exit", () => rmSync(folder, { recursive: true }));
  execFileSync(program("GRAZE_ANSWERS", "build/gcc/bin/graze_answers"), [folder]);
  return (name) => readFileSync(join(folder, name));
}

/** Loads the packaged module. */
export async function loadGraze() {
  const { createGraze } = await import(join(packageFolder, "graze.js"));
  return createGraze();
}

/** Compares two texts; for long ones the error shows the first line that differs. */
export function assertSameText(ours, native) {
  if (ours === native) return;
  const [a, b] = [ours.split("\n"), native.split("\n")];
  const line = a.findIndex((text, i) => text !== b[i]);
  assert.fail(`line ${line + 1} of ${a.length} and ${b.length}:\n${a[line]}\n${b[line]}`);
}

const asText = (number) => (Number.isFinite(number) ? (Object.is(number, -0) ? "-0" : String(number)) : `"${number}"`);

/** Compares two lists of numbers bit for bit, where all NaN are equal. Infinities in the native results are texts. */
export function assertSameBits(ours, native, about) {
  const same = ours.length === native.length && native.every((value, i) => Object.is(ours[i], Number(value)));
  if (same) return;
  const first = native.findIndex((value, i) => !Object.is(ours[i], Number(value)));
  assert.fail(`${about()}\nlengths ${ours.length} and ${native.length}, first difference at ${first}: ` +
    `${asText(ours[first])} and ${native[first]}`);
}

// The numbers of results in the order of answers.cpp; none for null.

export const hitNumbers = (hit) => (hit === null ? [] : [hit.t, ...hit.point, ...hit.normal, hit.error]);

export const contactNumbers = (found) =>
  (found === null ? [] : [...found.point, ...found.pointA, ...found.pointB, ...found.normal, found.depth, found.error]);

const featureKinds = ["vertex", "edge", "face"];

const idNumbers = ({ a, b, partA, partB }) => [
  ...[a, b].flatMap(({ kind, index }) => [featureKinds.indexOf(kind), index]),
  partA,
  partB,
];

export const manifoldNumbers = ({ normal, error, points }) => [
  ...normal,
  error,
  ...points.flatMap((each) => [...each.point, ...each.pointA, ...each.pointB, each.depth, ...idNumbers(each.id)]),
];
