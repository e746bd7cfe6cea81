// SPDX-License-Identifier: MIT
// Questions about one shape or two.
import { knownDimension, Reader, rowsOf, statusOf } from "./core.js";
import { dimensionOf, pointText, rayText, textOf } from "./text.js";

const relations = ["apart", "touching", "overlapping"];

const featureKinds = ["vertex", "edge", "face"];

const readFeature = (answer) => ({ kind: featureKinds[answer.number()], index: answer.number() });

const readContactId = (answer) => ({
  a: readFeature(answer),
  b: readFeature(answer),
  partA: answer.number(),
  partB: answer.number(),
});

/** Asks about two shapes. */
function askPair(core, name, a, b) {
  return core.checked(core.module[name](dimensionOf(a, b), textOf(a, "a"), textOf(b, "b")));
}

/** The same, for an answer of many numbers. */
function readPair(core, name, a, b) {
  askPair(core, name, a, b);
  return new Reader(core.answer(), dimensionOf(a, b));
}

function pairQueries(core) {
  return {
    relation: (a, b) => relations[askPair(core, "relation", a, b)],
    intersects: (a, b) => askPair(core, "relation", a, b) !== 0,
    distance: (a, b) => askPair(core, "distance", a, b),

    closestPoints(a, b) {
      const answer = readPair(core, "closestPoints", a, b);
      return {
        distance: answer.number(),
        pointA: answer.vector(),
        pointB: answer.vector(),
        normal: answer.vector(),
        relation: relations[answer.number()],
        status: statusOf(answer.number()),
        error: answer.number(),
      };
    },

    contact(a, b) {
      const answer = readPair(core, "contact", a, b);
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

    manifold(a, b) {
      const answer = readPair(core, "manifold", a, b);
      const manifold = {
        points: [],
        normal: answer.vector(),
        status: statusOf(answer.number()),
        error: answer.number(),
      };
      while (!answer.isAtEnd) {
        manifold.points.push({
          point: answer.vector(),
          pointA: answer.vector(),
          pointB: answer.vector(),
          depth: answer.number(),
          id: readContactId(answer),
        });
      }
      return manifold;
    },
  };
}

function shapeQueries(core) {
  const askPoint = (name, shape, point) =>
    core.checked(core.module[name](dimensionOf(point, shape), textOf(shape, "shape"), pointText(point)));
  return {
    rayCast(shape, ray, { tMax = Infinity, side = "entry" } = {}) {
      const dimension = dimensionOf(ray, shape);
      if (side !== "entry" && side !== "exit") throw new Error(`side: it is ${side}; it must be entry or exit`);
      core.checked(core.module.rayCast(dimension, textOf(shape, "shape"), rayText(ray), tMax, side === "exit"));
      const answer = new Reader(core.answer(), dimension);
      return answer.isAtEnd ? null : answer.hit();
    },

    contains: (shape, point) => askPoint("contains", shape, point),
    signedDistance: (shape, point) => askPoint("signedDistance", shape, point),

    closestPoint(shape, point) {
      askPoint("closestPoint", shape, point);
      return Array.from(core.answer());
    },

    closestBoundaryPoint(shape, point) {
      askPoint("closestBoundaryPoint", shape, point);
      return Array.from(core.answer());
    },

    bounds(shape) {
      const dimension = dimensionOf(shape);
      core.checked(core.module.bounds(dimension, textOf(shape, "shape")));
      return new Reader(core.answer(), dimension).box();
    },

    normalised: (shape) =>
      JSON.parse(core.checked(core.module.normalised(dimensionOf(shape), textOf(shape, "shape")))),

    drawing(shape, { within, corners = 64 } = {}) {
      const dimension = dimensionOf(shape, within);
      const box = within === undefined ? "" : textOf({ type: "aabb", min: within.min, max: within.max }, "within");
      core.checked(core.module.drawing(dimension, textOf(shape, "shape"), box, corners));
      const [count, triangles, lines] = core.answer();
      const numbers = core.answer().subarray(3);
      const lists = [0, count * dimension, count * dimension + triangles, count * dimension + triangles + lines];
      return {
        positions: Float32Array.from(numbers.subarray(lists[0], lists[1])),
        triangles: Uint32Array.from(numbers.subarray(lists[1], lists[2])),
        lines: Uint32Array.from(numbers.subarray(lists[2], lists[3])),
      };
    },
  };
}

function pointQueries(core) {
  const bounding = (kind) => (points, dimension) => {
    const isInRow = ArrayBuffer.isView(points);
    if (isInRow && dimension === undefined) throw new Error("points: coordinates in a row need a dimension");
    const n = knownDimension(dimension ?? dimensionOf(points));
    const wrong = isInRow ? undefined : points.find((point) => point.length !== n);
    if (wrong) throw new Error(`points: one has ${wrong.length} numbers; this set has dimension ${n}`);
    const numbers = isInRow ? points : points.flatMap((point) => Array.from(point));
    const count = rowsOf(numbers, n, "points");
    core.give([numbers]);
    return JSON.parse(core.checked(core.module.bounding(n, kind, count)));
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
