// SPDX-License-Identifier: MIT
// A scene from a file and its pairs: the model behind the lists, the inspector and the drawing.
import type { CheckReport, Graze, Omission, Relation, Scene, SceneFiles, Shape } from "graze";

import { Paint, paintOf, paintOfRelation } from "../drawing/paint";
import { openRecording, timelineOf, type Timeline } from "./timeline";

export interface SceneSource {
  readonly name: string;
  readonly content: string | Uint8Array;
  readonly files?: SceneFiles;
  /** The result of `graze check`, if it is already known. */
  readonly check?: CheckReport;
}

export interface ListedObject {
  readonly name: string;
  readonly type: string;
  readonly layer: string;
}

export interface ListedPair {
  readonly a: number;
  readonly b: number;
  readonly relation: Relation;
}

/** The touching pairs, and how they were found. */
interface Found {
  readonly pairs: readonly ListedPair[];
  readonly candidates: number;
  readonly seconds: number;
}

export class SceneModel {
  readonly scene: Scene;
  readonly name: string;
  readonly objects: readonly ListedObject[];
  readonly ids: Float64Array;
  readonly layers: readonly string[];
  readonly hiddenLayers = new Set<string>();
  /** What the file contains that graze did not read; in a report page, the omissions listed in its check. */
  readonly omissions: readonly Omission[];
  /** The motion of the objects, if they move. */
  readonly timeline: Timeline | undefined;
  /** For each object the relation of its closest pair. */
  readonly #relations: Relation[];
  readonly #placesById: Map<number, number>;
  #found: Found;

  /** Throws with the engine's message if the file is not a scene. */
  constructor(graze: Graze, source: SceneSource) {
    const { scene, timeline } = opened(graze, source);
    this.scene = scene;
    this.timeline = timeline;
    this.omissions = source.check?.not_read ?? scene.omissions;
    this.name = source.name;
    this.ids = this.scene.ids();
    this.#placesById = new Map(Array.from(this.ids, (id, place) => [id, place]));
    this.objects = listed(this.scene.toJson());
    this.layers = [...new Set(this.objects.map((object) => object.layer))];
    this.#relations = new Array<Relation>(this.objects.length).fill("apart");
    this.#found = source.check === undefined ? this.#checked() : this.#reported(source.check);
    this.#mark();
  }

  get dimension(): 2 | 3 {
    return this.scene.dimension;
  }

  get pairs(): readonly ListedPair[] {
    return this.#found.pairs;
  }

  get candidates(): number {
    return this.#found.candidates;
  }

  /** The time for finding the pairs. */
  get seconds(): number {
    return this.#found.seconds;
  }

  /** Moves the objects to their positions in a frame and finds the touching pairs. */
  showFrame(frame: number): void {
    this.timeline?.show(frame);
    this.#found = this.#checked();
    this.#mark();
  }

  shape(place: number): Shape {
    return this.scene.object(this.id(place)).shape;
  }

  id(place: number): number {
    return this.ids[place] ?? -1;
  }

  placeOf(id: number): number | undefined {
    return this.#placesById.get(id);
  }

  placeNamed(name: string): number | undefined {
    const id = this.scene.find(name);
    return id === null ? undefined : this.placeOf(id);
  }

  /** The relation of its closest pair; "apart" if it is in none. */
  relationOf(place: number): Relation {
    return this.#relations[place] ?? "apart";
  }

  isHidden(place: number): boolean {
    return this.hiddenLayers.has(this.objects[place]?.layer ?? "");
  }

  pairsOf(place: number): ListedPair[] {
    return this.pairs.filter(({ a, b }) => a === place || b === place);
  }

  /** One for each object. */
  paints(selected: ReadonlySet<number>): Uint8Array {
    return Uint8Array.from(this.objects, ({ type }, place) => {
      if (this.isHidden(place)) return Paint.hidden;
      if (selected.has(place)) return Paint.found;
      return paintOf(type, paintOfRelation[this.relationOf(place)]);
    });
  }

  /** The layers for queries: only the visible ones. Undefined for a scene without named layers. */
  seenLayers(): { layers?: number[] } {
    if (this.hiddenLayers.size === 0) return {};
    return { layers: [...this.scene.layerNames.keys()].filter((layer) => !this.hiddenLayers.has(this.scene.layerNames[layer] ?? "")) };
  }

  close(): void {
    this.timeline?.close();
    this.scene.delete();
  }

  /** Replaces an object's shape and finds the touching pairs. */
  replace(place: number, shape: Shape): void {
    this.scene.move(this.id(place), shape);
    this.#found = this.#checked();
    this.#mark();
  }

  #mark(): void {
    this.#relations.fill("apart");
    for (const { a, b, relation } of this.pairs) {
      for (const place of [a, b]) if (this.#relations[place] !== "overlapping") this.#relations[place] = relation;
    }
  }

  #checked(): Found {
    const { ids, relations, candidates, seconds } = this.scene.checkPairs();
    const pairs = Array.from(relations, (relation, i): ListedPair => {
      const place = (index: number): number => this.placeOf(ids[index] ?? -1) ?? 0;
      return { a: place(2 * i), b: place(2 * i + 1), relation: relation === 2 ? "overlapping" : "touching" };
    });
    return { pairs, candidates, seconds };
  }

  #reported(check: CheckReport): Found {
    const places = new Map(this.objects.map((object, place) => [object.name, place]));
    const pairs = check.pairs.map(({ a, b, relation }) => ({ a: places.get(a) ?? 0, b: places.get(b) ?? 0, relation }));
    return { pairs, candidates: check.summary.candidates, seconds: check.summary.seconds };
  }
}

/** A scene, or a recording, which is recognised by its name because its content has no signature. */
function opened(graze: Graze, { name, content, files }: SceneSource): { scene: Scene; timeline: Timeline | undefined } {
  if (/\.aabbs$/i.test(name) && typeof content !== "string") return openRecording(graze, content, name);
  const scene = graze.readScene(content, name, files ?? {});
  return { scene, timeline: timelineOf(scene) };
}

/** All names, types and layers at once: querying each object separately takes seconds for a large scene. */
function listed(json: string): ListedObject[] {
  const document = JSON.parse(json) as { objects: { name?: string; type: string; layer?: string }[] };
  return document.objects.map((object, place) => ({
    name: object.name ?? `#${place}`,
    type: object.type,
    layer: object.layer ?? "default",
  }));
}
