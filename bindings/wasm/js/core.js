// SPDX-License-Identifier: MIT
// The module that Emscripten made, with its errors and its memory.

const wasDeleted = "this object was deleted";

/** Gives back what an object held when the object itself is gone. */
const forgotten = new FinalizationRegistry((handle) => handle.delete());

export class Core {
  constructor(module) {
    this.module = module;
    this.errorFlag = module.errorFlagAddress() / 4;
  }

  /** The result of a call, unless C++ threw. */
  checked(result) {
    if (this.module.HEAP32[this.errorFlag] !== 0) throw new Error(this.module.takeError());
    return result;
  }

  /** The answer of a call, in place: good until the next one. */
  answer() {
    const first = this.module.answerAddress() / 8;
    return this.module.HEAPF64.subarray(first, first + this.module.answerSize());
  }

  /** Hands numbers over, as doubles and one behind the other, or as floats. */
  give(lists, asFloats = false) {
    const count = lists.reduce((sum, list) => sum + list.length, 0);
    const address = this.checked(this.module.inputAddress(count * (asFloats ? 4 : 8)));
    const heap = asFloats ? this.module.HEAPF32 : this.module.HEAPF64;
    let place = address / (asFloats ? 4 : 8);
    for (const list of lists) {
      heap.set(list, place);
      place += list.length;
    }
  }
}

/** Something that lives in the module's memory. */
export class Held {
  #handle;

  constructor(core, handle) {
    this.core = core;
    this.#handle = handle;
    forgotten.register(this, handle, this);
    Object.defineProperty(this, "core", { enumerable: false });
  }

  get handle() {
    if (this.#handle === null) throw new Error(wasDeleted);
    return this.#handle;
  }

  delete() {
    forgotten.unregister(this);
    this.handle.delete();
    this.#handle = null;
  }
}

/** How many rows of `width` numbers an array has. */
export function rowsOf(numbers, width, role) {
  if (!ArrayBuffer.isView(numbers) && !Array.isArray(numbers)) {
    throw new Error(`${role}: must be a Float32Array or Float64Array`);
  }
  if (numbers.length % width === 0) return numbers.length / width;
  throw new Error(`${role}: ${numbers.length} numbers are not a multiple of ${width}`);
}

/** A count that C++ can hold. */
export function wholeNumber(value, role, least = 0) {
  if (Number.isInteger(value) && value >= least && value < 2 ** 31) return value;
  throw new Error(`${role}: ${value} is not a whole number of at least ${least}`);
}

/** A vector of so many finite numbers. */
export function numbersOf(vector, length, role) {
  const isRow = ArrayBuffer.isView(vector) || Array.isArray(vector);
  if (!isRow || vector.length !== length) {
    throw new Error(`${role}: ${isRow ? `it has ${vector.length} numbers` : "it is no vector"}; it must have ${length}`);
  }
  return Array.from(vector, (value) => finiteNumber(value, role));
}

export function finiteNumber(value, role) {
  if (Number.isFinite(value)) return value;
  throw new Error(`${role}: it is ${value}; numbers must be finite`);
}

/** Two or three. */
export function knownDimension(dimension) {
  if (dimension === 2 || dimension === 3) return dimension;
  throw new Error(`the dimension must be 2 or 3, not ${dimension}`);
}

export const statusOf = (number) => (number === 0 ? "converged" : "best_bound");

/** Takes an answer apart from its front. */
export class Reader {
  constructor(numbers, dimension) {
    this.numbers = numbers;
    this.dimension = dimension;
    this.place = 0;
  }

  get isAtEnd() {
    return this.place >= this.numbers.length;
  }

  number() {
    return this.numbers[this.place++];
  }

  vector() {
    this.place += this.dimension;
    return Array.from(this.numbers.subarray(this.place - this.dimension, this.place));
  }

  box() {
    return { min: this.vector(), max: this.vector() };
  }

  /** Where a ray meets something. */
  hit() {
    return {
      t: this.number(),
      point: this.vector(),
      normal: this.vector(),
      status: statusOf(this.number()),
      error: this.number(),
    };
  }
}
