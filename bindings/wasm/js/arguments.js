// SPDX-License-Identifier: MIT
// Passes arguments to C++ as consecutive numbers in shared memory. Values that cannot be written like that, or that C++
// refuses, are passed as text, for which the library's reader produces the error message.
import { numbersOf } from "./core.js";
import { dimensionOf, pointText, rayText, textOf } from "./text.js";

/** In the order of the C++ enumeration. */
export const meshKinds = ["surface", "solid"];

/** Names a mesh that the module holds. */
export class HeldNumber {
  constructor(number, dimension) {
    this.number = number;
    this.dimension = dimension;
  }
}

/** In place of a dimension: this value cannot be written as numbers. */
export const refused = -1;

/** The fields of a type of record, and the sets of them that are valid. */
class RecordType {
  #bits = new Map([["type", 1]]);
  #forms = new Map();

  /** A form without a number is written without one. */
  constructor(forms) {
    for (const form of forms) this.add(form);
  }

  add(form) {
    let mask = 0;
    for (const { name } of form.fields) {
      if (!this.#bits.has(name)) this.#bits.set(name, 2 ** this.#bits.size);
      mask |= this.#bits.get(name);
    }
    this.#forms.set(mask, form);
  }

  /** The form of a value; undefined if it has none, or lacks the type although `needsType`. */
  formOf(value, needsType) {
    if (typeof value !== "object" || value === null || Array.isArray(value)) return undefined;
    const names = Object.keys(value);
    let mask = 0;
    for (let i = 0; i < names.length; ++i) {
      if (value[names[i]] !== undefined) mask |= this.#bits.get(names[i]) ?? 2 ** 30;
    }
    if (needsType && (mask & 1) === 0) return undefined;
    return this.#forms.get(mask & ~1);
  }
}

const fieldsOf = (kinds) => Object.entries(kinds).map(([name, kind]) => ({ name, kind }));

/** The types of shapes, as described by C++. */
class ShapeTypes {
  constructor(core) {
    const { mostDepth, ...described } = JSON.parse(core.module.shapeForms());
    this.mostDepth = mostDepth;
    this.forms = [];
    this.types = new Map();
    for (const dimension of [2, 3]) {
      this.forms[dimension] = described[dimension].map(({ type, fields }, number) => ({
        type, dimension, number, fields: fieldsOf(Object.fromEntries(fields)),
      }));
    }
    this.forms[3].forEach((form, number) => {
      const flat = this.forms[2][number];
      const isForBoth = form.fields.every(({ name }, i) => name === flat.fields[i].name);
      if (!this.types.has(form.type)) this.types.set(form.type, new RecordType([]));
      const type = this.types.get(form.type);
      if (isForBoth) type.add({ ...form, dimension: 0 });
      else [flat, form].forEach((each) => type.add(each));
    });
  }
}

const rotation = new RecordType([{ dimension: 3, fields: fieldsOf({ axis: "vector", angle: "number" }) }]);

export class Arguments {
  #core;
  #shapes;
  #numbers = new Float64Array(0);
  #place = 0;

  constructor(core) {
    this.#core = core;
    this.#shapes = new ShapeTypes(core);
  }

