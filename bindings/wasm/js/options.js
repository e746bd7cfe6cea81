// SPDX-License-Identifier: MIT
// Options of queries: their checks, and the filter by which queries of a scene choose objects.
import { refused } from "./arguments.js";
import { finiteNumber } from "./core.js";
import { layersText } from "./text.js";

/** The options; throws for a field that is not among the names. */
export function known(options, names) {
  if (options === undefined) return {};
  const allowed = () => names.map((name) => `"${name}"`).join(", ");
  if (typeof options !== "object" || options === null || Array.isArray(options)) {
    throw new Error(`options: must be an object with any of the fields ${allowed()}`);
  }
  const unknown = Object.keys(options).find((name) => !names.includes(name));
  if (unknown === undefined) return options;
  throw new Error(`options: unknown field "${unknown}"; the fields are ${allowed()}`);
}

/** A finite number of at least zero. */
export function lengthOf(value, role) {
  if (finiteNumber(value, role) >= 0) return value;
  throw new Error(`${role}: it is ${value}; it must not be negative`);
}

export function yesOrNo(value, role) {
  if (typeof value === "boolean") return value;
  throw new Error(`${role}: it must be true or false, not ${typeof value === "string" ? `"${value}"` : value}`);
}

/** The options that `filterOf` reads. */
export const filterFields = ["layers", "except", "predicate"];

/** What C++ needs to know which objects may be found. `except` is an argument of the kind `list`. */
export function filterOf({ layers, except = [], predicate }) {
  if (!Array.isArray(except) && !ArrayBuffer.isView(except)) {
    throw new Error("except: must be an array of ids; for one id write [id]");
  }
  if (predicate !== undefined && typeof predicate !== "function") {
    throw new Error("predicate: must be a function that takes an id and returns whether the object may be found");
  }
  return { layers: layersText(layers), except, predicate };
}

/** The scenes with queries that are calling their predicates. */
const asked = new Set();

export const isAsked = (scene) => asked.has(scene);

/** Calls ask(predicate), where C++ can call the predicate: it returns 2 instead of throwing, because an exception must
 * not pass through C++, and `guarded` throws it in the end. Meanwhile nothing may change the scene. */
export function guarded(scene, predicate, ask) {
  if (predicate === undefined) return ask(undefined);
  let caught;
  const isNested = asked.has(scene);
  asked.add(scene);
  try {
    return ask((id) => {
      try {
        return predicate(id) ? 1 : 0;
      } catch (error) {
        caught = { error };
        return 2;
      }
    });
  } catch (error) {
    throw caught === undefined ? error : caught.error;
  } finally {
    if (!isNested) asked.delete(scene);
  }
}

/** A kind of argument: numbers, preceded by their count. */
export const list = (role) => ({
  write(args, values, n) {
    args.number(values.length, n);
    for (let i = 0; i < values.length; ++i) if (args.number(values[i], n) === refused) return refused;
    return n;
  },
  spell: (core, values) => [values.length, ...Array.from(values, (value) => finiteNumber(value, role))],
});
