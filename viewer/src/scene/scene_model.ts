// SPDX-License-Identifier: MIT
// A scene from a file, with its pairs: what the lists, the inspector and the drawing have in common.
import type { CheckReport, Graze, Relation, Scene, SceneFiles, Shape } from "graze";

import { Paint, paintOf } from "../drawing/paint";

export interface SceneSource {
  readonly name: string;
  readonly content: string | Uint8Array;
  readonly files?: SceneFiles;
  /** What `graze check` found, where it is known already. */
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

export class SceneModel {
  readonly scene: Scene;
  readonly name: string;
  readonly objects: readonly ListedObject[];
  readonly ids: Float64Array;
  readonly pairs: readonly ListedPair[];
  readonly candidates: number;
  readonly seconds: number;
  readonly layers: readonly string[];
  readonly hiddenLayers = new Set<string>();
  readonly #touching: Uint8Array;
  readonly #placesById: Map<number, number>;

  /** Throws with the engine's message when the file is no scene. */
  constructor(graze: Graze, source: SceneSource) {
    this.scene = graze.readScene(source.content, source.name, source.files ?? {});
    this.name = source.name;
    this.ids = this.scene.ids();
    this.#placesById = new Map(Array.from(this.ids, (id, place) => [id, place]));
    this.objects = listed(this.scene.toJson());
    const found = source.check === undefined ? this.#checked() : this.#reported(source.check);
    this.pairs = found.pairs;
    this.candidates = found.candidates;
    this.seconds = found.seconds;
    this.layers = [...new Set(this.objects.map((object) => object.layer))];
    this.#touching = new Uint8Array(this.objects.length);
    for (const { a, b } of this.pairs) {
      this.#touching[a] = 1;
      this.#touching[b] = 1;
    }
  }

  get dimension(): 2 | 3 {
    return this.scene.dimension;
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

  isTouching(place: number): boolean {
    return this.#touching[place] === 1;
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
      return paintOf(type, this.isTouching(place) ? Paint.touching : Paint.free);
    });
  }

  /** For questions to the scene: only what is seen. A scene that names no layers has none to ask for. */
  seenLayers(): { layers?: number[] } {
    if (this.hiddenLayers.size === 0) return {};
    return { layers: [...this.scene.layerNames.keys()].filter((layer) => !this.hiddenLayers.has(this.scene.layerNames[layer] ?? "")) };
  }

  close(): void {
    this.scene.delete();
  }

  #checked(): { pairs: ListedPair[]; candidates: number; seconds: number } {
    const { ids, relations, candidates, seconds } = this.scene.checkPairs();
    const pairs = Array.from(relations, (relation, i): ListedPair => {
      const place = (index: number): number => this.placeOf(ids[index] ?? -1) ?? 0;
      return { a: place(2 * i), b: place(2 * i + 1), relation: relation === 2 ? "overlapping" : "touching" };
    });
    return { pairs, candidates, seconds };
  }

  #reported(check: CheckReport): { pairs: ListedPair[]; candidates: number; seconds: number } {
    const places = new Map(this.objects.map((object, place) => [object.name, place]));
    const pairs = check.pairs.map(({ a, b, relation }) => ({ a: places.get(a) ?? 0, b: places.get(b) ?? 0, relation }));
    return { pairs, candidates: check.summary.candidates, seconds: check.summary.seconds };
  }
}

/** All names, types and layers at once: asking for each object by itself takes seconds for a large scene. */
function listed(json: string): ListedObject[] {
  const document = JSON.parse(json) as { objects: { name?: string; type: string; layer?: string }[] };
  return document.objects.map((object, place) => ({
    name: object.name ?? `#${place}`,
    type: object.type,
    layer: object.layer ?? "default",
  }));
}
