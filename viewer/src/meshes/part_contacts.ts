// SPDX-License-Identifier: MIT
// What a part touches: which of its faces and of the others', where and how deep; or what it is nearest to.
import type { BuiltMesh, Graze, Manifold, Proximity, Relation } from "graze";

import type { MeshModel } from "./mesh_model";

export interface PartTouch {
  /** The other part. */
  readonly place: number;
  readonly relation: Relation;
  /** Undefined in a quick answer. */
  readonly manifold: Manifold | undefined;
  /** Of the part and of the other one. */
  readonly faces: ReadonlySet<number>;
  readonly otherFaces: ReadonlySet<number>;
  readonly pairs: number;
}

export interface PartContacts {
  readonly touches: readonly PartTouch[];
  /** If nothing is touched: the nearest other part. */
  readonly nearest: { readonly place: number; readonly proximity: Proximity } | undefined;
  /** Whether only faces that touch were searched for. */
  readonly isQuick: boolean;
  /** The time in the engine, in milliseconds. */
  readonly spent: number;
}

/** The faces of one part that touch those of all others: a quick answer, for parts that are being moved. Where faces
 * touch, the parts count as overlapping, and one inside the other as apart. */
export function touchingFacesOf(model: MeshModel, place: number): PartContacts {
  const start = performance.now();
  const touches = othersOf(model, place).flatMap((other): PartTouch[] => {
    const pairs = model.parts[place]?.mesh.touchingFaces(other.mesh) ?? new Uint32Array(0);
    return pairs.length === 0 ? [] : [{ place: other.place, relation: "overlapping", manifold: undefined, ...facesOf(pairs) }];
  });
  return { touches, nearest: undefined, isQuick: true, spent: performance.now() - start };
}

/** All about one part and all others. */
export function contactsOf(graze: Graze, model: MeshModel, place: number): PartContacts {
  const start = performance.now();
  const part = model.parts[place];
  const touches: PartTouch[] = [];
  let nearest: PartContacts["nearest"];
  if (part === undefined) return { touches, nearest, isQuick: false, spent: 0 };
  const others = othersOf(model, place);
  for (const other of others) {
    const relation = graze.relation(part.mesh, other.mesh);
    if (relation === "apart") continue;
    touches.push({ place: other.place, relation, manifold: graze.manifold(part.mesh, other.mesh), ...facesOf(part.mesh.touchingFaces(other.mesh)) });
  }
  if (touches.length === 0) {
    for (const other of others) {
      const proximity = graze.closestPoints(part.mesh, other.mesh);
      if (nearest === undefined || proximity.distance < nearest.proximity.distance) nearest = { place: other.place, proximity };
    }
  }
  return { touches, nearest, isQuick: false, spent: performance.now() - start };
}

function othersOf({ parts }: MeshModel, place: number): { readonly place: number; readonly mesh: BuiltMesh }[] {
  return parts.map(({ mesh }, at) => ({ place: at, mesh })).filter((other) => other.place !== place);
}

function facesOf(pairs: Uint32Array): Pick<PartTouch, "faces" | "otherFaces" | "pairs"> {
  return { faces: new Set(pairs.filter((_, i) => i % 2 === 0)), otherFaces: new Set(pairs.filter((_, i) => i % 2 === 1)), pairs: pairs.length / 2 };
}

/** The greatest depth of any contact point; undefined without contact points. */
export function deepest(touches: readonly PartTouch[]): number | undefined {
  const depths = touches.flatMap(({ manifold }) => (manifold?.points ?? []).map(({ depth }) => depth));
  return depths.length === 0 ? undefined : Math.max(...depths);
}
