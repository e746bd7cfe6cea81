// SPDX-License-Identifier: MIT
// The address bar holds what is seen: #chapter?name=value&... . Opening such a link shows the same again.
import { rounded } from "./numbers";

export interface Place {
  readonly chapter: string;
  readonly parameters: URLSearchParams;
}

/** What the address says; the chapter is "" when it says nothing. */
export function readPlace(hash: string): Place {
  const text = hash.replace(/^#/, "");
  const question = text.indexOf("?");
  if (question < 0) return { chapter: text, parameters: new URLSearchParams() };
  return { chapter: text.slice(0, question), parameters: new URLSearchParams(text.slice(question + 1)) };
}

/** The address of a place, with the marks that keep numbers legible left as they are. */
export function hashOf(place: Place): string {
  const query = place.parameters
    .toString()
    .replace(/%2C/g, ",")
    .replace(/%3B/g, ";")
    .replace(/%3A/g, ":");
  return query === "" ? `#${place.chapter}` : `#${place.chapter}?${query}`;
}

/** Writes the address of what is seen, at most a few times a second: browsers refuse more. */
export class AddressBar {
  #pending: number | undefined;
  #written = "";

  /** True while the address is one that we wrote ourselves. */
  isOwn(hash: string): boolean {
    return hash === this.#written;
  }

  write(place: () => Place): void {
    if (this.#pending !== undefined) return;
    const before = location.hash;
    this.#pending = window.setTimeout(() => {
      this.#pending = undefined;
      if (location.hash !== before) return; // the reader has gone elsewhere, and the page is about to hear of it
      this.#written = hashOf(place());
      history.replaceState(null, "", this.#written);
    }, 250);
  }

  /** Forgets what was to be written, because the reader has gone elsewhere. */
  forget(): void {
    window.clearTimeout(this.#pending);
    this.#pending = undefined;
  }
}

/** A finite number from a link, kept within limits; the fallback when there is none. */
export function numberOf(parameters: URLSearchParams, name: string, limits: NumberLimits): number {
  const text = parameters.get(name);
  const value = text === null || text.trim() === "" ? Number.NaN : Number(text);
  if (!Number.isFinite(value)) return limits.usual;
  return Math.min(limits.most, Math.max(limits.least, value));
}

const axes = ["x", "y", "z"] as const;

/** A point of as many numbers as the usual one: x, y and z, each after a prefix, from a link. */
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

/** One of the known words from a link; the first of them when it says something else. */
export function wordOf<Word extends string>(
  parameters: URLSearchParams,
  name: string,
  words: readonly [Word, ...Word[]],
): Word {
  const text = parameters.get(name);
  return words.find((word) => word === text) ?? words[0];
}
