// SPDX-License-Identifier: MIT
// Meshes of triangles from files: the face under the pointer, contacts of parts, what is inside, and what is wrong.
import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { Grid } from "../drawing/grid";
import { Paint, paintOfRelation } from "../drawing/paint";
import { messageOf } from "../engine";
import { editByKey, Grasp, handlesOf, type Held } from "../held_shape";
import { turnedUp, type MeshSource } from "../meshes/mesh_data";
import { meshesOf } from "../meshes/mesh_files";
import { MeshModel, type PartHit } from "../meshes/mesh_model";
import { ReportView, showFaults } from "../meshes/mesh_report";
import { ContactView } from "../meshes/contact_view";
import { FaceView } from "../meshes/face_view";
import { PartDrawing } from "../meshes/part_drawing";
import { PartPointer } from "../meshes/part_pointer";
import { samples } from "../meshes/samples";
import { SliceView } from "../meshes/slice_view";
import { count as countText, counted, rounded } from "../numbers";
import type { SpaceHandle } from "../overlay";
import { button, choice, Figures, row, section, title, toggle } from "../panel";
import type { Extent } from "../stage";
import { numberOf, wordOf } from "../state";

type Mode = "faces" | "contacts" | "inside";

/** What each sample shows best. */
const usualModes: Readonly<Record<string, Mode>> = { gears: "contacts", knot: "faces", broken: "inside", terrain: "contacts" };
/** A part rests if it was not moved for so many milliseconds. */
const restAfter = 180;
const poseNames = ["dx", "dy", "dz", "qx", "qy", "qz", "qw"] as const;

const usualPose = (name: (typeof poseNames)[number]): number => (name === "qw" ? 1 : 0);

