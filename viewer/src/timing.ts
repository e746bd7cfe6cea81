// SPDX-License-Identifier: MIT
// Times of what takes less than a browser's clock resolves, which is a tenth of a millisecond.

/** Long enough to be measured to some percent, short enough not to be felt. */
const leastTotal = 2;
const mostRepeats = 200;

/** Milliseconds that an action takes, repeated until the clock can tell; the mean. It must change nothing. */
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
