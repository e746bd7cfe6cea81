// SPDX-License-Identifier: MIT
// Rays and casts: the first hit of a ray, all hits in order, the area lit by a lamp, and the first contact of a moving
// shape.
import { Board } from "../board";
import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { Paint } from "../drawing/paint";
import { count as countText, counted, duration, measure, rounded } from "../numbers";
import { plumb, type Mark, type SpaceHandle } from "../overlay";
import { choice, Figures, section, slider, title } from "../panel";
import type { ShapeType } from "../shapes/flat_shape";
import type { ShapeKit } from "../shapes/shape_kit";
import { numberOf, pointOf, wordOf, writePoint } from "../state";
import type { Point2 } from "../stage";
import { lengthOf, minus, plus, times } from "../vectors";
import { directionsAllRound, Lamp } from "./lamp";
import { MovingShape, movingTypes, type MovingLook, type MovingType } from "./moving_shape";

const usual = {
  2: "aabb:-1.4,1.1,0.2,2.5;obb:2.7,1.4,0.9,0.5,35;sphere:0.9,-1.6,0.75;triangle:2.7,-2.6,4.3,-1.9,3.1,-0.7;" +
    "capsule:-3.2,2.3,-2.4,1.2,0.3;polytope:-1.9,-2.7,-0.7,-2.4,-0.9,-1.3,-2.2,-1.5;segment:4.6,-0.4,4.9,2.8;sphere:1.5,0.25,0.3;" +
    "obb:-4.4,-1.7,0.25,0.8,-20;sphere:1.3,2.75,0.4",
  3: "half_space:0,0,1,0;sphere:-0.4,-0.3,0.75,0.45;aabb:-2.4,0.9,0,-1.2,2.1,1.1;obb:1.6,0.4,0.8,0.4,0.6,0.8,0,0,30;" +
    "capsule:0.2,2,0.4,1.3,2.3,1.5,0.35;polytope:0.3,-2.5,0,1.7,-2.5,0,1.8,-1.3,0,0.5,-1.2,0,1.1,-1.9,1.3;" +
    "triangle:2.5,-0.9,0.3,2.7,1.1,0.3,2.6,0.2,2.1;sphere:-1.7,-1.9,0.4,0.4",
} as const;
const extent = {
  2: { min: [-5.4, -3.6], max: [5.4, 3.6] },
  3: { min: [-3, -3, -0.3], max: [3, 3, 2.4] },
} as const;
/** For a ray a nearby point that it passes; for a moving shape a path across the others. */
const usualEnds = {
  ray: {
    2: { origin: [-3.4, -0.25], target: [-2.3, -0.15] },
    3: { origin: [-2.6, -0.7, 0.9], target: [-1.6, -0.5, 0.9] },
  },
  cast: {
    2: { origin: [-4.4, 0.3], target: [3.4, 0.5] },
    3: { origin: [-2.6, -0.7, 1.4], target: [2.4, 0.9, 1.2] },
  },
} as const;

const addable: readonly ShapeType[] = ["sphere", "aabb", "obb", "triangle", "capsule", "polytope", "segment", "plane", "half_space", "compound"];
const fanLimits = { least: 12, most: 1440, usual: 720 } as const;
const sizeLimits = { least: 0.05, most: 1.5, usual: 0.5 } as const;
const turnLimits = { least: -360, most: 360, usual: 90 } as const;

type Mode = "first" | "all" | "fan" | "cast";
type WayKind = "ray" | "cast";

interface Hit {
  readonly point: readonly number[];
  readonly normal: readonly number[];
  readonly place: number;
  readonly t: number;
}

/** The start of a ray and a point that it passes, or the start and end of a moving shape. */
interface Way {
  readonly origin: readonly number[];
  readonly target: readonly number[];
}