class Meshes implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #content = element("div");
  readonly #modeControls = element("div");
  readonly #partList = element("ul", { class: "list", "aria-label": "Parts", id: "part-list" });
  readonly #figures = new Figures();
  readonly #report = new ReportView((faces) => this.#paintCrossings(faces));
  readonly #faces: FaceView;
  readonly #contacts: ContactView;
  readonly #slice: SliceView;
  readonly #pointer: PartPointer;
  #sample = "";
  #mode: Mode = "faces";
  #model: MeshModel | undefined;
  #drawings: PartDrawing[] = [];
  #selected = 0;
  #grasp = new Grasp();
  #isQueued = false;
  /** Runs when a part that was moved has come to rest. */
  #rest: number | undefined;
  /** Counts what was opened, so that a slow file does not replace what was opened after it. */
  #opened = 0;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { parameters, stage, graze } = context;
    this.#faces = new FaceView(context);
    this.#contacts = new ContactView(context);
    this.#slice = new SliceView(context, { onChange: () => this.#sliceChanged() });
    this.#pointer = new PartPointer(stage, {
      under: (event) => this.#under(event),
      drags: () => this.#mode === "contacts",
      onHover: (hit) => this.#hover(hit),
      onPress: (hit) => this.#press(hit),
      onDrag: (place, offset) => {
        this.#model?.parts[place]?.move(offset);
        this.#movedSoon();
      },
      onDrop: () => this.#showMoved(false),
    });
    this.#fillPanel();
    const wanted = parameters.get("example") ?? "";
    const name = wanted in samples ? wanted : (Object.keys(samples)[0] ?? "");
    this.#mode = wordOf(parameters, "mode", [usualModes[name] ?? "faces", "faces", "contacts", "inside"]);
    this.#selected = numberOf(parameters, "part", { least: 0, most: 1e9, usual: 0 });
    this.#openSample(name, parameters.get("kind") === "surface" ? "surface" : "solid");
    this.#restorePose(parameters);
    this.#faces.restore(parameters, (ray) => this.#model?.hit(graze, ray));
    this.#showMode();
  }

  /** Defaults are left out. */
  parameters(): URLSearchParams {
    const parameters = new URLSearchParams();
    if (this.#sample !== "" && this.#sample !== Object.keys(samples)[0]) parameters.set("example", this.#sample);
    if (this.#mode !== (usualModes[this.#sample] ?? "faces")) parameters.set("mode", this.#mode);
    if (this.#model?.kind === "surface") parameters.set("kind", "surface");
    if (this.#selected !== 0) parameters.set("part", String(this.#selected));
    const part = this.#model?.parts[this.#selected];
    if (part?.isMoved === true) {
      const { offset, rotation } = part.pose;
      poseNames.forEach((name, place) => {
        const value = rounded([...offset, ...rotation][place] ?? 0);
        if (value !== usualPose(name)) parameters.set(name, String(value));
      });
    }
    if (this.#mode === "faces") this.#faces.describe(parameters);
    if (this.#mode === "inside") this.#slice.describe(parameters);
    return parameters;
  }

  onKey(event: KeyboardEvent): boolean {
    const held = this.#mode === "contacts" ? this.#held() : undefined;
    return held !== undefined && editByKey(this.#context.stage, held, event.key);
  }

  onFiles(files: readonly File[]): void {
    const opened = ++this.#opened;
    this.#context.say(`Reading ${counted(files.length, "file")}…`);
    meshesOf(files)
      // A moment for the caption to appear.
      .then((source) => new Promise<MeshSource>((resolve) => setTimeout(() => resolve(source), 30)))
      .then((source) => {
        if (opened !== this.#opened) return;
        this.#sample = "";
        this.#selected = 0;
        this.#open(source, "solid");
        this.#showMode();
      })
      .catch((error: unknown) => {
        if (opened === this.#opened) this.#refuse(messageOf(error));
      });
  }

  close(): void {
    ++this.#opened;
    window.clearTimeout(this.#rest);
    this.#pointer.close();
    this.#slice.close();
    this.#model?.close();
    this.#model = undefined;
  }

  #openSample(name: string, kind: "surface" | "solid"): void {
    const source = samples[name]?.();
    if (source === undefined) return;
    ++this.#opened;
    this.#sample = name;
    this.#open(source, kind);
  }

  /** Shows parts; the previous ones stay if the engine refuses them. */
  #open(source: MeshSource, kind: "surface" | "solid"): void {
    const { graze, stage, overlay } = this.#context;
    const model = new MeshModel(graze, source, kind);
    this.#slice.close();
    this.#model?.close();
    overlay.clear();
    stage.clearDrawing();
    this.#model = model;
    this.#faces.forget();
    this.#selected = Math.min(this.#selected, Math.max(0, model.parts.length - 1));
    const floor = floorOf(model.extent);
    stage.showDeep(floor);
    stage.fit(model.extent);
    new Grid(stage, floor);
    this.#drawings = model.parts.map((part) => new PartDrawing(stage, part));
    for (const drawing of this.#drawings) stage.world.add(drawing.object);
    model.parts.forEach((part, place) => {
      const drawing = this.#drawings[place];
      if (drawing !== undefined) showFaults(part, drawing, stage.palette);
    });
    stage.onView(() => this.#drawOver());
    this.#content.querySelector("#mesh-error")?.remove();
    this.#figures.set("source", "File", source.name);
    this.#figures.set("parts", "Parts", countText(model.parts.length));
    this.#figures.set("faces", "Faces", countText(model.faces));
    this.#showSelection();
  }

  /** Opens the same parts again, of another kind or turned. */
  #reopen(source: MeshSource, kind: "surface" | "solid"): void {
    this.#open(source, kind);
    this.#showMode();
  }

  #restorePose(parameters: URLSearchParams): void {
    if (!poseNames.some((name) => parameters.has(name))) return;
    const numbers = poseNames.map((name) => numberOf(parameters, name, { least: -1e9, most: 1e9, usual: usualPose(name) }));
    if (numbers.slice(3).every((value) => value === 0)) return;
    this.#model?.parts[this.#selected]?.put(numbers.slice(0, 3), numbers.slice(3));
    this.#drawings[this.#selected]?.place();
  }

  #refuse(message: string): void {
    const text = element("p", { class: "message", role: "alert", id: "mesh-error" }, message);
    this.#content.querySelector("#mesh-error")?.remove();
    this.#content.prepend(text);
    this.#context.say("The file was not opened");
  }

  #under(event: PointerEvent): PartHit | undefined {
    const { origin, direction } = this.#context.stage.sightLine(event);
    return this.#model?.hit(this.#context.graze, { origin: origin.toArray(), direction: direction.toArray() });
  }

  #hover(hit: PartHit | undefined): void {
    this.#context.stage.canvas.style.cursor = hit === undefined ? "" : this.#mode === "contacts" ? "grab" : "crosshair";
    if (this.#mode === "faces" && hit !== undefined) this.#pick(hit);
  }

  #press(hit: PartHit | undefined): void {
    if (hit === undefined) return;
    if (hit.place !== this.#selected) this.#select(hit.place);
    if (this.#mode === "faces") this.#pick(hit);
  }

  #pick(hit: PartHit): void {
    if (this.#model === undefined) return;
    this.#faces.pick(hit, this.#model);
    this.#paint();
    this.#drawOver();
    this.#context.changed();
  }

  #select(place: number): void {
    this.#selected = place;
    this.#grasp = new Grasp();
    this.#showSelection();
    this.#showMode();
  }

  #held(): Held | undefined {
    const part = this.#model?.parts[this.#selected];
    if (part === undefined) return undefined;
    const changed = (change: () => void): void => {
      change();
      this.#movedSoon();
    };
    return {
      name: part.name, middle: part.middle,
      move: (offset) => changed(() => part.move(offset)),
      turn: (degrees, axis) => changed(() => part.turn(degrees, axis)),
    };
  }

  /** Once for each picture, however often the pointer moves. */
  #movedSoon(): void {
    this.#drawings[this.#selected]?.place();
    this.#drawOver();
    this.#context.stage.invalidate();
    if (this.#isQueued) return;
    this.#isQueued = true;
    requestAnimationFrame(() => {
      this.#isQueued = false;
      this.#showMoved(true);
    });
  }

  #showMoved(isMoving: boolean): void {
    window.clearTimeout(this.#rest);
    if (this.#model === undefined || this.#mode !== "contacts") return;
    const isAll = this.#contacts.show(this.#model, this.#selected, isMoving);
    if (!isAll) this.#rest = window.setTimeout(() => this.#showMoved(false), restAfter);
    this.#paint();
    this.#drawOver();
    this.#context.changed();
  }

  #backToStart(): void {
    for (const part of this.#model?.parts ?? []) part.put([0, 0, 0], [0, 0, 0, 1]);
    for (const drawing of this.#drawings) drawing.place();
    this.#showMode();
  }

  /** Shows what the mode asks about. */
  #showMode(): void {
    const { stage } = this.#context;
    const model = this.#model;
    if (model === undefined) return;
    this.#slice.close();
    const views = { faces: this.#faces, contacts: this.#contacts, inside: this.#slice };
    this.#modeControls.replaceChildren(views[this.#mode].root);
    if (this.#mode === "faces") this.#faces.tell(model);
    if (this.#mode === "contacts") this.#contacts.show(model, this.#selected);
    if (this.#mode === "inside") this.#slice.open(model);
    stage.canvas.style.cursor = "";
    this.#paint();
    this.#drawOver();
    this.#context.changed();
  }

  #paint(): void {
    const { stage } = this.#context;
    this.#drawings.forEach((drawing, place) => {
      if (this.#mode === "contacts") {
        const faces = this.#contacts.facesOf(place, this.#selected);
        drawing.paint(Paint.free, faces, paintOfRelation[this.#contacts.relationOf(place, this.#selected)]);
      } else {
        drawing.paint(Paint.free, this.#mode === "faces" && this.#faces.hit?.place === place ? [this.#faces.hit.face] : [], Paint.found);
      }
    });
    stage.invalidate();
  }

  #paintCrossings(faces: readonly number[]): void {
    this.#drawings[this.#selected]?.paint(Paint.free, faces, Paint.overlapping);
    this.#context.stage.invalidate();
  }

  #drawOver(): void {
    const { overlay, stage } = this.#context;
    if (this.#model === undefined) return;
    const marks = { faces: () => this.#faces.marks(), contacts: () => this.#contacts.marks(), inside: () => this.#slice.marks() };
    overlay.draw(marks[this.#mode]());
    let handles: SpaceHandle[] = [];
    const held = this.#held();
    if (this.#mode === "contacts" && held !== undefined) handles = handlesOf(stage, held, this.#grasp);
    if (this.#mode === "inside") handles = this.#slice.handles();
    overlay.setHandles(handles);
  }

  #sliceChanged(): void {
    this.#drawOver();
    this.#context.changed();
  }

  #showSelection(): void {
    const model = this.#model;
    const part = model?.parts[this.#selected];
    if (model === undefined || part === undefined) return;
    this.#report.show(part);
    const rows = model.parts.map(({ name, data }, place) => {
      const tag = element("span", { class: "tag" }, counted(data.faces.length / 3, "face"));
      const attributes = { type: "button", "aria-current": String(place === this.#selected), onclick: () => this.#select(place) };
      return element("li", {}, element("button", attributes, element("span", {}, name), tag));
    });
    this.#partList.replaceChildren(...rows);
    const modes = choice<Mode>("Question", [["faces", "Faces"], ["contacts", "Contacts"], ["inside", "Inside"]], this.#mode, (mode) => {
      this.#mode = mode;
      this.#showMode();
    });
    modes.id = "mesh-modes";
    this.#content.replaceChildren(
      this.#figures.root,
      modes,
      this.#modeControls,
      section("Parts", this.#partList),
      section(`Report: ${part.name}`, this.#report.root),
      section(
        "Model",
        toggle("Solid: what is enclosed counts", model.kind === "solid", (on) => this.#reopen(model.source, on ? "solid" : "surface")),
        row(
          button("Turn y up", () => this.#reopen({ ...model.source, parts: model.source.parts.map(turnedUp) }, model.kind)),
          button("Back to the start", () => this.#backToStart()),
        ),
      ),
    );
  }

  #fillPanel(): void {
    const chooser = element("input", { type: "file", multiple: true, hidden: true, id: "mesh-file", accept: ".stl,.obj,.ply,.gltf,.glb,.bin" });
    chooser.addEventListener("change", () => this.onFiles([...(chooser.files ?? [])]));
    const buttons = Object.keys(samples).map((name) =>
      button(`Example: ${name}`, () => {
        this.#selected = 0;
        this.#mode = usualModes[name] ?? "faces";
        this.#openSample(name, "solid");
        this.#showMode();
      }),
    );
    this.#context.panel.append(
      title("Meshes"),
      element("p", { class: "lead" }, "Drop files of triangles on the page: STL, OBJ, PLY, glTF or GLB, several at once. Corners with equal coordinates are joined. Nothing leaves this machine."),
      row(button("Open files…", () => chooser.click()), ...buttons),
      chooser,
      this.#content,
    );
  }
}

/** Wider than the parts, so that they stand on it and cast shadows. */
function floorOf({ min, max }: Extent): Extent {
  const spare = 0.15 * Math.max(...max.map((high, axis) => high - (min[axis] ?? 0)), 1e-9);
  const grown = (value: number, axis: number, sign: number): number => (axis === 2 ? value : value + sign * spare);
  return { min: min.map((value, axis) => grown(value, axis, -1)), max: max.map((value, axis) => grown(value, axis, 1)) };
}

export const meshes: Chapter = {
  id: "meshes",
  title: "Meshes",
  open: (context) => new Meshes(context),
};
