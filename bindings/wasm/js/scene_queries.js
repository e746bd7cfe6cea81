// SPDX-License-Identifier: MIT
// The queries of a scene that find objects for a region, a point, a ray or a moving shape.
import { point, ray, shape, vector } from "./arguments.js";
import { motion } from "./casts.js";
import { finiteNumber, numbersOf, wholeNumber } from "./core.js";
import { readFace } from "./meshes.js";
import { filterFields, filterOf, guarded, known, lengthOf, list, yesOrNo } from "./options.js";
import { readManifold } from "./queries.js";

const except = list("except");
const kinds = {
  region: [except, shape("region")],
  shape: [except, shape("shape")],
  point: [except, point],
  ray: [except, ray],
  cast: [except, shape("shape"), vector("motion")],
  motion: [except, shape("shape"), motion("motion")],
  slide: [except, shape("shape"), vector("motion"), list("up")],
};

const rayFields = [...filterFields, "tMax"];
const castFields = [...filterFields, "ignoreInitialTouch"];
const slideFields = [...filterFields, "up", "maxSlope", "stepHeight", "clearance"];

/** Reads until the end. */
const all = (read) => (result, answer) => {
  const found = [];
  while (!answer.isAtEnd) found.push(read(answer));
  return found;
};

const readNear = (answer) => ({ id: answer.number(), distance: answer.number() });
const readImpact = (answer) => ({ id: answer.number(), ...answer.hit() });
const readHit = (answer) => {
  const hit = readImpact(answer);
  const at = readFace(answer);
  return at.face === null ? hit : { ...hit, ...at };
};
const readTouch = (answer) => ({ id: answer.number(), ...readManifold(answer) });

/** A vector has no type, unlike a shape. */
const isPoint = (value) => Array.isArray(value) || ArrayBuffer.isView(value);

/** In place of an option that is not given, for which C++ has a default. */
const notGiven = Number.NaN;

/** Adds these queries to a class of scenes. */
export const withQueries = (Base) => class extends Base {
  /** Finds objects for some values; `more` are further arguments of the function. */
  #find(name, kinds, values, filter, read, ...more) {
    const { layers, except, predicate } = filterOf(filter);
    return guarded(this, predicate, (asked) => {
      const ask = (dimension, place) => this.core.module[`scene${name}`](this.handle, place, layers, asked, ...more);
      return this.core.arguments.ask(kinds, [except, ...values], ask, read, this.dimension);
    });
  }

  overlapping(region, options) {
    const read = () => this.core.answer().slice();
    return this.#find("Overlapping", kinds.region, [region], known(options, filterFields), read);
  }

  cull(region, options) {
    const read = () => this.core.answer().slice();
    return this.#find("Cull", kinds.region, [region], known(options, filterFields), read);
  }

  contactsWith(touching, options) {
    return this.#find("ContactsWith", kinds.shape, [touching], known(options, filterFields), all(readTouch));
  }

  nearest(from, count, options) {
    const [name, kind] = isPoint(from) ? ["Nearest", kinds.point] : ["NearestToShape", kinds.shape];
    return this.#find(name, kind, [from], known(options, filterFields), all(readNear), wholeNumber(count, "count"));
  }

  #castRay(name, along, options) {
    const { tMax = Infinity, ...filter } = known(options, rayFields);
    return this.#find(name, kinds.ray, [along], filter, all(readHit), tMax);
  }

  rayCast(along, options) {
    return this.#castRay("RayCast", along, options)[0] ?? null;
  }

  rayCastAll(along, options) {
    return this.#castRay("RayCastAll", along, options);
  }

  #castShape(name, moving, way, options) {
    const { ignoreInitialTouch = false, ...filter } = known(options, castFields);
    const ignores = yesOrNo(ignoreInitialTouch, "ignoreInitialTouch");
    return this.#find(name, kinds.cast, [moving, way], filter, all(readImpact), ignores);
  }

  shapeCast(moving, way, options) {
    return this.#castShape("ShapeCast", moving, way, options)[0] ?? null;
  }

  shapeCastAll(moving, way, options) {
    return this.#castShape("ShapeCastAll", moving, way, options);
  }

  timeOfImpact(moving, way, options) {
    const filter = known(options, filterFields);
    return this.#find("TimeOfImpact", kinds.motion, [moving, way], filter, all(readImpact))[0] ?? null;
  }

  slide(moving, way, options) {
    const { up, maxSlope, stepHeight, clearance, ...filter } = known(options, slideFields);
    const upward = up === undefined ? [] : numbersOf(up, this.dimension, "up");
    const numbers = [
      maxSlope === undefined ? notGiven : finiteNumber(maxSlope, "maxSlope"),
      stepHeight === undefined ? notGiven : lengthOf(stepHeight, "stepHeight"),
      clearance === undefined ? notGiven : lengthOf(clearance, "clearance"),
    ];
    const read = (result, answer) => ({ motion: answer.vector(), touches: all(readImpact)(result, answer) });
    return this.#find("Slide", kinds.slide, [moving, way, upward], filter, read, ...numbers);
  }
};