  /** Passes values to C++: `ask(dimension, place)` gets their position in memory, and `read(result, reader, dimension)`
   * creates the result. `kinds` determines how each value is written. The dimension is that of the values if none is
   * given. A getter in a value may start another query; its arguments are placed after those already written. */
  ask(kinds, values, ask, read, dimension = 0) {
    const start = this.#place;
    try {
      const n = this.#write(kinds, values, dimension);
      if (n !== refused) {
        const result = ask(n, start);
        if (!this.#core.wasRefused()) return read(this.#core.checked(result), this.#core.reader(n), n);
      }
      this.#place = start;
      const known = dimension || dimensionOf(...values);
      kinds.forEach((kind, i) => this.#copy(kind.spell(this.#core, values[i], known)));
      return read(this.#core.checked(ask(known, start)), this.#core.reader(known), known);
    } finally {
      this.#place = start;
    }
  }

  #write(kinds, values, dimension) {
    let n = dimension;
    for (let i = 0; i < kinds.length && n !== refused; ++i) n = kinds[i].write(this, values[i], n);
    return n === 0 ? 2 : n;
  }

  #copy(numbers) {
    const kept = numbers.slice(); // copied, because they may move when memory grows
    this.#makeRoom(kept.length);
    this.#numbers.set(kept, this.#place);
    this.#place += kept.length;
  }

  /** Creates a new view if the module's memory has grown, which sets the length of old views to 0. */
  #makeRoom(count) {
    if (this.#place + count <= this.#numbers.length) return;
    const { module } = this.#core;
    const size = Math.max(1024, 2 * (this.#place + count));
    const first = this.#core.checked(module.argumentRoom(size)) / 8;
    this.#numbers = module.HEAPF64.subarray(first, first + size);
  }

  #put(number) {
    this.#makeRoom(1);
    this.#numbers[this.#place++] = number;
  }

  // Each of the following functions writes a value and returns the dimension: the given one, that of the value if 0 was
  // given, or `refused`. It reads the value before writing, because a getter may let the memory grow.

  number(value, n) {
    if (!Number.isFinite(value)) return refused;
    this.#put(value);
    return n;
  }

  vector(value, n) {
    if (!Array.isArray(value) && !ArrayBuffer.isView(value)) return refused;
    const { length } = value;
    if (length !== n && (n !== 0 || (length !== 2 && length !== 3))) return refused;
    const x = value[0];
    const y = value[1];
    const z = length === 3 ? value[2] : 0;
    if (!Number.isFinite(x) || !Number.isFinite(y) || !Number.isFinite(z)) return refused;
    this.#makeRoom(3);
    const place = this.#place;
    this.#numbers[place] = x;
    this.#numbers[place + 1] = y;
    this.#numbers[place + 2] = z;
    this.#place = place + length;
    return length;
  }

  axes(value, n) {
    if (!Array.isArray(value) || value.length !== n) return refused;
    let found = n;
    for (let i = 0; i < n && found !== refused; ++i) found = this.vector(value[i], n);
    return found;
  }

  // Lists, preceded by their count. Each has its own loop, because calling a function for each element is slower.

  points(value, n) {
    if (!Array.isArray(value)) return refused;
    const count = value.length;
    this.#put(count);
    let found = n;
    for (let i = 0; i < count && found !== refused; ++i) found = this.vector(value[i], found);
    return found;
  }

  faces(value, n) {
    if (!Array.isArray(value)) return refused;
    this.#put(value.length);
    for (let i = 0; i < value.length; ++i) {
      const face = value[i];
      if ((!Array.isArray(face) && !ArrayBuffer.isView(face)) || face.length !== 3) return refused;
      for (let k = 0; k < 3; ++k) {
        const vertex = face[k];
        if (!Number.isInteger(vertex) || vertex < 0) return refused;
        this.#put(vertex);
      }
    }
    return n;
  }

  meshKind(value, n) {
    const place = meshKinds.indexOf(value);
    if (place < 0) return refused;
    this.#put(place);
    return n;
  }

  held(value, n) {
    if (!(value instanceof HeldNumber) || (n !== 0 && n !== value.dimension)) return refused;
    this.#put(value.number);
    return value.dimension;
  }

  parts(value, n, depth) {
    return depth < this.#shapes.mostDepth ? this.shapes(value, n, depth + 1) : refused;
  }

  shapes(value, n, depth = 0) {
    if (!Array.isArray(value)) return refused;
    const count = value.length;
    this.#put(count);
    let found = n;
    for (let i = 0; i < count && found !== refused; ++i) found = this.shape(value[i], found, depth);
    return found;
  }

  rotation(value, n) {
    return this.#record(value, rotation.formOf(value, false), n, 0);
  }

  shape(value, n, depth = 0) {
    const form = this.#shapes.types.get(value?.type)?.formOf(value, true);
    return this.#record(value, form, n, depth);
  }

  /** A ray may omit its type. */
  ray(value, n) {
    if (value?.type !== undefined && value.type !== "ray") return refused;
    return this.#record(value, this.#shapes.types.get("ray").formOf(value, false), n, 0);
  }

  #record(value, form, n, depth) {
    if (form === undefined) return refused;
    if (form.number !== undefined) this.#put(form.number);
    let found = n;
    for (let i = 0; i < form.fields.length && found !== refused; ++i) {
      const { name, kind } = form.fields[i];
      found = this[kind](value[name], found, depth);
    }
    return form.dimension === 0 || form.dimension === found ? found : refused;
  }

  /** Reads a shape from a result. */
  readShape(reader) {
    const { type, fields } = this.#shapes.forms[reader.dimension][reader.number()];
    const shape = { type };
    for (const { name, kind } of fields) shape[name] = this.#readers[kind](reader);
    return shape;
  }

  #readers = {
    number: (reader) => reader.number(),
    vector: (reader) => reader.vector(),
    axes: (reader) => Array.from({ length: reader.dimension }, () => reader.vector()),
    points: (reader) => Array.from({ length: reader.number() }, () => reader.vector()),
    faces: (reader) => Array.from({ length: reader.number() }, () => [reader.number(), reader.number(), reader.number()]),
    meshKind: (reader) => meshKinds[reader.number()],
    parts: (reader) => Array.from({ length: reader.number() }, () => this.readShape(reader)),
  };
}

/** The numbers of a text, which C++ parses. */
const spelled = (core, dimension, text, role) => {
  core.checked(core.module.spelledShape(dimension, text, role));
  return core.answer();
};

// How arguments are passed: `write` as in Arguments; `spell` for refused ones, which produces the error message.

export const shape = (role) => ({
  write: (args, value, n) => args.shape(value, n),
  spell: (core, value, n) => spelled(core, n, textOf(value, role), role),
});

export const shapes = (role) => ({
  write: (args, value, n) => args.shapes(value, n),
  spell(core, value, n) {
    core.checked(core.module.spelledShapes(n, textOf(value, role)));
    return core.answer();
  },
});

export const ray = {
  write: (args, value, n) => args.ray(value, n),
  spell: (core, value, n) => spelled(core, n, rayText(value), "ray"),
};

export const point = {
  write: (args, value, n) => args.vector(value, n),
  spell: (core, value, n) => spelled(core, n, pointText(value), "point").subarray(1),
};

export const vector = (role) => ({
  write: (args, value, n) => args.vector(value, n),
  spell: (core, value, n) => numbersOf(value, n, role),
});
