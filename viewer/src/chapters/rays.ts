// SPDX-License-Identifier: MIT
// Rays and casts: what a ray hits first, all that it hits in order, what a lamp would light, and where a shape that moves
// first touches something.
import * as THREE from "three";

import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { Grid } from "../drawing/grid";
import { Paint } from "../drawing/paint";
import { Editor } from "../editor";
import { count as countText, duration, measure, rounded } from "../numbers";
import type { Handle, Mark } from "../overlay";
import { button, choice, Figures, row, section, slider } from "../panel";
import { heading, lengthOf, minus, plus, shapeNames, sideways, times, type FlatType } from "../shapes/flat_shape";
import { shapesOfText, textOfShapes } from "../shapes/text";
import { numberOf, wordOf } from "../state";
import type { Point2 } from "../stage";
import { MovingShape, movingTypes, type MovingType } from "./moving_shape";

const usualShapes =
  "aabb:-1.4,1.1,0.2,2.5;obb:2.7,1.4,0.9,0.5,35;sphere:0.9,-1.6,0.75;triangle:2.7,-2.6,4.3,-1.9,3.1,-0.7;" +
  "capsule:-3.2,2.3,-2.4,1.2,0.3;polytope:-1.9,-2.7,-0.7,-2.4,-0.9,-1.3,-2.2,-1.5;segment:4.6,-0.4,4.9,2.8;sphere:1.5,0.25,0.3;" +
  "obb:-4.4,-1.7,0.25,0.8,-20;sphere:1.3,2.75,0.4";

const addable: readonly FlatType[] = ["sphere", "aabb", "obb", "triangle", "capsule", "polytope", "segment", "plane", "half_space", "compound"];
const fanLimits = { least: 12, most: 1440, usual: 720 } as const;
const sizeLimits = { least: 0.05, most: 1.5, usual: 0.45 } as const;
const turnLimits = { least: -360, most: 360, usual: 0 } as const;

type Mode = "first" | "all" | "fan" | "cast";

interface Hit {
  readonly point: Point2;
  readonly normal: Point2;
  readonly place: number;
  readonly t: number;
}

