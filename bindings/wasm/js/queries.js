// SPDX-License-Identifier: MIT
// Queries about one or two shapes.
import { point, ray, shape } from "./arguments.js";
import { knownDimension, rowsOf, statusOf } from "./core.js";
import { readRayHit } from "./meshes.js";
import { known, lengthOf } from "./options.js";
import { dimensionOf } from "./text.js";

const relations = ["apart", "touching", "overlapping"];

const featureKinds = ["vertex", "edge", "face"];

const readFeature = (answer) => ({ kind: featureKinds[answer.number()], index: answer.number() });

export const readContactId = (answer) => ({
  a: readFeature(answer),
  b: readFeature(answer),
  partA: answer.number(),
  partB: answer.number(),
});

const readNumber = (result) => result;
const readVector = (result, answer) => answer.vector();

const readProximity = (result, answer) => ({
  distance: answer.number(),
  pointA: answer.vector(),
  pointB: answer.vector(),
  normal: answer.vector(),
  relation: relations[answer.number()],
  status: statusOf(answer.number()),
  error: answer.number(),
});

const pairReaders = {
  relation: (result) => relations[result],
  distance: readNumber,
  closestPoints: readProximity,
  separation: readProximity,
};

export const readManifold = (answer) => ({
  normal: answer.vector(),
  status: statusOf(answer.number()),
  error: answer.number(),
  points: Array.from({ length: answer.number() }, () => ({
    point: answer.vector(),
    pointA: answer.vector(),
    pointB: answer.vector(),
    depth: answer.number(),
    id: readContactId(answer),
  })),
});

/** These queries accept a margin. */
const contactReaders = {
  contact(result, answer) {
    if (answer.isAtEnd) return null;
    return {
      point: answer.vector(),
      pointA: answer.vector(),
      pointB: answer.vector(),
      normal: answer.vector(),
      depth: answer.number(),
      status: statusOf(answer.number()),
      error: answer.number(),
    };
  },

  manifold: (result, answer) => readManifold(answer),
};

const pointReaders = {
  contains: readNumber,
  signedDistance: readNumber,
  closestPoint: readVector,
  closestBoundaryPoint: readVector,
};

/** A function for each reader, by its name. */
const functionsOf = (readers, make) =>
  Object.fromEntries(Object.entries(readers).map(([name, read]) => [name, make(name, read)]));

const oneShape = [shape("shape")];
const twoShapes = [shape("a"), shape("b")];
const pointAndShape = [point, shape("shape")];
const rayAndShape = [ray, shape("shape")];

const pairQueries = ({ module, arguments: args }) => ({
  ...functionsOf(pairReaders, (name, read) => (a, b) => args.ask(twoShapes, [a, b], module[name], read)),
  ...functionsOf(contactReaders, (name, read) => (a, b, options) => {
    const margin = lengthOf(known(options, ["margin"]).margin ?? 0, "margin");
    return args.ask(twoShapes, [a, b], (dimension, place) => module[name](dimension, place, margin), read);
  }),
  intersects: (a, b) => args.ask(twoShapes, [a, b], module.relation, (result) => result !== 0),
});

const shapeQueries = ({ module, arguments: args }) => ({
  ...functionsOf(pointReaders, (name, read) => (of, from) => args.ask(pointAndShape, [from, of], module[name], read)),

  rayCast(of, along, { tMax = Infinity, side = "entry" } = {}) {
    if (side !== "entry" && side !== "exit") throw new Error(`side: it is ${side}; it must be entry or exit`);
    const ask = (dimension, place) => module.rayCast(dimension, place, tMax, side === "exit");
    return args.ask(rayAndShape, [along, of], ask, (result, answer) => readRayHit(answer));
  },

  bounds: (of) => args.ask(oneShape, [of], module.bounds, (result, answer) => answer.box()),
  normalised: (of) => args.ask(oneShape, [of], module.normalised, (result, answer) => args.readShape(answer)),

  drawing(of, { within, corners = 64 } = {}) {
    const isCut = within !== undefined;
    const values = isCut ? [of, { type: "aabb", min: within.min, max: within.max }] : [of];
    const kinds = isCut ? [shape("shape"), shape("within")] : oneShape;
    const ask = (dimension, place) => module.drawing(dimension, place, isCut, corners);
    return args.ask(kinds, values, ask, (result, answer) => {
      const [count, triangles, lines] = [answer.number(), answer.number(), answer.number()];
      return {
        positions: Float32Array.from(answer.numbersAhead(count * answer.dimension)),
        triangles: Uint32Array.from(answer.numbersAhead(triangles)),
        lines: Uint32Array.from(answer.numbersAhead(lines)),
      };
    });
  },
});

/** In the order of the C++ enumeration. */
const boundingKinds = ["sphere", "sphere_fast", "box", "obb", "hull"];

function pointQueries(core) {
  const bounding = (kind) => (points, dimension) => {
    const isInRow = ArrayBuffer.isView(points);
    if (isInRow && dimension === undefined) throw new Error("points: consecutive coordinates need a dimension");
    const n = knownDimension(dimension ?? dimensionOf(points));
    const wrong = isInRow ? undefined : points.find((point) => point.length !== n);
    if (wrong) throw new Error(`points: one has ${wrong.length} numbers; this set has dimension ${n}`);
    const numbers = isInRow ? points : points.flatMap((point) => Array.from(point));
    const count = rowsOf(numbers, n, "points");
    core.give([numbers]);
    core.checked(core.module.bounding(n, boundingKinds.indexOf(kind), count));
    return core.arguments.readShape(core.reader(n));
  };
  return {
    boundingSphere: bounding("sphere"),
    boundingSphereFast: bounding("sphere_fast"),
    boundingBox: bounding("box"),
    boundingObb: bounding("obb"),
    convexHull: bounding("hull"),
  };
}

export const queries = (core) => ({ ...pairQueries(core), ...shapeQueries(core), ...pointQueries(core) });
