// SPDX-License-Identifier: MIT
// What is unusual about a part: counts, and the edges and faces where it is.
import type { BuiltMesh, MeshReport } from "graze";

import { element } from "../dom";
import { count as countText, counted, duration } from "../numbers";
import { button, Figures, row } from "../panel";
import type { Palette } from "../theme";
import type { MeshPart } from "./mesh_part";
import type { EdgeTone, PartDrawing } from "./part_drawing";

const faults = [
  ["open", "overlapping-line", "openEdges", "Open edges"],
  ["non_manifold", "third", "nonManifoldEdges", "Edges of more than two faces"],
  ["flipped", "second", "flippedEdges", "Edges with flipped faces"],
] as const satisfies readonly (readonly [Parameters<BuiltMesh["edges"]>[0], EdgeTone, keyof MeshReport, string])[];

/** Shows the faulty edges of a part in its drawing. */
export function showFaults(part: MeshPart, drawing: PartDrawing, palette: Palette): void {
  for (const [fault, tone] of faults) drawing.showEdges(tone, part.mesh.edges(fault), palette);
}

export class ReportView {
  readonly root = element("div");
  /** Called with the faces that cross others. */
  readonly #onCrossings: (faces: readonly number[]) => void;

  constructor(onCrossings: (faces: readonly number[]) => void) {
    this.#onCrossings = onCrossings;
  }

  show(part: MeshPart): void {
    const { mesh } = part;
    const report = mesh.report();
    const figures = new Figures();
    figures.set("vertices", "Vertices, faces", `${countText(mesh.vertexCount)}, ${countText(mesh.faceCount)}`);
    figures.set("components", "Components", countText(report.components));
    figures.set("closed", "Closed", report.isClosed ? "yes" : "no");
    for (const [fault, , field, label] of faults) figures.set(fault, label, countText(report[field]));
    figures.set("degenerate", "Faces without area", countText(report.degenerateFaces));
    figures.set("duplicate", "Repeated faces", countText(report.duplicateFaces));
    const crossings = button("Find faces that cross others", () => {
      const start = performance.now();
      const pairs = mesh.selfIntersections();
      const spent = performance.now() - start;
      figures.set("crossings", "Faces that cross", `${counted(pairs.length / 2, "pair")} in ${duration(spent)}`);
      this.#onCrossings(Array.from(new Set(pairs)));
    });
    const legend = faults.filter(([, , field]) => report[field] > 0).map(([, tone, , label]) => {
      const swatch = element("span", { class: "swatch", style: `background: var(--${tone}); border-color: var(--${tone})`, "aria-hidden": "true" });
      return element("span", { class: "legend" }, swatch, ` ${label} `);
    });
    this.root.replaceChildren(figures.root, ...(legend.length === 0 ? [] : [element("p", { class: "lead", id: "legend" }, ...legend)]), row(crossings));
  }
}