class Rays implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #editor: Editor;
  readonly #figures = new Figures();
  readonly #hitList = element("ul", { class: "list", "aria-label": "What is hit, in order" });
  readonly #lit = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.2, depthTest: false, side: THREE.DoubleSide }));
  #origin: Point2;
  #target: Point2;
  #mode: Mode;
  #rays: number;
  readonly #moving: MovingShape;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { stage, parameters } = context;
    stage.showFlat({ min: [-5.4, -3.6], max: [5.4, 3.6] });
    new Grid(stage);
    const coordinate = (name: string, usual: number): number => numberOf(parameters, name, { least: -1e6, most: 1e6, usual });
    this.#origin = [coordinate("x", -3.4), coordinate("y", -0.25)];
    this.#target = [coordinate("to-x", -2.3), coordinate("to-y", -0.15)];
    if (lengthOf(minus(this.#target, this.#origin)) === 0) this.#target = plus(this.#origin, [1, 0]);
    this.#mode = wordOf(parameters, "mode", ["first", "all", "fan", "cast"]);
    this.#rays = Math.round(numberOf(parameters, "rays", fanLimits));
    this.#moving = new MovingShape(context, {
      type: wordOf(parameters, "moving", movingTypes),
      size: numberOf(parameters, "size", sizeLimits),
      turn: numberOf(parameters, "turn", turnLimits),
    });
    this.#lit.frustumCulled = false;
    stage.world.add(this.#lit);
    const shapes = shapesOfText(parameters.get("shapes") ?? "") ?? shapesOfText(usualShapes) ?? [];
    this.#editor = new Editor(context, { shapes, onChange: () => this.#draw(), ownHandles: () => this.#handles() });
    stage.onView(() => this.#draw());
    stage.onTheme(() => this.#draw());
    this.#fillPanel();
    this.#draw();
  }

  parameters(): URLSearchParams {
    const [x, y, toX, toY] = [...this.#origin, ...this.#target].map((value) => String(rounded(value)));
    const shapes = textOfShapes(this.#editor.shapes);
    const { type, size, turn } = this.#moving.look;
    const parameters = new URLSearchParams({ mode: this.#mode, x: x ?? "", y: y ?? "", "to-x": toX ?? "", "to-y": toY ?? "" });
    const own = this.#mode === "cast" ? { moving: type, size: rounded(size), turn: rounded(turn) } : { rays: this.#rays };
    for (const [name, value] of Object.entries(own)) parameters.set(name, String(value));
    parameters.set("shapes", shapes);
    return parameters;
  }

  onKey(event: KeyboardEvent): boolean {
    return this.#editor.onKey(event);
  }

  close(): void {
    this.#editor.close();
  }

  #handles(): Handle[] {
    const origin: Handle = {
      key: "origin", label: "Start of the ray", at: this.#origin,
      onMove: (to) => {
        this.#target = plus(to, minus(this.#target, this.#origin));
        this.#origin = to;
        this.#draw();
      },
    };
    const target: Handle = {
      key: "target", label: "Direction of the ray", at: this.#target,
      onMove: (to) => {
        if (lengthOf(minus(to, this.#origin)) > 0) this.#target = to;
        this.#draw();
      },
    };
    if (this.#mode === "cast") return [{ ...origin, label: "Start of the shape" }, { ...target, label: "End of its way" }];
    return this.#mode === "fan" ? [origin] : [origin, target];
  }

  /** Beyond this nothing is seen. */
  #reach(): number {
    const { min, max } = this.#context.stage.seenPlane();
    const corners = [[min[0], min[1]], [max[0], max[1]], [min[0], max[1]], [max[0], min[1]]] as const;
    return Math.max(...corners.map(([x = 0, y = 0]) => lengthOf(minus([x, y], this.#origin)))) * 1.1;
  }

  #cast(direction: Point2, all: boolean): Hit[] {
    const ray = { origin: [...this.#origin], direction: [...direction] };
    const first = all ? undefined : this.#editor.scene.rayCast(ray);
    const hits = all ? this.#editor.scene.rayCastAll(ray) : first === null || first === undefined ? [] : [first];
    return hits.map(({ id, point, normal, t }) => ({
      point: [point[0] ?? 0, point[1] ?? 0], normal: [normal[0] ?? 0, normal[1] ?? 0], place: this.#editor.placeOf(id), t,
    }));
  }

  #draw(): void {
    if (this.#mode === "cast") this.#drawCast();
    else this.#drawRays();
    this.#context.changed();
  }

  #drawRays(): void {
    this.#moving.hide();
    const start = performance.now();
    const isFan = this.#mode === "fan";
    const headings = isFan ? Array.from({ length: this.#rays }, (_, i) => heading((360 * i) / this.#rays)) : [];
    const unit = times(minus(this.#target, this.#origin), 1 / lengthOf(minus(this.#target, this.#origin)));
    const fan = headings.map((direction) => this.#cast(direction, false)[0]);
    const hits = isFan ? fan.filter((hit) => hit !== undefined) : this.#cast(unit, this.#mode === "all");
    const spent = performance.now() - start;
    const places = new Set(hits.map((hit) => hit.place));
    const reach = this.#reach();
    this.#light(headings.map((direction, i) => fan[i]?.point ?? plus(this.#origin, times(direction, reach))));
    const marks = isFan ? this.#fanMarks(hits) : this.#rayMarks(hits, unit, reach);
    this.#editor.draw(this.#editor.shapes.map((_, place) => (places.has(place) ? Paint.touching : Paint.free)), marks);
    this.#figures.set("rays", "Rays", countText(isFan ? this.#rays : 1));
    this.#figures.set("hits", "Shapes hit", String(places.size));
    this.#figures.set("t", "Distance of the first", hits[0] === undefined || isFan ? "–" : measure(hits[0].t));
    this.#figures.set("time", "Time of all rays", duration(spent));
    this.#list(isFan ? [] : hits);
    this.#context.say(isFan ? `${countText(this.#rays)} rays see ${places.size} shapes` : `${places.size} hit`);
  }

  /** The shape at its start, on its way, and where it first touches something. */
  #drawCast(): void {
    const { shapes } = this.#editor;
    const { impacts, refused, spent } = this.#moving.cast(this.#origin, this.#target, shapes);
    const first = impacts[0];
    this.#light([]);
    this.#editor.draw(shapes.map((_, place) => (place === first?.place ? Paint.touching : Paint.free)), this.#moving.draw(first));
    this.#figures.set("rays", "Shapes asked", countText(shapes.length - refused));
    this.#figures.set("hits", "Shapes in the way", String(impacts.length));
    this.#figures.set("t", "Time of the first touch", first === undefined ? "–" : measure(first.t));
    this.#figures.set("time", "Time of all casts", duration(spent));
    this.#list(impacts);
    const end = first === undefined ? "touches nothing" : `touches ${this.#editor.nameOf(first.place)} at t = ${measure(first.t)}`;
    this.#context.say(`The ${shapeNames[this.#moving.look.type]} ${end}${refused > 0 ? `; ${refused} cannot be asked while it turns` : ""}`);
  }

  /** What the fan reaches, as triangles about its start. */
  #light(rim: readonly Point2[]): void {
    const positions = rim.flatMap((point, i) => {
      const next = rim[(i + 1) % rim.length] ?? point;
      return [...this.#origin, 0, ...point, 0, ...next, 0];
    });
    this.#lit.geometry.dispose();
    this.#lit.geometry = new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
    this.#lit.material.color.set(this.#context.stage.palette.answer);
    this.#lit.visible = rim.length > 0;
  }

  #fanMarks(hits: readonly Hit[]): Mark[] {
    if (this.#rays > 90) return [];
    return hits.flatMap((hit): Mark[] => [
      { kind: "line", points: [this.#origin, hit.point], tone: "answer", thin: true },
      { kind: "dot", at: hit.point, tone: "touching-line" },
    ]);
  }

  #rayMarks(hits: readonly Hit[], unit: Point2, reach: number): Mark[] {
    const stop = this.#mode === "first" ? hits[0]?.point : undefined;
    const far = plus(this.#origin, times(unit, reach));
    const normalLength = 34 / this.#context.stage.pixelsPerUnit;
    const beyond: Mark[] = stop === undefined ? [] : [{ kind: "line", points: [stop, far], tone: "faint", dashed: true, thin: true }];
    return [
      ...beyond,
      { kind: "line", points: [this.#origin, stop ?? far], tone: "answer" },
      ...hits.flatMap((hit, index): Mark[] => [
        { kind: "line", points: [hit.point, plus(hit.point, times(hit.normal, normalLength))], tone: "second", arrow: true },
        { kind: "dot", at: hit.point, tone: "touching-line" },
        { kind: "label", at: plus(hit.point, times(sideways(unit), 14 / this.#context.stage.pixelsPerUnit)), text: String(index + 1), tone: "touching-line", shift: [0, 4] },
      ]),
    ];
  }

  #list(hits: readonly Hit[]): void {
    this.#hitList.replaceChildren(
      ...hits.map((hit, index) => {
        const tag = element("span", { class: "tag" }, measure(hit.t));
        const name = element("span", {}, `${index + 1}. ${this.#editor.nameOf(hit.place)}`);
        return element("li", {}, element("button", { type: "button", onclick: () => this.#editor.select(hit.place) }, name, tag));
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
    const mode = choice<Mode>("What is asked", modes, this.#mode, (word) => {
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
    const cast = this.#castControls();
    showsFor();
    this.#context.panel.append(
      element("h2", {}, "Rays and casts"),
      element("p", { class: "lead" }, "Drag the start of the ray and its direction. A lamp sends rays all round; each stops at the first shape, and what they reach is lit. A moving shape, which may turn on its way, stops where it first touches something."),
      mode,
      this.#figures.root,
      section("Hits", this.#hitList, lamp, cast),
      section("Add", row(...addable.map((type) => button(shapeNames[type], () => this.#editor.add(type))))),
    );
  }

  #castControls(): HTMLElement {
    const change = (look: Partial<MovingShape["look"]>): void => {
      this.#moving.look = { ...this.#moving.look, ...look };
      this.#draw();
    };
    const { type, size, turn } = this.#moving.look;
    return element(
      "div",
      {},
      choice<MovingType>("The moving shape", movingTypes.map((word) => [word, shapeNames[word]] as const), type, (word) => change({ type: word })),
      slider({ label: "Size", least: sizeLimits.least, most: sizeLimits.most, step: 0.05, value: size, text: measure, onInput: (value) => change({ size: value }) }),
      slider({ label: "Turn on the way", least: turnLimits.least, most: turnLimits.most, step: 15, value: turn, text: (value) => `${value}°`, onInput: (value) => change({ turn: value }) }),
    );
  }
}

export const rays: Chapter = {
  id: "rays",
  title: "Rays",
  open: (context) => new Rays(context),
};
