// SPDX-License-Identifier: MIT
// Values on their way to C++, which reads them as it reads scene files.

/**
 * A value as JSON, but for what JSON.stringify would change without a word: negative zero keeps its sign, typed arrays are
 * arrays, and numbers that are not finite are an error.
 */
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
    const fields = Object.entries(value).filter(([, held]) => held !== undefined);
    const inner = (name) => (field ? `${field}.${JSON.stringify(name)}` : JSON.stringify(name));
    return `{${fields.map(([name, held]) => `${JSON.stringify(name)}: ${textOf(held, role, inner(name))}`).join(", ")}}`;
  }
  return JSON.stringify(value) ?? "null";
}

/** How many numbers the first vector within a value has; 0 if there is none. */
function firstVector(value) {
  if (ArrayBuffer.isView(value)) return value.length;
  if (Array.isArray(value) && typeof value[0] === "number") return value.length;
  if (typeof value !== "object" || value === null) return 0;
  for (const inner of Object.values(value)) {
    const length = firstVector(inner);
    if (length > 0) return length;
  }
  return 0;
}

/** The dimension that a question about these values has. Nonsense gets one too, which C++ then complains about. */
export function dimensionOf(...values) {
  for (const value of values) {
    const length = firstVector(value);
    if (length > 0) return length === 2 ? 2 : 3;
  }
  return 2;
}

/** A point as the shape that it is. */
export const pointText = (point) => textOf({ type: "point", position: point }, "point");

/** A ray whose type may be left out. */
export function rayText(ray) {
  if (ray?.type !== undefined && ray.type !== "ray") throw new Error(`ray: its type is ${ray.type}, not ray`);
  return textOf({ ...ray, type: "ray" }, "ray");
}

/** The names and numbers of layers, or nothing for all of them. */
export const layersText = (layers) => (layers === undefined ? "" : textOf(layers, "layers"));
