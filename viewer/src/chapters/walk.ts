// SPDX-License-Identifier: MIT
// A capsule that is walked through a level with the arrow keys: what it touches, and what it stands on.
import { Board, dimensionOf } from "../board";
import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { drawingsOf } from "../drawing/drawings";
import { MeshDrawing } from "../drawing/mesh_drawing";
import { Paint } from "../drawing/paint";
import { counted, duration, rounded } from "../numbers";
import { plumb, type Mark, type SpaceHandle } from "../overlay";
import { button, Figures, row, section, slider, title } from "../panel";
import type { ShapeType } from "../shapes/flat_shape";
import type { ShapeKit } from "../shapes/shape_kit";
import { numberOf, pointOf, writePoint } from "../state";
import { lengthOf, minus, plus, times } from "../vectors";
import { WalkKeys } from "../walk_keys";
import { Walker, type WalkerLook, type WalkerTouch } from "../walker";

/** Stairs, a stone, a ramp to a platform with a steep back, and ledges; in 3D a part of that, and a steep pyramid. */
const usual = {
  2: "half_space:0,1,0;aabb:-6.6,0,-6.2,9;aabb:6.2,0,6.6,9;aabb:-4.7,0,-3.5,0.3;aabb:-3.5,0,-2.3,0.6;aabb:-2.3,0,-1.1,0.9;" +
    "sphere:-0.1,-0.35,0.6;triangle:0.9,0,3.5,0,3.5,1.4;aabb:3.5,0,4.6,1.4;triangle:4.6,0,5.1,0,4.6,1.4;" +
    "aabb:-6.2,2.6,-4.4,2.85;aabb:-2.9,3,-1.2,3.25;obb:0.9,3.9,1.3,0.12,20;aabb:2.6,4.6,5.2,4.85;sphere:3.9,6.75,0.55;" +
    "polytope:-5.6,5.7,-4.4,5.3,-3.3,5.8,-3.6,6.7,-5.1,6.9",
  3: "half_space:0,0,1,0;aabb:-2.8,1.4,0,-1.8,2.8,0.3;aabb:-1.8,1.4,0,-0.8,2.8,0.6;aabb:-0.8,1.4,0,0.6,2.8,0.9;" +
    "polytope:0.6,1.4,0,0.6,2.8,0,0.6,1.4,0.9,0.6,2.8,0.9,2.5,1.4,0,2.5,2.8,0;obb:0.6,-0.2,0.6,1.3,0.12,0.6,0,0,25;" +
    "capsule:-2.2,-1.6,0,-2.2,-1.6,1.2,0.35;polytope:1.2,-2.8,0,2.8,-2.8,0,2.8,-1.4,0,1.2,-1.4,0,2,-2.1,1.3;sphere:-0.6,-2.3,-0.2,0.55",
} as const;
const extent = {
  2: { min: [-6.6, -0.8], max: [6.6, 8.2] },
  3: { min: [-3.4, -3.2, 0], max: [3.2, 3.2, 2.2] },
} as const;
const usualPlace = { 2: [-5.5, 0.01], 3: [-2.8, 0.2, 0.01] } as const;
const slopeLimits = { least: 0, most: 80, usual: 50 } as const;
const stepLimits = { least: 0, most: 1, usual: 0.35 } as const;
const addable: readonly ShapeType[] = ["sphere", "aabb", "obb", "triangle", "capsule", "polytope", "segment", "half_space", "compound"];

/** The world advances in steps of this many seconds. */
const stepSeconds = 1 / 60;
/** A slow browser skips steps beyond this number per picture. */
const mostSteps = 6;
/** The number of steps whose places stay visible. */
const trailLength = 180;

