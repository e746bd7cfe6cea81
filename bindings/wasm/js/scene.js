// SPDX-License-Identifier: MIT
// Scenes, created in memory or read from files.
import { shape, shapes } from "./arguments.js";
import { askAbout, finiteNumber, Held, knownDimension, Reader, rowsOf, statusOf } from "./core.js";
import { isAsked, lengthOf } from "./options.js";
import { readContactId } from "./queries.js";
import { withQueries } from "./scene_queries.js";
import { textOf } from "./text.js";

const aShape = [shape("shape")];
const manyShapes = [shapes("shapes")];

/** The options of an object, as C++ reads them. */
function optionsText({ fixed, ...rest } = {}) {
  return textOf({ ...rest, fixed: fixed ? 1 : undefined }, "options");
}

/** The numbers of the layers in a mask of two halves. */
function layersOf(low, high) {
  if (low === 0xffffffff && high === 0xffffffff) return "all";
  const layers = [];
  for (let i = 0; i < 64; ++i) {
    if (Math.floor((i < 32 ? low : high) / 2 ** (i % 32)) % 2 === 1) layers.push(i);
  }
  return layers;
}

/** Methods that change a scene. */
class ChangingScene extends Held {
  /** For calls that change the scene. */
  get changing() {
    if (!isAsked(this)) return this.handle;
    throw new Error("predicate: it must not change the scene that asks it; change it after the query");
  }

  delete() {
    if (this.changing) super.delete();
  }

  add(added, options) {
    const words = optionsText(options);
    return askAbout(this, aShape, added, (place) => this.changing.add(place, words));
  }

  addMany(added, options) {
    const words = optionsText(options);
    const add = (place) => this.changing.addMany(place, words);
    return askAbout(this, manyShapes, added, add, () => this.core.answer().slice());
  }

  #addRows(method, rows, width, role, options) {
    const count = rowsOf(rows, width, role);
    this.core.give([rows]);
    this.core.checked(this.changing[method](count, optionsText(options)));
    return this.core.answer().slice();
  }

  addBoxes(boxes, options) {
    return this.#addRows("addBoxes", boxes, 2 * this.dimension, "boxes", options);
  }

  addSpheres(spheres, options) {
    return this.#addRows("addSpheres", spheres, this.dimension + 1, "spheres", options);
  }

  move(id, to) {
    askAbout(this, aShape, to, (place) => this.changing.move(id, place));
  }

  #moveRows(method, ids, rows, width, role) {
    const count = rowsOf(rows, width, role);
    if (count !== ids.length) throw new Error(`${role}: there are ${count} for ${ids.length} ids`);
    this.core.give([ids, rows]);
    this.core.checked(this.changing[method](count));
  }

  translate(ids, offsets) {
    this.#moveRows("translate", ids, offsets, this.dimension, "offsets");
  }

  place(ids, positions) {
    this.#moveRows("place", ids, positions, this.dimension, "positions");
  }

  moveBoxes(ids, boxes) {
    this.#moveRows("moveBoxes", ids, boxes, 2 * this.dimension, "boxes");
  }

  moveSpheres(ids, spheres) {
    this.#moveRows("moveSpheres", ids, spheres, this.dimension + 1, "spheres");
  }

  pose(ids, poses) {
    this.#moveRows("pose", ids, poses, this.dimension === 2 ? 3 : 7, "poses");
  }

  moveToTime(seconds) {
    this.core.checked(this.changing.moveToTime(finiteNumber(seconds, "seconds")));
  }

  remove(id) {
    this.core.checked(this.changing.remove(id));
  }

  except(a, b) {
    this.core.checked(this.changing.except(a, b));
  }

  accept(a, b) {
    this.core.checked(this.changing.accept(a, b));
  }

  layer(name) {
    return this.core.checked(this.changing.layer(name));
  }

  update() {
    this.core.checked(this.changing.update());
    const [began, stayed] = this.core.answer();
    const pairs = this.core.answer().subarray(2);
    return {
      began: pairs.slice(0, 2 * began),
      stayed: pairs.slice(2 * began, 2 * (began + stayed)),
      ended: pairs.slice(2 * (began + stayed)),
    };
  }
}

/** Queries on all of it. */
class Scene extends withQueries(ChangingScene) {
  constructor(core, handle) {
    super(core, handle);
    const { source, format, yAxis, dimension, omissions } = this.#head();
    Object.assign(this, { source, format, yAxis, dimension, omissions });
  }

