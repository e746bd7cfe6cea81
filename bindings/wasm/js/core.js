// SPDX-License-Identifier: MIT
// The module that Emscripten made, with its errors and its memory.

const wasDeleted = "this object was deleted";

/** Gives back what an object held when the object itself is gone. */
const forgotten = new FinalizationRegistry((handle) => handle.delete());

/** What C++ says of a call: that it threw, or would not take the arguments as numbers. */
const refusedNumbers = 2;

export class Core {
  #state;

  constructor(module) {
    this.module = module;
    this.#state = module.callStateAddress() / 4;
  }

  /** The result of a call, unless C++ threw. */
  checked(result) {
    if (this.module.HEAP32[this.#state] !== 0) throw new Error(this.module.takeError());
    return result;
  }

  /** Whether C++ wants the arguments of the call as text. */
  wasRefused() {
    if (this.module.HEAP32[this.#state] !== refusedNumbers) return false;
    this.module.takeError();
    return true;
  }

  /** The answer of a call, in place: good until the next one. */
  answer() {
    const { numbers, place, end } = this.reader(0);
    return numbers.subarray(place, end);
  }

  /** The same, to be taken apart. */
  reader(dimension) {
    const words = this.module.HEAPU32;
    const first = words[this.#state + 1] / 8;
    return new Reader(this.module.HEAPF64, first, first + words[this.#state + 2], dimension);
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

// Where the language has no `using` yet, compilers make code that looks for this symbol when it runs.
if (Symbol.dispose === undefined) Object.defineProperty(Symbol, "dispose", { value: Symbol("Symbol.dispose") });

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

  /** For `using`; what was deleted stays deleted. */
  [Symbol.dispose]() {
    if (this.#handle !== null) this.delete();
  }
}

/** Asks about one value of the dimension of what is held; `ask` is told where the value stands. */
export const askAbout = (held, kinds, value, ask, read = (result) => result) =>
  held.core.arguments.ask(kinds, [value], (dimension, place) => ask(place), read, held.dimension);

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
  constructor(numbers, place, end, dimension) {
    this.numbers = numbers;
    this.place = place;
    this.end = end;
    this.dimension = dimension;
  }

  get isAtEnd() {
    return this.place >= this.end;
  }

  number() {
    return this.numbers[this.place++];
  }

  vector() {
    const { numbers, place } = this;
    this.place += this.dimension;
    return this.dimension === 2
      ? [numbers[place], numbers[place + 1]]
      : [numbers[place], numbers[place + 1], numbers[place + 2]];
  }

  /** So many numbers in place. */
  numbersAhead(count) {
    this.place += count;
    return this.numbers.subarray(this.place - count, this.place);
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
