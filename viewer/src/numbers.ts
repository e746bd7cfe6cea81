// SPDX-License-Identifier: MIT
// Formats numbers for display.

/** A measured length or angle: at least three significant digits, no exponent unless necessary. */
export function measure(value: number): string {
  if (value === 0) return "0";
  if (!Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) return value.toExponential(2).replace("-", "\u2212");
  const digits = size >= 100 ? 1 : size >= 1 ? 3 : 4;
  return value.toFixed(digits).replace("-", "\u2212");
}

/** A vector in parentheses. */
export function vector(values: ArrayLike<number>): string {
  return `(${Array.from(values, measure).join(", ")})`;
}

/** A count with thin spaces between thousands: 12 345. */
export function count(value: number): string {
  return String(value).replace(/\B(?=(\d{3})+$)/g, "\u202f");
}

/** Milliseconds, with the precision of a browser's clock. */
export function milliseconds(value: number): string {
  return `${value.toFixed(value < 10 ? 2 : 1)} ms`;
}

/** A measured time in a suitable unit. */
export function duration(value: number): string {
  return value < 0.1 ? `${(value * 1000).toFixed(value < 0.01 ? 1 : 0)} µs` : milliseconds(value);
}

/** "1 pair", "2 pairs". */
export function counted(value: number, noun: string): string {
  return `${count(value)} ${noun}${value === 1 ? "" : "s"}`;
}

/** Rounded so that links stay short; a link restores the rounded value. */
export function rounded(value: number): number {
  return Math.round(value * 1e4) / 1e4;
}
