// SPDX-License-Identifier: MIT
// The first contact of moving shapes.
import { refused, shape, vector } from "./arguments.js";
import { finiteNumber, numbersOf } from "./core.js";
import { known, lengthOf, yesOrNo } from "./options.js";

const zeros = [null, null, [0, 0], [0, 0, 0]];

/** An unknown field of a motion, if there is one. */
const unknownField = (motion) =>
  Object.keys(motion).find((name) => name !== "linear" && name !== "angular" && name !== "center");

/** Translation, rotation and center as consecutive numbers; missing fields are zero. */
export const motion = (role) => ({
  write(args, value, n) {
    if (n === 0 || typeof value !== "object" || value === null || unknownField(value) !== undefined) return refused;
    const { linear = zeros[n], angular = n === 2 ? 0 : zeros[n], center = zeros[n] } = value;
    if (args.vector(linear, n) === refused) return refused;
    if ((n === 2 ? args.number(angular, n) : args.vector(angular, n)) === refused) return refused;
    return args.vector(center, n);
  },
  spell(core, value, n) {
    if (typeof value !== "object" || value === null) {
      throw new Error(`${role}: must be an object with any of the fields "linear", "angular", "center"`);
    }
    const unknown = unknownField(value);
    if (unknown !== undefined) {
      throw new Error(`${role}: unknown field "${unknown}"; the fields are "linear", "angular", "center"`);
    }
    const { linear = zeros[n], angular = n === 2 ? 0 : zeros[n], center = zeros[n] } = value;
    return [
      ...numbersOf(linear, n, `${role}.linear`),
      ...(n === 2 ? [finiteNumber(angular, `${role}.angular`)] : numbersOf(angular, n, `${role}.angular`)),
      ...numbersOf(center, n, `${role}.center`),
    ];
  },
});

const linearMotion = [shape("a"), shape("b"), vector("motion")];
const motions = [shape("a"), shape("b"), motion("motionA"), motion("motionB")];

const readImpact = (result, answer) => (answer.isAtEnd ? null : answer.hit());

export const casts = (core) => ({
  shapeCast(a, way, b, options) {
    const { ignoreInitialTouch = false, targetDistance = 0 } = known(options, ["ignoreInitialTouch", "targetDistance"]);
    const ignores = yesOrNo(ignoreInitialTouch, "ignoreInitialTouch");
    const distance = lengthOf(targetDistance, "targetDistance");
    const ask = (dimension, place) => core.module.shapeCast(dimension, place, ignores, distance);
    return core.arguments.ask(linearMotion, [a, b, way], ask, readImpact);
  },

  timeOfImpact: (a, motionA, b, motionB = {}) =>
    core.arguments.ask(motions, [a, b, motionA, motionB], core.module.timeOfImpact, readImpact),
});
