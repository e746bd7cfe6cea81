// SPDX-License-Identifier: MIT
// The shapes of a chapter: an editor for 2D and one for 3D, and the switch between them.
import type { Shape } from "graze";

import type { ChapterContext } from "./chapter";
import { element } from "./dom";
import { Grid } from "./drawing/grid";
import { Editor } from "./editor";
import type { AnyHandle } from "./overlay";
import { button, dimensionChoice } from "./panel";
import type { ShapeType } from "./shapes/flat_shape";
import { kitOf, type ShapeKit } from "./shapes/shape_kit";
import { shapesOfText, textOfShapes } from "./shapes/text";
import type { Extent } from "./stage";
import { numberOf, wordOf } from "./state";

export type Dimension = 2 | 3;

export interface BoardOptions {
  /** The default shapes, if a link does not give others. */
  readonly usual: Readonly<Record<Dimension, string>>;
  readonly extent: Readonly<Record<Dimension, Extent>>;
  readonly addable: readonly ShapeType[];
  /** Called after every change of a shape or of the selection, and when a 2D view has moved. */
  readonly onChange: () => void;
  /** Called after the stage was cleared and set up again, so that the chapter can add its own drawings. */
  readonly onOpen?: (kit: ShapeKit) => void;
  /** Handles that belong to the chapter instead of a shape. */
  readonly ownHandles?: () => readonly AnyHandle[];
}

export class Board {
  readonly #context: ChapterContext;
  readonly #options: BoardOptions;
  /** The state of a dimension when it was last left. */
  readonly #kept: Partial<Record<Dimension, string>> = {};
  readonly #addRow = element("div", { class: "row" });
  #kit: ShapeKit;
  #editor: Editor;

  constructor(context: ChapterContext, options: BoardOptions) {
    this.#context = context;
    this.#options = options;
    const { parameters } = context;
    const dimension = dimensionOf(parameters);
    this.#kit = kitOf(context.graze, dimension);
    const selected = numberOf(parameters, "selected", { least: -1, most: 1e9, usual: -1 });
    this.#editor = this.#open(parameters.get("shapes") ?? "", selected);
  }

  get dimension(): Dimension {
    return this.#kit.dimension;
  }

  get names(): ShapeKit["names"] {
    return this.#kit.names;
  }

  get editor(): Editor {
    return this.#editor;
  }

  get shapes(): readonly Shape[] {
    return this.#editor.shapes;
  }

  /** The parameters of a link; 2D is the default. */
  describe(parameters: URLSearchParams): void {
    if (this.dimension === 3) parameters.set("dimension", "3");
    parameters.set("shapes", textOfShapes(this.shapes));
    if (this.#editor.selected !== undefined) parameters.set("selected", String(this.#editor.selected));
  }

  /** Whether the shapes are the default ones, so that a link need not contain them. */
  get isUsual(): boolean {
    const { dimension } = this.#kit;
    const usual = shapesOfText(this.#options.usual[dimension], dimension) ?? [];
    const kept = dimension === 2 ? usual : usual.map((shape) => this.#context.graze.normalised(shape));
    return textOfShapes(this.shapes) === textOfShapes(kept);
  }

  /** A control to choose between 2D and 3D. */
  dimensionSwitch(): HTMLElement {
    return dimensionChoice([2, 3], this.dimension, (dimension) => this.#show(dimension));
  }

  /** Buttons that add shapes. */
  get addRow(): HTMLElement {
    return this.#addRow;
  }

  close(): void {
    this.#editor.close();
  }

  #show(dimension: Dimension): void {
    if (dimension === this.dimension) return;
    this.#kept[this.dimension] = textOfShapes(this.shapes);
    this.#editor.close();
    this.#kit = kitOf(this.#context.graze, dimension);
    this.#editor = this.#open(this.#kept[dimension] ?? "", -1);
    this.#options.onChange();
  }

  #open(text: string, selected: number): Editor {
    const { stage, overlay } = this.#context;
    const { usual, extent, addable, onOpen, onChange, ownHandles } = this.#options;
    const { dimension } = this.#kit;
    overlay.clear();
    stage.clearDrawing();
    if (dimension === 2) stage.showFlat(extent[2]);
    else stage.showDeep(extent[3]);
    new Grid(stage, dimension === 2 ? undefined : extent[3]);
    this.#addRow.replaceChildren(...addable.map((type) => button(this.#kit.names[type], () => this.#editor.add(type))));
    const shapes = shapesOfText(text, dimension) ?? shapesOfText(usual[dimension], dimension) ?? [];
    const own = ownHandles ?? ((): readonly AnyHandle[] => []);
    const editor = new Editor(this.#context, { kit: this.#kit, shapes, selected, onChange, ownHandles: own });
    onOpen?.(this.#kit);
    return editor;
  }
}

/** The content of a link. */
export function dimensionOf(parameters: URLSearchParams): Dimension {
  return wordOf(parameters, "dimension", ["2", "3"]) === "3" ? 3 : 2;
}
