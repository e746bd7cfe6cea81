// SPDX-License-Identifier: MIT
// The numbers of one object, and the objects that it touches.
import type { Graze, Shape } from "graze";

import { element } from "../dom";
import { measure, vector } from "../numbers";
import { button, Figures, row } from "../panel";
import type { SceneModel } from "./scene_model";

/** Contacts are calculated for this many partners; nobody would read more. */
const mostContacts = 50;

export interface InspectorActions {
  readonly select: (place: number) => void;
  readonly zoomTo: (place: number) => void;
}

export function inspect(graze: Graze, model: SceneModel, place: number, actions: InspectorActions): HTMLElement {
  const object = model.scene.object(model.id(place));
  const listed = model.objects[place];
  const figures = new Figures();
  figures.set("type", "type", listed?.type.replace("_", "-") ?? "");
  figures.set("layer", "layer", listed?.layer ?? "");
  for (const [name, value] of numbersOf(object.shape)) figures.set(name.replace(" ", "-"), name.replace("_", " "), value);
  if (object.user !== 0n) figures.set("user", "user", String(object.user));
  const pairs = model.pairsOf(place);
  const partners = pairs.slice(0, mostContacts).map(({ a, b, relation }) => {
    const other = a === place ? b : a;
    const contact = graze.contact(object.shape, model.shape(other));
    const depth = contact === null ? relation : `${relation} ${measure(contact.depth)}`;
    return element(
      "li",
      {},
      element(
        "button",
        { type: "button", class: relation, onclick: () => actions.select(other) },
        element("span", {}, model.objects[other]?.name ?? ""),
        element("span", { class: "tag" }, depth),
      ),
    );
  });
  return element(
    "div",
    { id: "inspector" },
    element("p", {}, element("strong", {}, listed?.name ?? "")),
    figures.root,
    row(button("Zoom to object", () => actions.zoomTo(place), "Z")),
    element("p", { class: "lead" }, pairs.length === 0 ? "It touches nothing." : `It touches ${pairs.length}:`),
    ...(partners.length > 0 ? [element("ul", { class: "list", "aria-label": "What it touches" }, ...partners)] : []),
  );
}

/** The fields of a shape, formatted for display. */
export function numbersOf(shape: Shape): [string, string][] {
  if (shape.type === "compound") return [["parts", String(shape.parts.length)]];
  if (shape.type === "polytope") return [["corners", String(shape.points.length)]];
  return Object.entries(shape as object).flatMap(([name, value]: [string, unknown]): [string, string][] => {
    if (typeof value === "number") return [[name, measure(value)]];
    if (isVector(value)) return [[name, vector(value)]];
    if (Array.isArray(value)) return value.filter(isVector).map((axis, index) => [`${name} ${index + 1}`, vector(axis)]);
    return [];
  });
}

function isVector(value: unknown): value is number[] {
  return Array.isArray(value) && typeof value[0] === "number";
}
