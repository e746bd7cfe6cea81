// SPDX-License-Identifier: MIT
// All overlapping pairs of many boxes.
import { shapes } from "./arguments.js";
import { Held, knownDimension, rowsOf, wholeNumber } from "./core.js";

function isSorted(order) {
  if (order !== "sorted" && order !== "any") throw new Error(`order: it is ${order}; it must be sorted or any`);
  return order === "sorted";
}

/** Typed arrays are passed unchanged; plain arrays are converted to doubles. */
function isDouble(numbers) {
  return !(numbers instanceof Float32Array);
}

const listOfShapes = [shapes("shapes")];

export function pairFunctions(core) {
  const find = (lists, dimension, { order = "sorted", margin = 0, method = "automatic" } = {}) => {
    const width = 2 * knownDimension(dimension);
    const counts = lists.map((list) => rowsOf(list, width, "boxes"));
    const isInDoubles = isDouble(lists[0]);
    if (lists.some((list) => isDouble(list) !== isInDoubles)) {
      throw new Error("boxes: both sets must be of one type, Float32Array or Float64Array");
    }
    const wanted = { dimension, isDouble: isInDoubles, sorted: isSorted(order), margin, method };
    core.give(lists, !isInDoubles);
    return taken(core.checked(core.module.overlappingPairs(wanted, counts[0], counts[1] ?? -1)));
  };
  const taken = (pairs) => {
    const first = core.module.pairsAddress() / 4;
    const found = core.module.HEAPU32.slice(first, first + 2 * pairs);
    core.module.releasePairs();
    return found;
  };
  return {
    touchingPairs(among, candidates) {
      if (!(candidates instanceof Uint32Array)) throw new Error("candidates: must be a Uint32Array");
      const count = rowsOf(candidates, 2, "candidates");
      const ask = (dimension, place) => {
        core.give([candidates]);
        return core.module.touchingPairs(dimension, place, count);
      };
      return core.arguments.ask(listOfShapes, [among], ask, taken);
    },
    overlappingPairs: (boxes, dimension, options) => find([boxes], dimension, options),
    overlappingPairsBetween: (boxesA, boxesB, dimension, options) => find([boxesA, boxesB], dimension, options),
  };
}

export function pairFinderClass(core) {
  return class PairFinder extends Held {
    #scalar;
    #count;

    constructor(dimension, count, scalar = "float") {
      if (scalar !== "float" && scalar !== "double") {
        throw new Error(`scalar: it is ${scalar}; it must be float or double`);
      }
      super(core, core.checked(core.module.PairFinder.make(knownDimension(dimension), scalar === "double")));
      this.dimension = dimension;
      this.#scalar = scalar;
      this.count = count;
    }

    get count() {
      return this.#count;
    }

    set count(count) {
      this.core.checked(this.handle.resize(wholeNumber(count, "count")));
      this.#count = count;
    }

    get boxes() {
      const heap = this.#scalar === "float" ? this.core.module.HEAPF32 : this.core.module.HEAPF64;
      const first = this.handle.boxesAddress() / heap.BYTES_PER_ELEMENT;
      return heap.subarray(first, first + 2 * this.dimension * this.#count);
    }

    find({ order = "sorted", margin = 0, method = "automatic" } = {}) {
      const pairs = this.core.checked(this.handle.find(isSorted(order), margin, method));
      const first = this.handle.pairsAddress() / 4;
      return this.core.module.HEAPU32.subarray(first, first + 2 * pairs);
    }

    get method() {
      return this.handle.method();
    }

    get bytes() {
      return this.handle.bytes();
    }
  };
}