class Rays implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #board: Board;
  readonly #figures = new Figures();
  readonly #hitList = element("ul", { class: "list", "aria-label": "What is hit, in order" });
  readonly #ways: Record<WayKind, Record<2 | 3, Way>>;
  #mode: Mode;
  #rays: number;
  #look: MovingLook;
  #lamp!: Lamp;
  #moving!: MovingShape;
  readonly #castControls = element("div");

  constructor(context: ChapterContext) {
    this.#context = context;
    const { parameters } = context;
    this.#mode = wordOf(parameters, "mode", ["first", "all", "fan", "cast"]);
    this.#ways = { ray: { ...usualEnds.ray }, cast: { ...usualEnds.cast } };
    // A link contains either the ray or the shape, whichever is shown.
    for (const dimension of [2, 3] as const) this.#ways[this.#wayKind][dimension] = wayOf(parameters, usualEnds[this.#wayKind][dimension]);
    this.#rays = Math.round(numberOf(parameters, "rays", fanLimits));
    this.#look = {
      type: wordOf(parameters, "moving", movingTypes),
      size: numberOf(parameters, "size", sizeLimits),
      turn: numberOf(parameters, "turn", turnLimits),
    };
    this.#board = new Board(context, {
      usual, extent, addable,
      onChange: () => this.#draw(),
      onOpen: (kit) => {
        this.#lamp = new Lamp(context.stage);
        this.#moving = new MovingShape(context, kit);
        this.#fillCastControls(kit.names);
      },
      ownHandles: () => this.#handles(),
    });
    this.#fillPanel();
    this.#draw();
  }

  parameters(): URLSearchParams {
    const { type, size, turn } = this.#look;
    const parameters = new URLSearchParams({ mode: this.#mode });
    writePoint(parameters, "", this.#way.origin);
    writePoint(parameters, "to-", this.#way.target);
    const own = this.#mode === "cast" ? { moving: type, size: rounded(size), turn: rounded(turn) } : { rays: this.#rays };
    for (const [name, value] of Object.entries(own)) parameters.set(name, String(value));
    this.#board.describe(parameters);
    return parameters;
  }

  get #way(): Way {
    return this.#ways[this.#wayKind][this.#board.dimension];
  }

  get #wayKind(): WayKind {
    return this.#mode === "cast" ? "cast" : "ray";
  }

  onKey(event: KeyboardEvent): boolean {
    return this.#board.editor.onKey(event);
  }

  close(): void {
    this.#board.close();
  }

  #handles(): SpaceHandle[] {
    const { origin, target } = this.#way;
    const set = (way: Way): void => {
      if (lengthOf(minus(way.target, way.origin)) > 0) this.#ways[this.#wayKind][this.#board.dimension] = way;
      this.#draw();
    };
    const isCast = this.#mode === "cast";
    const start: SpaceHandle = {
      key: "origin", label: isCast ? "Start of the moving shape" : "Start of the ray", at: origin,
      onMoveInSpace: (to) => set({ origin: to, target: plus(to, minus(target, origin)) }),
    };
    const end: SpaceHandle = {
      key: "target", label: isCast ? "End of its path" : "Direction of the ray", at: target,
      onMoveInSpace: (to) => set({ origin, target: to }),
    };
    return this.#mode === "fan" ? [start] : [start, end];
  }

  /** Nothing beyond this distance is visible. */
  #reach(): number {
    const { stage } = this.#context;
    const { min, max } = stage.isFlat ? stage.seenPlane() : stage.extent;
    const farthest = min.map((low, axis) => {
      const from = this.#way.origin[axis] ?? 0;
      return Math.max(Math.abs(low - from), Math.abs((max[axis] ?? 0) - from));
    });
    return lengthOf(farthest) * 1.1;
  }

  #cast(direction: readonly number[], all: boolean): Hit[] {
    const { editor } = this.#board;
    const ray = { origin: this.#way.origin, direction };
    const first = all ? undefined : editor.scene.rayCast(ray);
    const hits = all ? editor.scene.rayCastAll(ray) : first === null || first === undefined ? [] : [first];
    return hits.map(({ id, point, normal, t }) => ({ point, normal, place: editor.placeOf(id), t }));
  }

  #draw(): void {
    if (this.#mode === "cast") this.#drawCast();
    else if (this.#mode === "fan") this.#drawFan();
    else this.#drawRay();
    this.#context.changed();
  }

  #drawRay(): void {
    const { origin, target } = this.#way;
    const unit = times(minus(target, origin), 1 / lengthOf(minus(target, origin)));
    const start = performance.now();
    const hits = this.#cast(unit, this.#mode === "all");
    const spent = performance.now() - start;
    this.#moving.hide();
    this.#lamp.hide();
    this.#paint(hits, () => this.#rayMarks(hits, unit));
    this.#showCounts({ rays: 1, hits, first: hits[0], spent });
    this.#list(hits);
    this.#context.say(counted(new Set(hits.map((hit) => hit.place)).size, "hit"));
  }

  #drawFan(): void {
    const { dimension } = this.#board;
    const { origin } = this.#way;
    const directions = directionsAllRound(dimension, this.#rays);
    const start = performance.now();
    const fan = directions.map((direction) => this.#cast(direction, false)[0]);
    const spent = performance.now() - start;
    const hits = fan.filter((hit) => hit !== undefined);
    const reach = this.#reach();
    this.#moving.hide();
    this.#lamp.hide();
    if (dimension === 3) this.#lamp.lightPoints(hits.filter((hit) => this.#context.stage.isInExtent(hit.point)));
    else this.#lamp.lightArea(origin, directions.map((direction, i) => fan[i]?.point ?? plus(origin, times(direction, reach))));
    this.#paint(hits, () => this.#fanMarks(hits));
    this.#showCounts({ rays: this.#rays, hits, first: undefined, spent });
    this.#list([]);
    this.#context.say(`${countText(this.#rays)} rays see ${new Set(hits.map((hit) => hit.place)).size} shapes`);
  }

  /** Highlights what is hit. */
  #paint(hits: readonly { readonly place: number }[], marks: () => Mark[]): void {
    const { editor, shapes } = this.#board;
    const places = new Set(hits.map((hit) => hit.place));
    const level = extent[3].min[2];
    const foot = (): Mark[] => (this.#mode === "fan" ? [] : plumb(this.#way.target, level));
    editor.draw(shapes.map((_, place) => (places.has(place) ? Paint.touching : Paint.free)), () => [...plumb(this.#way.origin, level), ...foot(), ...marks()]);
  }

  #showCounts({ rays, hits, first, spent }: { rays: number; hits: readonly Hit[]; first: Hit | undefined; spent: number }): void {
    this.#figures.set("rays", "Rays", countText(rays));
    this.#figures.set("hits", "Shapes hit", String(new Set(hits.map((hit) => hit.place)).size));
    this.#figures.set("t", "Distance of the first", first === undefined ? "–" : measure(first.t));
    this.#figures.set("time", "Time of all rays", duration(spent));
  }

  /** The shape at its start, on its way, and at its first contact. */
  #drawCast(): void {
    const { editor, shapes } = this.#board;
    const { origin, target } = this.#way;
    const { impacts, spent } = this.#moving.cast(this.#look, origin, target, shapes);
    const first = impacts[0];
    this.#lamp.hide();
    this.#moving.draw(first);
    this.#paint(first === undefined ? [] : [first], () => this.#moving.marks(first));
    this.#figures.set("rays", "Shapes tested", countText(shapes.length));
    this.#figures.set("hits", "Shapes in the way", String(impacts.length));
    this.#figures.set("t", "Time of first touch", first === undefined ? "–" : measure(first.t));
    this.#figures.set("time", "Time of all casts", duration(spent));
    this.#list(impacts);
    const end = first === undefined ? "touches nothing" : `touches ${editor.nameOf(first.place)} at t = ${measure(first.t)}`;
    this.#context.say(`The ${this.#board.names[this.#look.type]} ${end}`);
  }

  #fanMarks(hits: readonly Hit[]): Mark[] {
    if (this.#rays > 90) return [];
    return hits.flatMap((hit): Mark[] => [
      { kind: "line", points: [this.#way.origin, hit.point], tone: "answer", thin: true },
      { kind: "dot", at: hit.point, tone: "touching-line" },
    ]);
  }

  #rayMarks(hits: readonly Hit[], unit: readonly number[]): Mark[] {
    const { stage } = this.#context;
    const { origin } = this.#way;
    const stop = this.#mode === "first" ? hits[0]?.point : undefined;
    const far = plus(origin, times(unit, Math.max(this.#reach(), hits.at(-1)?.t ?? 0)));
    const beyond: Mark[] = stop === undefined ? [] : [{ kind: "line", points: [stop, far], tone: "faint", dashed: true, thin: true }];
    return [
      ...beyond,
      { kind: "line", points: [origin, stop ?? far], tone: "answer" },
      ...hits.flatMap((hit, index): Mark[] => [
        { kind: "line", points: [hit.point, plus(hit.point, times(hit.normal, 34 * stage.lengthOfPixel(hit.point)))], tone: "second", arrow: true },
        { kind: "dot", at: hit.point, tone: "touching-line" },
        { kind: "label", at: hit.point, text: String(index + 1), tone: "touching-line", shift: this.#beside(hit.point, unit) },
      ]),
    ];
  }

  /** The offset of a number from the ray, to its left on the screen, in pixels. */
  #beside(point: readonly number[], unit: readonly number[]): Point2 {
    const { stage } = this.#context;
    const step = times(unit, 10 * stage.lengthOfPixel(point));
    const [[x, y], [toX, toY]] = [stage.toPixels(point), stage.toPixels(plus(point, step))];
    const length = Math.hypot(toX - x, toY - y);
    return length > 0 ? [(14 * (toY - y)) / length, (-14 * (toX - x)) / length + 4] : [0, -10];
  }

  #list(hits: readonly Hit[]): void {
    this.#hitList.replaceChildren(
      ...hits.map((hit, index) => {
        const tag = element("span", { class: "tag" }, measure(hit.t));
        const name = element("span", {}, `${index + 1}. ${this.#board.editor.nameOf(hit.place)}`);
        return element("li", {}, element("button", { type: "button", onclick: () => this.#board.editor.select(hit.place) }, name, tag));
      }),
    );
    this.#hitList.hidden = hits.length === 0;
  }

  #fillPanel(): void {
    const modes = [["first", "First hit"], ["all", "All hits"], ["fan", "Lamp"], ["cast", "Moving shape"]] as const;
    const showsFor = (): void => {
      lamp.hidden = this.#mode !== "fan";
      cast.hidden = this.#mode !== "cast";
    };
    const mode = choice<Mode>("Query", modes, this.#mode, (word) => {
      this.#mode = word;
      showsFor();
      this.#draw();
    });
    const lamp = slider({
      label: "Rays of the lamp", ...fanLimits, step: 12, value: this.#rays, text: countText,
      onInput: (value) => {
        this.#rays = value;
        this.#draw();
      },
    });
    const cast = this.#castControls;
    showsFor();
    this.#context.panel.append(
      title("Rays and casts"),
      element("p", { class: "lead" }, "Drag the handles. A ray reports its first hit, or all hits in order. A lamp casts rays in all directions and lights what they reach. A moving shape stops where it first touches something, and may rotate on its way."),
      this.#board.dimensionSwitch(),
      mode,
      this.#figures.root,
      section("Hits", this.#hitList, lamp, cast),
      section("Add", this.#board.addRow),
    );
  }

  /** Shapes have other names in 3D. */
  #fillCastControls(names: ShapeKit["names"]): void {
    const change = (look: Partial<MovingLook>): void => {
      this.#look = { ...this.#look, ...look };
      this.#draw();
    };
    const { type, size, turn } = this.#look;
    this.#castControls.replaceChildren(
      choice<MovingType>("The moving shape", movingTypes.map((word) => [word, names[word]] as const), type, (word) => change({ type: word })),
      slider({ label: "Size", least: sizeLimits.least, most: sizeLimits.most, step: 0.05, value: size, text: measure, onInput: (value) => change({ size: value }) }),
      slider({ label: "Rotation along the path", least: turnLimits.least, most: turnLimits.most, step: 15, value: turn, text: (value) => `${value}°`, onInput: (value) => change({ turn: value }) }),
    );
  }
}

/** A ray needs a direction, and a moving shape needs a path. */
function wayOf(parameters: URLSearchParams, ends: Way): Way {
  const way = { origin: pointOf(parameters, "", ends.origin), target: pointOf(parameters, "to-", ends.target) };
  if (lengthOf(minus(way.target, way.origin)) > 0) return way;
  return { ...way, target: way.origin.map((value, axis) => value + (axis === 0 ? 1 : 0)) };
}

export const rays: Chapter = {
  id: "rays",
  title: "Rays",
  open: (context) => new Rays(context),
};
