// SPDX-License-Identifier: MIT
// When shapes that move first touch.
import { finiteNumber, numbersOf, Reader } from "./core.js";
import { dimensionOf, textOf } from "./text.js";

/** The way of the center, the turn and the center in a row; what is left out is zero. */
function motionNumbers(motion, dimension, role) {
  const unknown = Object.keys(motion).find((name) => !["linear", "angular", "center"].includes(name));
  if (unknown !== undefined) {
    throw new Error(`${role}: unknown field "${unknown}"; the fields are "linear", "angular", "center"`);
  }
  const zero = Array(dimension).fill(0);
  const { linear = zero, angular = dimension === 2 ? 0 : zero, center = zero } = motion;
  return [
    ...numbersOf(linear, dimension, `${role}.linear`),
    ...(dimension === 2
      ? [finiteNumber(angular, `${role}.angular`)]
      : numbersOf(angular, dimension, `${role}.angular`)),
    ...numbersOf(center, dimension, `${role}.center`),
  ];
}

function impactIn(core, dimension) {
  const answer = new Reader(core.answer(), dimension);
  return answer.isAtEnd ? null : answer.hit();
}

export const casts = (core) => ({
  shapeCast(a, motion, b) {
    const dimension = dimensionOf(a, b, motion);
    core.give([numbersOf(motion, dimension, "motion")]);
    core.checked(core.module.shapeCast(dimension, textOf(a, "a"), textOf(b, "b")));
    return impactIn(core, dimension);
  },

  timeOfImpact(a, motionA, b, motionB = {}) {
    const dimension = dimensionOf(a, b);
    core.give([motionNumbers(motionA, dimension, "motionA"), motionNumbers(motionB, dimension, "motionB")]);
    core.checked(core.module.timeOfImpact(dimension, textOf(a, "a"), textOf(b, "b")));
    return impactIn(core, dimension);
  },
});
