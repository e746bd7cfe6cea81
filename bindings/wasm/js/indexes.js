// SPDX-License-Identifier: MIT
// Quad trees, octrees and bounding volume hierarchies.
import { point, ray, shape } from "./arguments.js";
import { askAbout, Held, knownDimension, rowsOf, wholeNumber } from "./core.js";

const aRegion = [shape("region")];
const aRay = [ray];
const aPoint = [point];

/** The coordinates of one box. */
function boxNumbers(box, dimension) {
  const numbers = [...box.min, ...box.max];
  if (numbers.length === 2 * dimension) return numbers;
  throw new Error(`box: min and max have ${numbers.length} numbers; in dimension ${dimension} they have ${2 * dimension}`);
}

class SpatialIndex extends Held {
  constructor(core, handle, dimension) {
    super(core, handle);
    this.dimension = dimension;
  }

  get size() {
    return this.core.checked(this.handle.size());
  }

  insert(box) {
    return this.insertMany(boxNumbers(box, this.dimension))[0];
  }

  insertMany(boxes) {
    const count = rowsOf(boxes, 2 * this.dimension, "boxes");
    this.core.give([boxes]);
    this.core.checked(this.handle.insert(count));
    return this.core.answer().slice();
  }

  update(key, box) {
    this.updateMany([key], boxNumbers(box, this.dimension));
  }

  updateMany(keys, boxes) {
    const count = rowsOf(boxes, 2 * this.dimension, "boxes");
    if (count !== keys.length) throw new Error(`boxes: there are ${count} for ${keys.length} keys`);
    this.core.give([keys, boxes]);
    this.core.checked(this.handle.update(count));
  }

  erase(key) {
    this.core.checked(this.handle.erase(key));
  }

  clear() {
    this.core.checked(this.handle.clear());
  }

  contains(key) {
    return this.core.checked(this.handle.contains(key));
  }

  box(key) {
    this.core.checked(this.handle.box(key));
    return this.core.reader(this.dimension).box();
  }

  query(region) {
    return askAbout(this, aRegion, region, (place) => this.handle.query(place), () => this.core.answer().slice());
  }

  rayCast(along) {
    return askAbout(this, aRay, along, (place) => this.handle.rayCast(place), (result, answer) => {
      const hits = [];
      while (!answer.isAtEnd) hits.push({ key: answer.number(), t: answer.number() });
      return hits;
    });
  }

  nearest(from, count) {
    const most = wholeNumber(count, "count");
    return askAbout(this, aPoint, from, (place) => this.handle.nearest(place, most), (result, answer) => {
      const found = [];
      while (!answer.isAtEnd) found.push({ key: answer.number(), distanceSquared: answer.number() });
      return found;
    });
  }

  pairs() {
    this.core.checked(this.handle.pairs());
    return this.core.answer().slice();
  }

  cells() {
    this.core.checked(this.handle.cells());
    const numbers = this.core.answer();
    const width = 2 * this.dimension;
    const count = numbers.length / (width + 3);
    const cells = {
      boxes: new Float64Array(count * width),
      depths: new Uint32Array(count),
      counts: new Uint32Array(count),
      leaves: new Uint8Array(count),
    };
    for (let i = 0, place = 0; i < count; ++i, place += width + 3) {
      cells.boxes.set(numbers.subarray(place, place + width), i * width);
      cells.depths[i] = numbers[place + width];
      cells.counts[i] = numbers[place + width + 1];
      cells.leaves[i] = numbers[place + width + 2];
    }
    return cells;
  }
}

/** A tree of cells; C++ supplies the defaults of missing options. */
function makeOrthtree(core, dimension, { capacity, maxDepth } = {}) {
  const most = capacity === undefined ? 0 : wholeNumber(capacity, "capacity", 1);
  const depth = maxDepth === undefined ? -1 : wholeNumber(maxDepth, "maxDepth");
  return core.checked(core.module.Index.makeOrthtree(dimension, most, depth));
}

export function indexClasses(core) {
  return {
    QuadTree: class QuadTree extends SpatialIndex {
      constructor(options) {
        super(core, makeOrthtree(core, 2, options), 2);
      }
    },
    Octree: class Octree extends SpatialIndex {
      constructor(options) {
        super(core, makeOrthtree(core, 3, options), 3);
      }
    },
    Bvh: class Bvh extends SpatialIndex {
      constructor(dimension, { margin = 0 } = {}) {
        super(core, core.checked(core.module.Index.makeBvh(knownDimension(dimension), margin)), dimension);
      }
    },
  };
}
