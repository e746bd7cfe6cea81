// SPDX-License-Identifier: MIT
// Scene view: a scene from a file, its objects and their contacts.
import type { Shape } from "graze";

import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { messageOf } from "../engine";
import { editByKey, Grasp, handlesOf, heldShape, type Held } from "../held_shape";
import { count as countText, counted, milliseconds } from "../numbers";
import type { Mark } from "../overlay";
import { button, Figures, row, section, title, toggle } from "../panel";
import { FrameControls } from "../scene/frame_controls";
import { examples, isReport, reportedSource, sourceOf } from "../scene/files";
import { inspect } from "../scene/inspector";
import { SceneDrawing } from "../scene/scene_drawing";
import { SceneModel, type SceneSource } from "../scene/scene_model";
import { VirtualList, type Row } from "../scene/virtual_list";
import { numberOf } from "../state";
import { between } from "../vectors";

/** The pointer selects objects within this distance in 2D, in pixels. */
const pointerReach = 5;
/** A press that moves farther than this rotates the view and selects nothing. */
const clickReach = 4;

class SceneView implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #listening = new AbortController();
  readonly #content = element("div");
  readonly #search = element("input", { type: "search", placeholder: "Search by name", "aria-label": "Search by name", id: "search" });
  readonly #objectList: VirtualList;
  readonly #pairList: VirtualList;
  readonly #inspector = element("div");
  readonly #figures = new Figures();
  #example = "";
  #model: SceneModel | undefined;
  #drawing: SceneDrawing | undefined;
  #frames: FrameControls | undefined;
  #matches: number[] = [];
  #pairMatches: number[] = [];
  #selected: number[] = [];
  #grasp = new Grasp();

  constructor(context: ChapterContext) {
    this.#context = context;
    this.#objectList = new VirtualList("Objects", (index) => this.#objectRow(index), (index) => this.#select([this.#matches[index] ?? 0]));
    this.#pairList = new VirtualList("Pairs that touch", (index) => this.#pairRow(index), (index) => this.#selectPair(index));
    this.#pairList.root.id = "pair-list";
    this.#objectList.root.id = "object-list";
    this.#search.addEventListener("input", () => this.#filter());
    const chooser = element("input", { type: "file", multiple: true, hidden: true, id: "scene-file" });
    chooser.addEventListener("change", () => this.onFiles([...(chooser.files ?? [])]));
    const buttons = Object.keys(examples).map((name) => button(`Example: ${name}`, () => this.#openExample(name)));
    context.panel.append(
      title("Scene"),
      element("p", { class: "lead" }, "Drop a scene file on the page: graze JSON, a CSV table, a Tiled map together with the files it refers to, or a recording (.aabbs). Nothing leaves this machine."),
      row(button("Open a file…", () => chooser.click()), ...buttons),
      chooser,
      this.#content,
    );
    this.#listenToPointer();
    const wanted = context.parameters.get("example");
    if (wanted === null && isReport) this.#open(reportedSource());
    else this.#openExample(wanted !== null && wanted in examples ? wanted : "workshop");
    const named = context.parameters.getAll("select").flatMap((name) => this.#model?.placeNamed(name) ?? []);
    if (named.length > 0) this.#select(named);
    const frame = numberOf(context.parameters, "frame", { least: 0, most: 1e9, usual: 0 });
    this.#frames?.show(frame);
  }

  parameters(): URLSearchParams {
    const parameters = new URLSearchParams();
    if (this.#example !== "") parameters.set("example", this.#example);
    if (this.#frames !== undefined) parameters.set("frame", String(this.#frames.frame));
    for (const place of this.#selected) parameters.append("select", this.#model?.objects[place]?.name ?? "");
    return parameters;
  }

  onKey(event: KeyboardEvent): boolean {
    if (event.key === "Escape") this.#select([]);
    else if (event.key === "z" && this.#selected.length > 0) this.#zoomTo(this.#selected.at(-1) ?? 0);
    else if (event.key === "/") this.#search.focus();
    else return this.#editByKey(event.key) || this.#frames?.onKey(event) === true;
    return true;
  }

  onFiles(files: readonly File[]): void {
    this.#example = "";
    sourceOf(files)
      .then((source) => this.#open(source))
      .catch((error: unknown) => this.#refuse(messageOf(error)));
  }

  close(): void {
    this.#listening.abort();
    this.#model?.close();
  }

  #openExample(name: string): void {
    const source = examples[name];
    if (source === undefined) return;
    this.#example = name;
    this.#open(source);
  }

  /** Shows a scene; the previous one stays if the file is not a scene. */
  #open(source: SceneSource): void {
    const { graze, stage, overlay } = this.#context;
    let model: SceneModel;
    try {
      model = new SceneModel(graze, source);
    } catch (error) {
      this.#refuse(messageOf(error));
      return;
    }
    this.#model?.close();
    overlay.clear();
    stage.clearDrawing();
    stage.animate(() => false);
    this.#model = model;
    this.#selected = [];
    this.#search.value = "";
    this.#drawing = new SceneDrawing(graze, stage, model);
    stage.onView(() => this.#showHandles());
    this.#fillPanel(model);
    this.#filter();
    this.#select([]);
  }

  #editByKey(key: string): boolean {
    const held = this.#held();
    return held !== undefined && editByKey(this.#context.stage, held, key);
  }

  /** The only selected object; undefined if it is unbounded, because those cannot be edited. */
  #held(): Held | undefined {
    const [place, more] = this.#selected;
    const model = this.#model;
    if (model === undefined || place === undefined || more !== undefined) return undefined;
    const { shape, box } = model.scene.object(model.id(place));
    const middle = between(box.min, box.max);
    if (!middle.every(Number.isFinite)) return undefined;
    return heldShape(model.objects[place]?.name ?? "", shape, middle, (edited) => this.#edit(place, edited));
  }

  /** Changes the shape of an object; if the engine refuses the shape, the old one stays. */
  #edit(place: number, shape: Shape): void {
    const model = this.#model;
    if (model === undefined) return;
    try {
      model.replace(place, shape);
    } catch (error) {
      this.#refuse(messageOf(error));
      return;
    }
    this.#drawing?.move(new Set([place]));
    this.#showPairs();
    this.#showSelection(model);
  }

  /** Shows a frame; if it is invalid, the old one stays. */
  #showFrame(frame: number): void {
    const model = this.#model;
    if (model === undefined) return;
    try {
      model.showFrame(frame);
    } catch (error) {
      this.#refuse(messageOf(error));
      return;
    }
    this.#drawing?.move(new Set(Array.from(model.timeline?.movers ?? [], (id) => model.placeOf(id) ?? -1)));
    this.#showPairs();
    this.#showSelection(model);
  }

  /** Called when the pairs have changed. */
  #showPairs(): void {
    const model = this.#model;
    if (model === undefined) return;
    this.#figures.set("pairs", "Pairs that touch", countText(model.pairs.length));
    this.#figures.set("candidates", "Candidates, boxes overlap", countText(model.candidates));
    this.#figures.set("time", "Search time", milliseconds(model.seconds * 1000));
    const touching = counted(model.pairs.length, "pair");
    this.#context.say(`${model.name}: ${counted(model.objects.length, "object")}, ${touching}`);
    this.#filterPairs(model);
  }

  #refuse(message: string): void {
    const text = element("p", { class: "message", role: "alert", id: "scene-error" }, message);
    this.#content.querySelector("#scene-error")?.remove();
    this.#content.prepend(text);
  }

  #fillPanel(model: SceneModel): void {
    this.#figures.set("source", "File", model.name);
    this.#figures.set("objects", "Objects", countText(model.objects.length));
    const { timeline } = model;
    this.#frames = timeline && new FrameControls(this.#context.stage, timeline, (frame) => this.#showFrame(frame));
    const omissions = model.omissions.map(({ what, count }) => `${count} × ${what}`).join(", ");
    const layers = model.layers.map((layer) =>
      toggle(layer, true, (on) => {
        if (on) model.hiddenLayers.delete(layer);
        else model.hiddenLayers.add(layer);
        this.#filter();
        this.#select(this.#selected.filter((place) => !model.isHidden(place)));
      }),
    );
    this.#content.replaceChildren(
      this.#figures.root,
      ...(this.#frames === undefined ? [] : [this.#frames.root]),
      ...(omissions === "" ? [] : [element("p", { class: "lead", id: "omissions" }, `Not read: ${omissions}.`)]),
      section("Selected", this.#inspector),
      section("Pairs", this.#pairList.root),
      section("Objects", this.#search, this.#objectList.root),
      ...(layers.length > 1 ? [section("Layers", ...layers)] : []),
    );
  }

  /** Filters the lists by visibility and by the search text. */
  #filter(): void {
    const model = this.#model;
    if (model === undefined) return;
    const fits = this.#searched(model);
    this.#matches = [...model.objects.keys()].filter((place) => !model.isHidden(place) && fits(place));
    this.#objectList.setCount(this.#matches.length);
    this.#showPairs();
  }

  #filterPairs(model: SceneModel): void {
    const fits = this.#searched(model);
    this.#pairMatches = [...model.pairs.keys()].filter((index) => {
      const pair = model.pairs[index];
      if (pair === undefined || model.isHidden(pair.a) || model.isHidden(pair.b)) return false;
      return fits(pair.a) || fits(pair.b);
    });
    this.#pairList.setCount(this.#pairMatches.length);
  }

  #searched(model: SceneModel): (place: number) => boolean {
    const text = this.#search.value.trim().toLowerCase();
    return (place) => text === "" || (model.objects[place]?.name.toLowerCase().includes(text) ?? false);
  }

  #objectRow(index: number): Row {
    const place = this.#matches[index] ?? 0;
    const object = this.#model?.objects[place];
    const relation = this.#model?.relationOf(place) ?? "apart";
    return { text: object?.name ?? "", tag: object?.type.replace("_", "-") ?? "", relation, isCurrent: this.#selected.includes(place) };
  }

  #pairRow(index: number): Row {
    const pair = this.#model?.pairs[this.#pairMatches[index] ?? 0];
    const name = (place: number | undefined): string => this.#model?.objects[place ?? 0]?.name ?? "";
    const isCurrent = pair !== undefined && this.#selected.includes(pair.a) && this.#selected.includes(pair.b);
    return { text: `${name(pair?.a)} · ${name(pair?.b)}`, tag: pair?.relation ?? "", relation: pair?.relation ?? "apart", isCurrent };
  }

  #selectPair(index: number): void {
    const pair = this.#model?.pairs[this.#pairMatches[index] ?? 0];
    if (pair === undefined) return;
    this.#select([pair.a, pair.b]);
  }

  #select(places: number[]): void {
    const model = this.#model;
    if (model === undefined) return;
    this.#selected = places;
    this.#grasp = new Grasp();
    this.#showSelection(model);
    const shown = this.#matches.indexOf(places[0] ?? -1);
    if (shown >= 0) this.#objectList.scrollTo(shown);
  }

  #showSelection(model: SceneModel): void {
    const places = this.#selected;
    this.#drawing?.paint(new Set(places));
    this.#objectList.refresh();
    this.#pairList.refresh();
    const actions = { select: (place: number) => this.#select([place]), zoomTo: (place: number) => this.#zoomTo(place) };
    this.#inspector.replaceChildren(
      ...(places.length === 0
        ? [element("p", { class: "lead" }, "Select an object in the drawing or in a list.")]
        : places.map((place) => inspect(this.#context.graze, model, place, actions))),
    );
    this.#mark();
    this.#context.changed();
  }

  /** The names of selected objects, and the contact of a selected pair. */
  #mark(): void {
    const model = this.#model;
    const drawing = this.#drawing;
    if (model === undefined || drawing === undefined) return;
    const labels = this.#selected.map((place): Mark => {
      const { min, max } = drawing.extentOf(place);
      const upmost = model.scene.yAxis === "down" && model.dimension === 2 ? min : max;
      const top = max.map((high, axis) => (axis === model.dimension - 1 ? (upmost[axis] ?? high) : (high + (min[axis] ?? 0)) / 2));
      return { kind: "label", at: top, text: model.objects[place]?.name ?? "", tone: "ink" };
    });
    const [a, b] = this.#selected;
    const contact = a === undefined || b === undefined ? null : this.#context.graze.contact(model.shape(a), model.shape(b));
    const isOverlap = a !== undefined && b !== undefined && contact !== null && this.#context.graze.relation(model.shape(a), model.shape(b)) === "overlapping";
    const dots: Mark[] = contact === null ? [] : [{ kind: "dot", at: contact.point, tone: isOverlap ? "overlapping-line" : "touching-line" }];
    this.#context.overlay.draw([...labels, ...dots]);
    this.#showHandles();
  }

  /** A single selected object can be edited. */
  #showHandles(): void {
    const { stage, overlay } = this.#context;
    const held = this.#held();
    overlay.setHandles(held === undefined ? [] : handlesOf(stage, held, this.#grasp));
  }

  #zoomTo(place: number): void {
    const extent = this.#drawing?.extentOf(place);
    if (extent === undefined) return;
    const all = this.#drawing?.extent ?? extent;
    const margin = Math.max(...extent.max.map((high, axis) => high - (extent.min[axis] ?? 0))) * 0.8;
    this.#context.stage.fit({
      min: extent.min.map((low, axis) => Math.max(low - margin, all.min[axis] ?? low)),
      max: extent.max.map((high, axis) => Math.min(high + margin, all.max[axis] ?? high)),
    });
  }

  #listenToPointer(): void {
    const { canvas } = this.#context.stage;
    const { signal } = this.#listening;
    let pressed: { x: number; y: number } | undefined;
    canvas.addEventListener("pointerdown", (event) => (pressed = { x: event.clientX, y: event.clientY }), { signal });
    canvas.addEventListener(
      "pointerup",
      (event) => {
        const far = pressed === undefined ? Infinity : Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y);
        if (far > clickReach) return;
        const place = this.#under(event);
        this.#select(place === undefined ? [] : [place]);
      },
      { signal },
    );
  }

  /** The object under the pointer: in 3D the first on the line of sight, in 2D the smallest. */
  #under(event: PointerEvent): number | undefined {
    const model = this.#model;
    if (model === undefined) return undefined;
    const { stage } = this.#context;
    const layers = model.seenLayers();
    if (model.dimension === 3) {
      const { origin, direction } = stage.sightLine(event);
      const hit = model.scene.rayCast({ origin: origin.toArray(), direction: direction.toArray() }, layers);
      return hit === null ? undefined : model.placeOf(hit.id);
    }
    const region = { type: "sphere", center: [...stage.planePoint(event)], radius: pointerReach / stage.pixelsPerUnit } as const;
    const found = model.scene.overlapping(region, layers);
    const boxes = model.scene.boxes(found);
    const area = (index: number): number => {
      const [minX = 0, minY = 0, maxX = 0, maxY = 0] = boxes.subarray(4 * index, 4 * index + 4);
      return (maxX - minX) * (maxY - minY);
    };
    const smallest = [...found.keys()].sort((a, b) => area(a) - area(b))[0];
    return smallest === undefined ? undefined : model.placeOf(found[smallest] ?? -1);
  }
}

export const sceneView: Chapter = {
  id: "scene",
  title: "Scene",
  open: (context) => new SceneView(context),
};
