// SPDX-License-Identifier: MIT
// The parts of a file or a sample, in the engine.
import type { Graze, MeshHit } from "graze";

import type { Extent } from "../stage";
import { extentOf, type MeshSource } from "./mesh_data";
import { MeshPart } from "./mesh_part";

export interface PartHit extends MeshHit {
  /** The part that is hit. */
  readonly place: number;
  readonly face: number;
}

export class MeshModel {
  readonly source: MeshSource;
  readonly kind: "surface" | "solid";
  readonly parts: readonly MeshPart[];
  /** Before any part was moved. */
  readonly extent: Extent;

  /** Throws if the engine refuses a part. */
  constructor(graze: Graze, source: MeshSource, kind: "surface" | "solid") {
    this.source = source;
    this.kind = kind;
    const parts: MeshPart[] = [];
    try {
      for (const data of source.parts) parts.push(new MeshPart(graze, data, kind));
    } catch (error) {
      for (const part of parts) part.close();
      throw error;
    }
    this.parts = parts;
    this.extent = extentOf(source.parts);
  }

  get faces(): number {
    return this.parts.reduce((sum, { data }) => sum + data.faces.length / 3, 0);
  }

  /** The first face on a ray. */
  hit(graze: Graze, ray: { readonly origin: readonly number[]; readonly direction: readonly number[] }): PartHit | undefined {
    let best: PartHit | undefined;
    this.parts.forEach(({ surface }, place) => {
      const found = graze.rayCast(surface, ray);
      if (found === null || found.face === null || (best !== undefined && found.t >= best.t)) return;
      best = { ...found, face: found.face, place };
    });
    return best;
  }

  close(): void {
    for (const part of this.parts) part.close();
  }
}
