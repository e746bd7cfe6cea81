// SPDX-License-Identifier: MIT
// What the selected part touches: faces, contact points and normals; or the way to the nearest other part.
import type { Relation } from "graze";

import type { ChapterContext } from "../chapter";
import { element } from "../dom";
import { count as countText, counted, duration, measure } from "../numbers";
import type { Mark } from "../overlay";
import { Figures } from "../panel";
import { between, plus, times } from "../vectors";
import type { MeshModel } from "./mesh_model";
import { contactsOf, deepest, touchingFacesOf, type PartContacts } from "./part_contacts";

/** A part that is being moved gets all answers in every picture if they take no longer than this, in milliseconds. */
const mostWhileMoving = 25;

export class ContactView {
  readonly root = element("div");
  readonly #context: ChapterContext;
  readonly #figures = new Figures();
  #found: PartContacts | undefined;
  /** The time that all answers took last. */
  #cost = 0;

  constructor(context: ChapterContext) {
    this.#context = context;
    const text = "Drag a part, with Shift at its height, or its handles; turn it with [ ] and { }. Faces that touch are hatched.";
    this.root.append(element("p", { class: "lead" }, text), this.#figures.root);
  }

  /** Asks about the selected part and all others. While it is being moved, some answers may be missing; returns whether
   * all are there. */
  show(model: MeshModel, selected: number, isMoving = false): boolean {
    const found = isMoving && this.#cost > mostWhileMoving ? touchingFacesOf(model, selected) : contactsOf(this.#context.graze, model, selected);
    if (!found.isQuick) this.#cost = found.spent;
    this.#found = found;
    this.#tell(found, model, selected);
    return !found.isQuick;
  }

  #tell(found: PartContacts, model: MeshModel, selected: number): void {
    const name = model.parts[selected]?.name ?? "";
    const others = found.touches.map(({ place }) => model.parts[place]?.name ?? "");
    const { nearest, touches } = found;
    const near = nearest === undefined ? undefined : measure(nearest.proximity.distance);
    const unknown = found.isQuick ? "…" : "–";
    this.#figures.set("moved", "Selected part", name);
    this.#figures.set("touched", "Touches", others.length === 0 ? "nothing" : others.join(", "));
    this.#figures.set("pairs", "Pairs of faces that touch", countText(touches.reduce((sum, { pairs }) => sum + pairs, 0)));
    this.#figures.set("points", "Contact points", found.isQuick ? unknown : countText(touches.reduce((sum, { manifold }) => sum + (manifold?.points.length ?? 0), 0)));
    const depth = deepest(touches);
    this.#figures.set("depth", "Greatest depth", depth === undefined ? unknown : measure(depth));
    this.#figures.set("distance", "Distance", near ?? (touches.length > 0 ? "0" : unknown));
    this.#figures.set("contact-time", "Time of the answers", duration(found.spent));
    const also = near === undefined ? "" : `, ${near} from ${model.parts[nearest?.place ?? 0]?.name ?? ""}`;
    this.#context.say(others.length === 0 ? `${name} touches nothing${also}` : `${name} touches ${counted(others.length, "part")}: ${others.join(", ")}`);
  }

  /** The faces of a part that touch. */
  facesOf(place: number, selected: number): Iterable<number> {
    if (place === selected) return (this.#found?.touches ?? []).flatMap(({ faces }) => [...faces]);
    return this.#found?.touches.find((touch) => touch.place === place)?.otherFaces ?? [];
  }

  relationOf(place: number, selected: number): Relation {
    const own = (this.#found?.touches ?? []).filter((touch) => place === selected || touch.place === place);
    if (own.length === 0) return "apart";
    return own.some(({ relation }) => relation === "overlapping") ? "overlapping" : "touching";
  }

  marks(): Mark[] {
    const { stage } = this.#context;
    const points = (this.#found?.touches ?? []).flatMap(({ manifold, relation }) =>
      (manifold?.points ?? []).flatMap(({ point, depth }): Mark[] => {
        const tone = relation === "overlapping" ? "overlapping-line" : "touching-line";
        const tip = plus(point, times(manifold?.normal ?? [0, 0, 0], 40 * stage.lengthOfPixel(point)));
        return [
          { kind: "line", points: [point, tip], tone, arrow: true },
          { kind: "dot", at: point, tone },
          ...(depth > 0 ? [{ kind: "label", at: point, text: measure(depth), tone } as const] : []),
        ];
      }),
    );
    const near = this.#found?.nearest?.proximity;
    if (near === undefined) return points;
    return [
      ...points,
      { kind: "line", points: [near.pointA, near.pointB], tone: "answer", dashed: true },
      { kind: "dot", at: near.pointA, tone: "answer" },
      { kind: "dot", at: near.pointB, tone: "answer" },
      { kind: "label", at: between(near.pointA, near.pointB), text: measure(near.distance), tone: "answer" },
    ];
  }
}
