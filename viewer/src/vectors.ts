// SPDX-License-Identifier: MIT
// Vectors of two or three numbers. Both operands have the same length.

export function plus<V extends readonly number[]>(a: V, b: V): V {
  return mapped(a, (value, axis) => value + (b[axis] ?? 0));
}

export function minus<V extends readonly number[]>(a: V, b: V): V {
  return mapped(a, (value, axis) => value - (b[axis] ?? 0));
}

export function times<V extends readonly number[]>(a: V, factor: number): V {
  return mapped(a, (value) => value * factor);
}

/** The middle of two points. */
export function between<V extends readonly number[]>(a: V, b: V): V {
  return mapped(a, (value, axis) => (value + (b[axis] ?? 0)) / 2);
}

export function dot(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Array.from(a).reduce((sum, value, axis) => sum + value * (b[axis] ?? 0), 0);
}

export function lengthOf(a: readonly number[]): number {
  return Math.hypot(...a);
}

/** The type checker cannot tell that the length is unchanged. */
function mapped<V extends readonly number[]>(a: V, map: (value: number, axis: number) => number): V {
  return a.map(map) as unknown as V;
}
