// SPDX-License-Identifier: MIT
// Values passed to C++ as text, which is read like scene files.

/** The method by which an object that is used like a shape returns a plain one; its `dimension` is known. */
export const plain = Symbol("plain");

/** A value as JSON, without the silent changes of JSON.stringify: negative zero keeps its sign, typed arrays become
 * arrays, and numbers that are not finite are errors. */
export function textOf(value, role, field = "") {
  if (typeof value === "number") {
    if (!Number.isFinite(value)) throw new Error(`${role}: ${field || "it"} is ${value}; numbers must be finite`);
    return Object.is(value, -0) ? "-0.0" : String(value);
  }
  if (typeof value === "bigint") return String(value);
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    return `[${Array.from(value, (item, i) => textOf(item, role, `${field}[${i}]`)).join(", ")}]`;
  }
  if (typeof value === "object" && value !== null) {
    if (value[plain] !== undefined) return textOf(value[plain](), role, field);
    const fields = Object.entries(value).filter(([, held]) => held !== undefined);
    const inner = (name) => (field ? `${field}.${JSON.stringify(name)}` : JSON.stringify(name));
    return `{${fields.map(([name, held]) => `${JSON.stringify(name)}: ${textOf(held, role, inner(name))}`).join(", ")}}`;
  }
  return JSON.stringify(value) ?? "null";
}

/** The number of numbers in the first vector within a value; 0 if there is none. */
function firstVector(value) {
  if (ArrayBuffer.isView(value)) return value.length;
  if (Array.isArray(value) && typeof value[0] === "number") return value.length;
  if (typeof value !== "object" || value === null) return 0;
  if (value[plain] !== undefined) return value.dimension;
  for (const inner of Object.values(value)) {
    const length = firstVector(inner);
    if (length > 0) return length;
  }
  return 0;
}

/** The dimension of a query on these values. Invalid values get one too; C++ then reports the error. */
export function dimensionOf(...values) {
  for (const value of values) {
    const length = firstVector(value);
    if (length > 0) return length === 2 ? 2 : 3;
  }
  return 2;
}

/** A point as a shape. */
export const pointText = (point) => textOf({ type: "point", position: point }, "point");

/** A ray that may omit its type. */
export function rayText(ray) {
  if (ray?.type !== undefined && ray.type !== "ray") throw new Error(`ray: its type is ${ray.type}, not ray`);
  return textOf({ ...ray, type: "ray" }, "ray");
}

/** Layers by name and number; an empty text for all. */
export const layersText = (layers) => (layers === undefined ? "" : textOf(layers, "layers"));
