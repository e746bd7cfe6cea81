// SPDX-License-Identifier: MIT
// Rays and casts: what a ray hits first, all that it hits in order, and what a lamp would light.
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

const usualShapes =
  "aabb:-1.4,1.1,0.2,2.5;obb:2.7,1.4,0.9,0.5,35;sphere:0.9,-1.6,0.75;triangle:2.7,-2.6,4.3,-1.9,3.1,-0.7;" +
  "capsule:-3.2,2.3,-2.4,1.2,0.3;polytope:-1.9,-2.7,-0.7,-2.4,-0.9,-1.3,-2.2,-1.5;segment:4.6,-0.4,4.9,2.8;sphere:1.5,0.25,0.3;" +
  "obb:-4.4,-1.7,0.25,0.8,-20;sphere:1.3,2.75,0.4";

const addable: readonly FlatType[] = ["sphere", "aabb", "obb", "triangle", "capsule", "polytope", "segment", "plane", "half_space", "compound"];
const fanLimits = { least: 12, most: 1440, usual: 720 } as const;

type Mode = "first" | "all" | "fan";

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

  constructor(context: ChapterContext) {
    this.#context = context;
    const { stage, parameters } = context;
    stage.showFlat({ min: [-5.4, -3.6], max: [5.4, 3.6] });
    new Grid(stage);
    const coordinate = (name: string, usual: number): number => numberOf(parameters, name, { least: -1e6, most: 1e6, usual });
    this.#origin = [coordinate("x", -3.4), coordinate("y", -0.25)];
    this.#target = [coordinate("to-x", -2.3), coordinate("to-y", -0.15)];
    if (lengthOf(minus(this.#target, this.#origin)) === 0) this.#target = plus(this.#origin, [1, 0]);
    this.#mode = wordOf(parameters, "mode", ["first", "all", "fan"]);
    this.#rays = Math.round(numberOf(parameters, "rays", fanLimits));
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
    return new URLSearchParams({ mode: this.#mode, x: x ?? "", y: y ?? "", "to-x": toX ?? "", "to-y": toY ?? "", rays: String(this.#rays), shapes });
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
    this.#context.changed();
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
    const mode = choice<Mode>("What is asked", [["first", "First hit"], ["all", "All hits"], ["fan", "Lamp"]], this.#mode, (word) => {
      this.#mode = word;
      this.#draw();
    });
    this.#context.panel.append(
      element("h2", {}, "Rays and casts"),
      element("p", { class: "lead" }, "Drag the start of the ray and its direction. A lamp sends rays all round; each stops at the first shape, and what they reach is lit."),
      mode,
      this.#figures.root,
      section("Hits", this.#hitList, slider({
        label: "Rays of the lamp", ...fanLimits, step: 12, value: this.#rays, text: countText,
        onInput: (value) => {
          this.#rays = value;
          this.#draw();
        },
      })),
      section("Add", row(...addable.map((type) => button(shapeNames[type], () => this.#editor.add(type))))),
    );
  }
}

export const rays: Chapter = {
  id: "rays",
  title: "Rays",
  open: (context) => new Rays(context),
};