class Walk implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #board: Board;
  readonly #figures = new Figures();
  readonly #touchList = element("ul", { class: "list", "aria-label": "What it touches" });
  readonly #keys: WalkKeys;
  readonly #places: Record<2 | 3, readonly number[]>;
  #look: WalkerLook;
  #walker!: Walker;
  #capsule!: MeshDrawing;
  #trail: (readonly number[])[] = [];
  /** The time up to which the world has advanced; undefined while it stands still. */
  #time: number | undefined;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { parameters, stage } = context;
    const dimension = dimensionOf(parameters);
    this.#places = { ...usualPlace, [dimension]: pointOf(parameters, "", usualPlace[dimension]) };
    this.#look = { slope: numberOf(parameters, "slope", slopeLimits), step: numberOf(parameters, "step", stepLimits) };
    this.#keys = new WalkKeys(() => this.#wake());
    this.#board = new Board(context, {
      usual, extent, addable,
      onChange: () => this.#change(),
      onOpen: (kit) => this.#open(kit),
      ownHandles: () => [this.#handle()],
    });
    this.#enter();
    this.#fillPanel();
    this.#draw();
    stage.animate((now) => this.#advance(now));
    if (!window.matchMedia("(prefers-reduced-motion: reduce)").matches) this.#wake();
  }

  /** Defaults are left out. */
  parameters(): URLSearchParams {
    const parameters = new URLSearchParams();
    const { place } = this.#walker;
    const start = usualPlace[this.#board.dimension];
    if (place.some((value, axis) => rounded(value) !== start[axis])) writePoint(parameters, "", place);
    if (this.#look.slope !== slopeLimits.usual) parameters.set("slope", String(rounded(this.#look.slope)));
    if (this.#look.step !== stepLimits.usual) parameters.set("step", String(rounded(this.#look.step)));
    this.#board.describe(parameters);
    if (this.#board.isUsual) parameters.delete("shapes");
    return parameters;
  }

  onKey(event: KeyboardEvent): boolean {
    return this.#keys.onKey(event) || this.#board.editor.onKey(event);
  }

  close(): void {
    this.#keys.close();
    this.#board.close();
  }

  /** Called before the editor of the dimension is in place. */
  #open(kit: ShapeKit): void {
    const { stage } = this.#context;
    this.#capsule = new MeshDrawing(kit.dimension, stage.palette, { fill: kit.dimension === 2 ? 0.3 : 0.45, lineWidth: 2.5 });
    this.#capsule.object.renderOrder = 2;
    stage.world.add(this.#capsule.object);
    const capsule = this.#capsule;
    stage.onTheme(() => capsule.setPalette(stage.palette));
  }

  /** Puts the capsule among the shapes of the dimension. */
  #enter(): void {
    const { editor, dimension } = this.#board;
    this.#walker = new Walker(editor.scene, this.#places[dimension], this.#look);
    this.#trail = [];
  }

  /** After a change of the shapes, of the dimension or of a 2D view. */
  #change(): void {
    if (this.#walker.place.length !== this.#board.dimension) {
      this.#places[this.#walker.place.length === 2 ? 2 : 3] = this.#walker.place;
      this.#enter();
    } else {
      this.#walker.feel();
    }
    this.#wake();
    this.#draw();
  }

  #wake(): void {
    this.#time ??= performance.now();
    this.#context.stage.invalidate();
  }

  /** Advances the world to the time of a picture; returns whether anything will move after it. */
  #advance(now: number): boolean {
    if (this.#time === undefined) return false;
    const steps = Math.min(mostSteps, Math.max(0, Math.floor((now - this.#time) / 1000 / stepSeconds)));
    this.#time = steps === mostSteps ? now : this.#time + steps * stepSeconds * 1000;
    for (let i = 0; i < steps; ++i) this.#step();
    if (steps > 0) this.#show();
    if (steps > 0 && this.#walker.isStill && !this.#keys.isHeld) this.#time = undefined;
    return this.#time !== undefined;
  }

  #step(): void {
    if (this.#keys.isDragged) return;
    this.#walker.step(this.#direction(), this.#keys.jumps(this.#board.dimension), stepSeconds);
    this.#keys.forgetTaps();
    this.#trail.push(this.#walker.middle);
    if (this.#trail.length > trailLength) this.#trail.shift();
  }

  /** In 3D the up arrow leads away from the camera. */
  #direction(): readonly number[] {
    const { right, ahead } = this.#keys;
    if (this.#board.dimension === 2) return [right, 0];
    const [x = 0, y = 0] = this.#context.stage.sight;
    const forth = times([x, y, 0], 1 / Math.hypot(x, y));
    const aside = [forth[1] ?? 0, -(forth[0] ?? 0), 0];
    const way = plus(times(aside, right), times(forth, ahead));
    const length = lengthOf(way);
    return length > 0 ? times(way, 1 / length) : way;
  }

  #handle(): SpaceHandle {
    return {
      key: "walker", label: "The capsule", at: this.#walker.middle,
      onMoveInSpace: (to) => {
        this.#walker.pull(to);
        this.#trail = [];
        this.#wake();
        this.#show();
      },
    };
  }

  #draw(): void {
    this.#board.editor.draw(this.#paints(), () => this.#marks());
    this.#tell();
  }

  /** Draws again without the shapes. */
  #show(): void {
    this.#board.editor.recolour(this.#paints(), () => this.#marks());
    this.#tell();
  }

  #paints(): Paint[] {
    const { editor, shapes } = this.#board;
    const touched = new Set(this.#walker.touches.map(({ id }) => editor.placeOf(id)));
    return shapes.map((_, place) => (touched.has(place) ? Paint.touching : Paint.free));
  }

  /** Its way, and the normals at what it touches, with the slope of the surface. */
  #marks(): Mark[] {
    const { stage } = this.#context;
    const { touches, ground, place } = this.#walker;
    const trail: Mark[] = this.#trail.length < 2 ? [] : [{ kind: "line", points: this.#trail, tone: "answer", dashed: true, thin: true }];
    const normals = touches.flatMap(({ points, normal, slope }) =>
      points.flatMap((point, index): Mark[] => {
        const end = plus(point, times(normal, 34 * stage.lengthOfPixel(point)));
        const label: Mark = { kind: "label", at: point, text: degrees(slope), tone: "second", shift: this.#beside(point, normal) };
        return [
          { kind: "line", points: [point, end], tone: "second", arrow: true },
          { kind: "dot", at: point, tone: "touching-line" },
          ...(index === 0 ? [label] : []),
        ];
      }),
    );
    return [...(ground === undefined ? plumb(place, extent[3].min[2]) : []), ...trail, ...normals];
  }

  /** The offset of a label from a touched point, in pixels: into the shape. */
  #beside(point: readonly number[], normal: readonly number[]): readonly [number, number] {
    const { stage } = this.#context;
    const [[x, y], [toX, toY]] = [stage.toPixels(point), stage.toPixels(minus(point, times(normal, 18 * stage.lengthOfPixel(point))))];
    return [toX - x, toY - y + 4];
  }

  #tell(): void {
    const { graze } = this.#context;
    const { editor, dimension } = this.#board;
    const { touches, ground, shape, spent } = this.#walker;
    this.#capsule.set([drawingsOf(graze, shape, dimension, { corners: dimension === 2 ? 64 : 32 })], new Uint8Array([Paint.found]));
    const name = ground === undefined ? undefined : editor.nameOf(editor.placeOf(ground.id));
    this.#figures.set("ground", "Stands on", name ?? "nothing");
    this.#figures.set("slope", "Slope of that ground", ground === undefined ? "–" : degrees(ground.slope));
    this.#figures.set("touches", "Shapes touched", String(touches.length));
    this.#figures.set("points", "Contact points", String(touches.reduce((sum, { points }) => sum + points.length, 0)));
    this.#figures.set("time", "Mean time of a slide", spent === undefined ? "–" : duration(spent));
    this.#list(touches);
    const others = touches.length - (ground === undefined ? 0 : 1);
    const also = others > 0 ? `, touches ${counted(others, ground === undefined ? "shape" : "other shape")}` : "";
    this.#context.say(name === undefined ? `The capsule is in the air${also}` : `The capsule stands on ${name}${also}`);
    this.#context.changed();
  }

  #list(touches: readonly WalkerTouch[]): void {
    const { editor } = this.#board;
    this.#touchList.replaceChildren(
      ...touches.map(({ id, slope }) => {
        const place = editor.placeOf(id);
        const tag = element("span", { class: "tag" }, `${kindOf(slope, this.#look.slope)}, ${degrees(slope)}`);
        return element("li", {}, element("button", { type: "button", onclick: () => editor.select(place) }, element("span", {}, editor.nameOf(place)), tag));
      }),
    );
    this.#touchList.hidden = touches.length === 0;
  }

  #setLook(look: Partial<WalkerLook>): void {
    this.#look = { ...this.#look, ...look };
    this.#walker.look = this.#look;
    this.#change();
  }

  #restart(): void {
    this.#walker.put(usualPlace[this.#board.dimension]);
    this.#trail = [];
    this.#wake();
    this.#show();
  }

  #fillPanel(): void {
    const { slope, step } = this.#look;
    this.#context.panel.append(
      title("Walk"),
      element("p", { class: "lead" }, "Walk with the arrow keys, jump with Space. The capsule slides along what it meets, climbs slopes and steps up to the limits below, and passes through nothing. Drag it, or the shapes."),
      this.#board.dimensionSwitch(),
      this.#keys.pad,
      this.#figures.root,
      section(
        "Limits",
        slider({ label: "Steepest ground", least: slopeLimits.least, most: slopeLimits.most, step: 1, value: slope, text: degrees, onInput: (value) => this.#setLook({ slope: value }) }),
        slider({ label: "Highest step", least: stepLimits.least, most: stepLimits.most, step: 0.05, value: step, text: (value) => value.toFixed(2), onInput: (value) => this.#setLook({ step: value }) }),
        row(button("Back to the start", () => this.#restart())),
      ),
      section("Touches", this.#touchList),
      section("Add", this.#board.addRow),
    );
  }
}

function degrees(angle: number): string {
  return `${Math.round(angle)}°`;
}

function kindOf(slope: number, limit: number): string {
  if (slope <= limit + 1e-6) return "ground";
  if (slope > 91) return "ceiling";
  return slope > 89 ? "wall" : "steep";
}

export const walk: Chapter = {
  id: "walk",
  title: "Walk",
  open: (context) => new Walk(context),
};
