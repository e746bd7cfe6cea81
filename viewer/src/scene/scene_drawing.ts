// SPDX-License-Identifier: MIT
// Draws a scene on the stage: axis-aligned boxes as a cloud, which is fast for very many, everything else as meshes.
import type { Drawing, Graze } from "graze";

import { BoxCloud } from "../drawing/box_cloud";
import { cornersFor, drawingsOf } from "../drawing/drawings";
import { Grid } from "../drawing/grid";
import { MeshDrawing } from "../drawing/mesh_drawing";
import { Paint } from "../drawing/paint";
import type { Extent, Stage } from "../stage";
import type { SceneModel } from "./scene_model";

export class SceneDrawing {
  /** A box around all bounded objects. */
  readonly extent: Extent;
  readonly #graze: Graze;
  readonly #stage: Stage;
  readonly #model: SceneModel;
  readonly #cloud: BoxCloud;
  readonly #meshes: MeshDrawing;
  readonly #selection: MeshDrawing;
  readonly #boxPlaces: number[] = [];
  readonly #meshPlaces: number[] = [];
  /** The ids of the boxes. */
  #boxIds = new Float64Array(0);

  constructor(graze: Graze, stage: Stage, model: SceneModel) {
    [this.#graze, this.#stage, this.#model] = [graze, stage, model];
    this.extent = extentOf(model);
    const { dimension } = model;
    if (dimension === 2) stage.showFlat(this.extent, model.scene.yAxis === "down");
    else stage.showDeep(this.extent);
    new Grid(stage, dimension === 2 ? undefined : this.extent);
    this.#cloud = new BoxCloud(dimension, stage.palette, { fill: dimension === 2 ? 0.55 : 1, edge: 1, width: 1.4 });
    const lineWidth = model.objects.length > 150 ? 1.2 : 2;
    this.#meshes = new MeshDrawing(dimension, stage.palette, { fill: dimension === 2 ? 0.55 : 1, lineWidth });
    this.#selection = new MeshDrawing(dimension, stage.palette, { fill: 0, lineWidth: 3, isSeenThrough: true });
    this.#selection.object.renderOrder = 2;
    stage.world.add(this.#meshes.object, this.#cloud.object, this.#selection.object);
    model.objects.forEach((object, place) => (object.type === "aabb" ? this.#boxPlaces : this.#meshPlaces).push(place));
    this.#boxIds = Float64Array.from(this.#boxPlaces, (place) => model.id(place));
    this.#fill();
    stage.onTheme(() => [this.#cloud, this.#meshes, this.#selection].forEach((part) => part.setPalette(stage.palette)));
  }

  /** Redraws objects at their current positions; boxes are always all updated. */
  move(places: ReadonlySet<number>): void {
    if (this.#boxPlaces.length > 0) {
      this.#cloud.boxes.set(this.#model.scene.boxes(this.#boxIds));
      this.#cloud.boxesChanged();
    }
    const moved = [...this.#meshPlaces.keys()].filter((index) => places.has(this.#meshPlaces[index] ?? -1));
    const drawings = new Map(moved.map((index) => [index, this.#drawingsOf(this.#meshPlaces[index] ?? 0, this.#corners)]));
    if (drawings.size > 0 && !this.#meshes.replace(drawings)) this.#fillMeshes();
    this.#stage.invalidate();
  }

  /** Recolours everything: selected, hidden, touching. */
  paint(selected: ReadonlySet<number>): void {
    const paints = this.#model.paints(selected);
    this.#cloud.paints.set(this.#boxPlaces.map((place) => paints[place] ?? 0));
    this.#cloud.paintsChanged();
    this.#meshes.setPaints(Uint8Array.from(this.#meshPlaces, (place) => paints[place] ?? 0));
    const outlined = [...selected].filter((place) => !this.#model.isHidden(place));
    this.#selection.set(outlined.map((place) => this.#drawingsOf(place, 48)), new Uint8Array(outlined.length).fill(Paint.found));
    this.#stage.invalidate();
  }

  /** A box around an object, clipped to the extent. */
  extentOf(place: number): Extent {
    const { min, max } = this.#model.scene.object(this.#model.id(place)).box;
    const clip = (values: readonly number[], usual: readonly number[]): number[] => {
      return values.map((value, axis) => (Number.isFinite(value) ? value : (usual[axis] ?? 0)));
    };
    return { min: clip(min, this.extent.min), max: clip(max, this.extent.max) };
  }

  get #corners(): number {
    return cornersFor(this.#meshPlaces.length, this.#model.dimension);
  }

  #fill(): void {
    this.#cloud.resize(this.#boxPlaces.length);
    if (this.#boxPlaces.length > 0) this.#cloud.boxes.set(this.#model.scene.boxes(this.#boxIds));
    this.#fillMeshes();
  }

  #fillMeshes(): void {
    const corners = this.#corners;
    const paints = this.#model.paints(new Set());
    const drawings = this.#meshPlaces.map((place) => this.#drawingsOf(place, corners));
    this.#meshes.set(drawings, Uint8Array.from(this.#meshPlaces, (place) => paints[place] ?? 0));
  }

  #drawingsOf(place: number, corners: number): Drawing[] {
    const within = { min: [...this.extent.min], max: [...this.extent.max] };
    return drawingsOf(this.#graze, this.#model.shape(place), this.#model.dimension, { within, corners });
  }
}

/** All bounded objects and a margin, so that planes and half-spaces extend beyond them. */
function extentOf(model: SceneModel): Extent {
  const bounds = model.scene.info().bounds;
  if (bounds === null) return { min: Array(model.dimension).fill(-10) as number[], max: Array(model.dimension).fill(10) as number[] };
  const size = Math.max(...bounds.max.map((high, axis) => high - (bounds.min[axis] ?? 0)));
  const margin = size > 0 ? size * 0.03 : 1;
  return { min: bounds.min.map((low) => low - margin), max: bounds.max.map((high) => high + margin) };
}
