// SPDX-License-Identifier: MIT
// A chapter is one tab: what it shows on the stage, and what stands in the panel.
import type { Graze } from "graze";
import type { Overlay } from "./overlay";
import type { Stage } from "./stage";

export interface ChapterContext {
  readonly graze: Graze;
  readonly stage: Stage;
  readonly overlay: Overlay;
  readonly panel: HTMLElement;
  /** What the link says. */
  readonly parameters: URLSearchParams;
  /** A line below the drawing. */
  readonly say: (caption: string) => void;
  /** To be called when what `OpenChapter.parameters` gives has changed. */
  readonly changed: () => void;
}

export interface OpenChapter {
  /** What a link has to hold to show the same again. */
  parameters(): URLSearchParams;
  /** Keys that no control took; true if it was of use. */
  onKey?(event: KeyboardEvent): boolean;
  /** A file that was dropped on the page or chosen. */
  onFiles?(files: readonly File[]): void;
  /** Gives back what the engine holds. */
  close(): void;
}

export interface Chapter {
  readonly id: string;
  readonly title: string;
  open(context: ChapterContext): OpenChapter;
}
