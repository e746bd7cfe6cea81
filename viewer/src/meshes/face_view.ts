// SPDX-License-Identifier: MIT
// The face under the pointer: its number, where on it, how far away and which way it looks.
import type { ChapterContext } from "../chapter";
import { element } from "../dom";
import { count as countText, duration, measure, vector } from "../numbers";
import type { Mark } from "../overlay";
import { Figures } from "../panel";
import { pointOf, writePoint } from "../state";
import { timeOf } from "../timing";
import { lengthOf, minus, plus, times } from "../vectors";
import type { MeshModel, PartHit } from "./mesh_model";

interface SightRay {
  readonly origin: readonly number[];
  readonly direction: readonly number[];
}

export class FaceView {
  readonly root = element("div");
  readonly #context: ChapterContext;
  readonly #figures = new Figures();
  #hit: PartHit | undefined;
  #corners: readonly (readonly number[])[] = [];
  #ray: SightRay | undefined;

  constructor(context: ChapterContext) {
    this.#context = context;
    this.root.append(element("p", { class: "lead" }, "Point at a face, or tap it."), this.#figures.root);
  }

  get hit(): PartHit | undefined {
    return this.#hit;
  }

  forget(): void {
    [this.#hit, this.#ray, this.#corners] = [undefined, undefined, []];
  }

  /** The face of a link. */
  restore(parameters: URLSearchParams, hitOf: (ray: SightRay) => PartHit | undefined): void {
    if (!parameters.has("x")) return;
    const origin = pointOf(parameters, "", [0, 0, 0]);
    const direction = minus(pointOf(parameters, "to-", [0, 0, 0]), origin);
    if (lengthOf(direction) === 0) return;
    this.#hit = hitOf({ origin, direction });
    this.#ray = { origin, direction };
  }

  describe(parameters: URLSearchParams): void {
    if (this.#hit === undefined || this.#ray === undefined) return;
    writePoint(parameters, "", this.#ray.origin);
    writePoint(parameters, "to-", this.#hit.point);
  }

  pick(hit: PartHit, model: MeshModel): void {
    this.#hit = hit;
    const eye = this.#context.stage.eye;
    this.#ray = { origin: eye, direction: minus(hit.point, eye) };
    this.tell(model);
  }

  tell(model: MeshModel): void {
    const hit = this.#hit;
    const part = hit === undefined ? undefined : model.parts[hit.place];
    if (hit === undefined || part === undefined) {
      for (const [id, label] of figureNames) this.#figures.set(id, label, "–");
      this.#context.say("No face is picked");
      return;
    }
    this.#corners = cornersOf(part.data.faces, part.mesh.vertices(), hit.face);
    const ray = this.#ray;
    const far = ray === undefined ? 0 : lengthOf(minus(hit.point, ray.origin));
    const shown = {
      part: part.name,
      face: countText(hit.face),
      barycentric: vector(hit.barycentric),
      point: vector(hit.point),
      normal: vector(hit.normal),
      far: measure(far),
      "ray-time": ray === undefined ? "–" : duration(timeOf(() => model.hit(this.#context.graze, ray))),
    };
    for (const [id, label] of figureNames) this.#figures.set(id, label, shown[id]);
    this.#context.say(`Face ${countText(hit.face)} of ${part.name}, ${measure(far)} away`);
  }

  marks(): Mark[] {
    const { stage } = this.#context;
    const hit = this.#hit;
    const [first] = this.#corners;
    if (hit === undefined || first === undefined) return [];
    const tip = plus(hit.point, times(hit.normal, 46 * stage.lengthOfPixel(hit.point)));
    return [
      { kind: "line", points: [...this.#corners, first], tone: "answer" },
      { kind: "line", points: [hit.point, tip], tone: "second", arrow: true },
      { kind: "dot", at: hit.point, tone: "answer" },
      { kind: "label", at: hit.point, text: `face ${countText(hit.face)}`, tone: "answer", shift: [0, 24] },
    ];
  }
}

const figureNames = [
  ["part", "Part"], ["face", "Face"], ["barycentric", "Barycentric"], ["point", "Point"], ["normal", "Normal"],
  ["far", "Distance from the eye"], ["ray-time", "Time of the ray"],
] as const;

function cornersOf(faces: Uint32Array, vertices: Float64Array, face: number): number[][] {
  return [0, 1, 2].map((corner) => {
    const first = 3 * (faces[3 * face + corner] ?? 0);
    return Array.from(vertices.subarray(first, first + 3));
  });
}
