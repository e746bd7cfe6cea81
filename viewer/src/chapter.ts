// SPDX-License-Identifier: MIT
// A chapter is one tab: its drawing on the stage and its panel.
import type { Graze } from "graze";
import type { Overlay } from "./overlay";
import type { Stage } from "./stage";

export interface ChapterContext {
  readonly graze: Graze;
  readonly stage: Stage;
  readonly overlay: Overlay;
  readonly panel: HTMLElement;
  /** The parameters of the link. */
  readonly parameters: URLSearchParams;
  /** A line below the drawing. */
  readonly say: (caption: string) => void;
  /** Must be called when the result of `OpenChapter.parameters` has changed. */
  readonly changed: () => void;
}

export interface OpenChapter {
  /** The parameters that a link needs to show the same state again. */
  parameters(): URLSearchParams;
  /** Keys that no control has handled; returns true if the key was used. */
  onKey?(event: KeyboardEvent): boolean;
  /** A file that was dropped on the page or chosen. */
  onFiles?(files: readonly File[]): void;
  /** Frees what the engine holds. */
  close(): void;
}

export interface Chapter {
  readonly id: string;
  readonly title: string;
  open(context: ChapterContext): OpenChapter;
}
