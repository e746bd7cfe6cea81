// SPDX-License-Identifier: MIT
// Places labels: beside their points, without covering handles or other labels, and inside the picture.
import type { Point2 } from "./stage";

/** In pixels of the stage, y down. */
interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

const fontSize = 12.5;
/** Heights of letters above and below the baseline. */
const [above, below] = [11, 4];
const margin = 3;

export function aboutPoint([x, y]: Point2, reach: number): Box {
  return { left: x - reach, top: y - reach, right: x + reach, bottom: y + reach };
}

export class LabelPlaces {
  readonly #taken: Box[];
  readonly #width: number;
  readonly #height: number;

  constructor(obstacles: readonly Box[], width: number, height: number) {
    [this.#taken, this.#width, this.#height] = [[...obstacles], width, height];
  }

  /** Reserves and returns the center of the text's line: at the requested shift, otherwise at a free position beside
   * the point or, if none is free, the least obstructed one. */
  take(text: string, [x, y]: Point2, wished: Point2): Point2 {
    const half = widthOf(text) / 2 + margin;
    const boxAt = ([right, down]: Point2): Box => {
      return { left: x + right - half, top: y + down - above, right: x + right + half, bottom: y + down + below };
    };
    const beside = half + 10;
    const shifts: readonly Point2[] = [
      wished, [0, -14], [0, 22], [beside, 4], [-beside, 4], [beside, -14], [-beside, -14], [beside, 22], [-beside, 22], [0, -34], [0, 42],
    ];
    const costs = shifts.map((shift) => this.#cost(boxAt(shift)));
    const best = shifts[costs.indexOf(Math.min(...costs))] ?? wished;
    this.#taken.push(boxAt(best));
    return [x + best[0], y + best[1]];
  }

  /** The area that is already covered, plus what extends beyond the picture. */
  #cost(box: Box): number {
    const covered = this.#taken.reduce((sum, other) => sum + sharedArea(box, other), 0);
    const page = { left: 0, top: 0, right: this.#width, bottom: this.#height };
    return covered + 4 * ((box.right - box.left) * (box.bottom - box.top) - sharedArea(box, page));
  }
}

function sharedArea(a: Box, b: Box): number {
  const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
  const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return Math.max(0, width) * Math.max(0, height);
}

const pen = document.createElement("canvas").getContext("2d");
const widths = new Map<string, number>();

function widthOf(text: string): number {
  const known = widths.get(text);
  if (known !== undefined) return known;
  if (pen !== null) pen.font = `${fontSize}px ${getComputedStyle(document.body).fontFamily}`;
  const width = pen?.measureText(text).width ?? text.length * 7;
  if (widths.size > 1000) widths.clear();
  widths.set(text, width);
  return width;
}
