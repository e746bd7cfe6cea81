// SPDX-License-Identifier: MIT
// The address bar contains the state of the view: #chapter?name=value&... . Opening such a link restores it.
import { rounded } from "./numbers";

export interface Place {
  readonly chapter: string;
  readonly parameters: URLSearchParams;
}

/** The content of the address; the chapter is "" if none is given. */
export function readPlace(hash: string): Place {
  const text = hash.replace(/^#/, "");
  const question = text.indexOf("?");
  if (question < 0) return { chapter: text, parameters: new URLSearchParams() };
  return { chapter: text.slice(0, question), parameters: new URLSearchParams(text.slice(question + 1)) };
}

/** The address of a state; characters that keep numbers readable are not escaped. */
export function hashOf(place: Place): string {
  const query = place.parameters
    .toString()
    .replace(/%2C/g, ",")
    .replace(/%3B/g, ";")
    .replace(/%3A/g, ":");
  return query === "" ? `#${place.chapter}` : `#${place.chapter}?${query}`;
}

/** Writes the state to the address at most a few times a second, because browsers refuse more. */
export class AddressBar {
  #pending: number | undefined;
  #written = "";

  /** True while the address is one that this class wrote. */
  isOwn(hash: string): boolean {
    return hash === this.#written;
  }

  write(place: () => Place): void {
    if (this.#pending !== undefined) return;
    const before = location.hash;
    this.#pending = window.setTimeout(() => {
      this.#pending = undefined;
      if (location.hash !== before) return; // the reader has navigated, and the page is about to be notified
      this.#written = hashOf(place());
      history.replaceState(null, "", this.#written);
    }, 250);
  }

  /** Discards a pending write, because the reader has navigated. */
  forget(): void {
    window.clearTimeout(this.#pending);
    this.#pending = undefined;
  }
}

/** A finite number from a link, clamped to limits; the fallback if there is none. */
export function numberOf(parameters: URLSearchParams, name: string, limits: NumberLimits): number {
  const text = parameters.get(name);
  const value = text === null || text.trim() === "" ? Number.NaN : Number(text);
  if (!Number.isFinite(value)) return limits.usual;
  return Math.min(limits.most, Math.max(limits.least, value));
}

const axes = ["x", "y", "z"] as const;

/** A point with as many coordinates as the default: x, y and z, each after a prefix, from a link. */
export function pointOf(parameters: URLSearchParams, prefix: string, usual: readonly number[]): readonly number[] {
  return usual.map((value, axis) => numberOf(parameters, `${prefix}${axes[axis] ?? ""}`, { least: -1e6, most: 1e6, usual: value }));
}

export function writePoint(parameters: URLSearchParams, prefix: string, point: readonly number[]): void {
  point.forEach((value, axis) => parameters.set(`${prefix}${axes[axis] ?? ""}`, String(rounded(value))));
}

export interface NumberLimits {
  readonly least: number;
  readonly most: number;
  readonly usual: number;
}

/** One of the known words from a link; the first of them for anything else. */
export function wordOf<Word extends string>(
  parameters: URLSearchParams,
  name: string,
  words: readonly [Word, ...Word[]],
): Word {
  const text = parameters.get(name);
  return words.find((word) => word === text) ?? words[0];
}
