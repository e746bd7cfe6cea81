// SPDX-License-Identifier: MIT
// Measures times below the resolution of a browser's clock, which is a tenth of a millisecond.

/** Long enough for an accuracy of a few percent, short enough not to be noticed. */
const leastTotal = 2;
const mostRepeats = 200;

/** The mean time of an action in milliseconds, repeated until it is measurable. The action must not change anything. */
export function timeOf(action: () => void): number {
  const start = performance.now();
  let spent = 0;
  let repeats = 0;
  while (spent < leastTotal && repeats < mostRepeats) {
    action();
    ++repeats;
    spent = performance.now() - start;
  }
  return spent / repeats;
}
