// SPDX-License-Identifier: MIT
// The panel beside the stage: text, controls and figures.
import { element } from "./dom";

export interface SliderOptions {
  readonly label: string;
  readonly least: number;
  readonly most: number;
  readonly step?: number;
  readonly value: number;
  /** Steps are multiplicative instead of additive. */
  readonly logarithmic?: boolean;
  readonly text?: (value: number) => string;
  readonly onInput: (value: number) => void;
}

/** A labelled slider that shows its value. */
export function slider(options: SliderOptions): HTMLElement {
  const text = options.text ?? String;
  const shown = element("span", { class: "value", "aria-hidden": "true" }, text(options.value));
  const scale = options.logarithmic === true ? Math.log10 : (value: number) => value;
  const unscale = options.logarithmic === true ? (value: number) => Math.round(10 ** value) : (value: number) => value;
  const input = element("input", {
    type: "range",
    min: scale(options.least),
    max: scale(options.most),
    step: options.logarithmic === true ? 0.01 : (options.step ?? 1),
    value: scale(options.value),
    "aria-label": options.label,
    "aria-valuetext": text(options.value),
  });
  input.addEventListener("input", () => {
    const value = unscale(input.valueAsNumber);
    shown.textContent = text(value);
    input.setAttribute("aria-valuetext", text(value));
    options.onInput(value);
  });
  return element("label", { class: "slider" }, element("span", {}, options.label), shown, input);
}

/** A choice among a few words, as buttons of which one is pressed. */
export function choice<Word extends string>(
  label: string,
  words: readonly (readonly [Word, string])[],
  chosen: Word,
  onChoose: (word: Word) => void,
): HTMLElement {
  const buttons = words.map(([word, text]) =>
    element("button", { type: "button", "aria-pressed": String(word === chosen), onclick: () => press(word) }, text),
  );
  const press = (word: Word): void => {
    buttons.forEach((button, index) => button.setAttribute("aria-pressed", String(words[index]?.[0] === word)));
    onChoose(word);
  };
  return element("div", { class: "choice", role: "group", "aria-label": label }, ...buttons);
}

/** The choice between 2D and 3D, the default first. */
export function dimensionChoice(words: readonly [2 | 3, 2 | 3], chosen: 2 | 3, onChoose: (dimension: 2 | 3) => void): HTMLElement {
  const texts = words.map((word) => [String(word), `${word}D`] as const);
  return choice<string>("Dimension", texts, String(chosen), (word) => onChoose(word === "3" ? 3 : 2));
}

/** The heading of the page. */
export function title(text: string): HTMLElement {
  return element("h1", {}, text);
}

/** A checkbox. */
export function toggle(label: string, on: boolean, onToggle: (on: boolean) => void): HTMLElement {
  const input = element("input", { type: "checkbox", checked: on });
  input.addEventListener("change", () => onToggle(input.checked));
  return element("label", { class: "toggle" }, input, label);
}

export function button(label: string, onPress: () => void, title = ""): HTMLButtonElement {
  return element("button", { type: "button", onclick: onPress, title }, label);
}

export function row(...children: (Node | string)[]): HTMLElement {
  return element("div", { class: "row" }, ...children);
}

/** A heading and its content. */
export function section(heading: string, ...children: (Node | string)[]): HTMLElement {
  return element("section", {}, element("h2", {}, heading), ...children);
}

/** Named figures that are updated in place. */
export class Figures {
  readonly root = element("dl", { class: "figures" });
  readonly #values = new Map<string, HTMLElement>();

  /** `id` identifies the figure for tests. */
  set(id: string, label: string, value: string): void {
    let shown = this.#values.get(id);
    if (shown === undefined) {
      shown = element("dd", { id: `figure-${id}` });
      this.#values.set(id, shown);
      this.root.append(element("div", {}, element("dt", {}, label), shown));
    }
    if (shown.textContent !== value) shown.textContent = value;
  }
}
