// SPDX-License-Identifier: MIT
// The module created by Emscripten, with its errors and memory.

const wasDeleted = "this object was deleted";

/** Frees what an object held after garbage collection. */
const forgotten = new FinalizationRegistry((handle) => handle.delete());

/** The state of a call whose arguments C++ refused as numbers. */
const refusedNumbers = 2;

export class Core {
  #state;

  constructor(module) {
    this.module = module;
    this.#state = module.callStateAddress() / 4;
  }

  /** The result of a call; throws if C++ threw. */
  checked(result) {
    if (this.module.HEAP32[this.#state] !== 0) throw new Error(this.module.takeError());
    return result;
  }

  /** Whether C++ requires the arguments of the call as text. */
  wasRefused() {
    if (this.module.HEAP32[this.#state] !== refusedNumbers) return false;
    this.module.takeError();
    return true;
  }

  /** The output of a call, in place; valid until the next call. */
  answer() {
    const { numbers, place, end } = this.reader(0);
    return numbers.subarray(place, end);
  }

  /** The same, for parsing. */
  reader(dimension) {
    const words = this.module.HEAPU32;
    const first = words[this.#state + 1] / 8;
    return new Reader(this.module.HEAPF64, first, first + words[this.#state + 2], dimension);
  }

  /** Passes numbers to C++, as consecutive doubles or as floats. */
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

// Where the language has no `using` yet, compiled code looks up this symbol at run time.
if (Symbol.dispose === undefined) Object.defineProperty(Symbol, "dispose", { value: Symbol("Symbol.dispose") });

/** An object in the module's memory. */
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

  /** For `using`; repeated calls have no effect. */
  [Symbol.dispose]() {
    if (this.#handle !== null) this.delete();
  }
}

/** Queries about one value with the object's dimension; `ask` gets the value's position in memory. */
export const askAbout = (held, kinds, value, ask, read = (result) => result) =>
  held.core.arguments.ask(kinds, [value], (dimension, place) => ask(place), read, held.dimension);

/** The number of rows of `width` numbers in an array. */
export function rowsOf(numbers, width, role) {
  if (!ArrayBuffer.isView(numbers) && !Array.isArray(numbers)) {
    throw new Error(`${role}: must be a Float32Array or Float64Array`);
  }
  if (numbers.length % width === 0) return numbers.length / width;
  throw new Error(`${role}: ${numbers.length} numbers are not a multiple of ${width}`);
}

/** A count that C++ can represent. */
export function wholeNumber(value, role, least = 0) {
  if (Number.isInteger(value) && value >= least && value < 2 ** 31) return value;
  throw new Error(`${role}: ${value} is not a whole number of at least ${least}`);
}

/** A vector of the given number of finite numbers. */
export function numbersOf(vector, length, role) {
  const isRow = ArrayBuffer.isView(vector) || Array.isArray(vector);
  if (!isRow || vector.length !== length) {
    throw new Error(`${role}: ${isRow ? `it has ${vector.length} numbers` : "it is not a vector"}; it must have ${length}`);
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

/** Parses an output from its start. */
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

  /** A view of the next `count` numbers. */
  numbersAhead(count) {
    this.place += count;
    return this.numbers.subarray(this.place - count, this.place);
  }

  box() {
    return { min: this.vector(), max: this.vector() };
  }

  /** Where a ray hits something. */
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