  /** Sends a query to C++. */
  #ask(name, ...values) {
    return this.core.checked(this.core.module[`scene${name}`](this.handle, ...values));
  }

  /** Sends a query whose result is a list of numbers. */
  #list(name, ...values) {
    this.#ask(name, ...values);
    return this.core.answer().slice();
  }

  #read(name, ...values) {
    this.#ask(name, ...values);
    return this.core.reader(this.dimension);
  }

  #head() {
    return JSON.parse(this.#ask("Head"));
  }

  get size() {
    return this.#ask("Size");
  }

  get layerNames() {
    return this.#head().layers;
  }

  pairs() {
    return this.#list("Pairs");
  }

  contactArrays() {
    const answer = this.#read("Contacts");
    const [pairs, points, n] = [answer.number(), answer.number(), this.dimension];
    const ids = answer.numbersAhead(2 * pairs).slice();
    const starts = new Uint32Array(pairs + 1);
    answer.numbersAhead(pairs).forEach((count, i) => (starts[i + 1] = starts[i] + count));
    return {
      ids,
      starts,
      normals: answer.numbersAhead(n * pairs).slice(),
      statuses: Uint8Array.from(answer.numbersAhead(pairs)),
      errors: answer.numbersAhead(pairs).slice(),
      points: answer.numbersAhead(n * points).slice(),
      pointsA: answer.numbersAhead(n * points).slice(),
      pointsB: answer.numbersAhead(n * points).slice(),
      depths: answer.numbersAhead(points).slice(),
      contactIds: Uint32Array.from(answer.numbersAhead(6 * points)),
    };
  }

  contacts() {
    const arrays = this.contactArrays();
    const readerOf = (numbers) => new Reader(numbers, 0, numbers.length, this.dimension);
    const [ids, normals, points, pointsA, pointsB, contactIds] = [
      arrays.ids, arrays.normals, arrays.points, arrays.pointsA, arrays.pointsB, arrays.contactIds,
    ].map(readerOf);
    const pointAt = (place) => ({
      point: points.vector(),
      pointA: pointsA.vector(),
      pointB: pointsB.vector(),
      depth: arrays.depths[place],
      id: readContactId(contactIds),
    });
    return Array.from(arrays.errors, (error, i) => ({
      a: ids.number(),
      b: ids.number(),
      points: Array.from({ length: arrays.starts[i + 1] - arrays.starts[i] }, (_, k) => pointAt(arrays.starts[i] + k)),
      normal: normals.vector(),
      status: statusOf(arrays.statuses[i]),
      error,
    }));
  }

  candidates() {
    return this.#list("Candidates");
  }

  closestPairs(within) {
    const answer = this.#read("ClosestPairs", lengthOf(within, "within"));
    const pairs = [];
    while (!answer.isAtEnd) pairs.push({ a: answer.number(), b: answer.number(), distance: answer.number() });
    return pairs;
  }

  excepted(a, b) {
    return this.#ask("Excepted", a, b);
  }

  exceptedPairs() {
    return this.#list("ExceptedPairs");
  }

  contains(id) {
    return this.#ask("Contains", id);
  }

  object(id) {
    const { user, ...said } = JSON.parse(this.#ask("Object", id));
    const answer = this.core.reader(this.dimension);
    const box = answer.box();
    const mask = layersOf(answer.number(), answer.number());
    return { ...said, user: BigInt(user), box, mask, shape: this.core.arguments.readShape(answer) };
  }

  velocities() {
    const answer = this.#read("Velocities");
    const movers = [];
    while (!answer.isAtEnd) movers.push({ id: answer.number(), velocity: answer.vector() });
    return movers;
  }

  find(name) {
    return this.#list("Find", name)[0] ?? null;
  }

  ids() {
    return this.#list("Ids");
  }

  boxes(ids) {
    if (ids !== undefined) this.core.give([ids]);
    return this.#list("Boxes", ids?.length ?? 0, ids === undefined);
  }

  check({ interior = false } = {}) {
    return JSON.parse(this.#ask("CheckReport", interior));
  }

  checkPairs({ interior = false } = {}) {
    this.#ask("CheckPairs", interior);
    const [candidates, seconds] = this.core.answer();
    const numbers = this.core.answer().subarray(2);
    const count = numbers.length / 3;
    const ids = new Float64Array(2 * count);
    const relations = new Uint8Array(count);
    for (let i = 0; i < count; ++i) {
      ids[2 * i] = numbers[3 * i];
      ids[2 * i + 1] = numbers[3 * i + 1];
      relations[i] = numbers[3 * i + 2];
    }
    return { ids, relations, candidates, seconds };
  }

  info() {
    return JSON.parse(this.#ask("Info"));
  }

  toJson() {
    return this.#ask("ToJson");
  }
}

export function sceneParts(core) {
  const make = (dimension) => core.checked(core.module.Scene.make(knownDimension(dimension)));
  return {
    Scene: class extends Scene {
      constructor(dimension) {
        super(core, make(dimension));
      }
    },

    readScene(content, name = "scene", files = {}) {
      try {
        for (const [path, held] of Object.entries(files)) core.checked(core.module.addSceneFile(path, held));
        return new Scene(core, core.checked(core.module.Scene.read(content, name)));
      } finally {
        core.checked(core.module.removeSceneFiles());
      }
    },
  };
}
