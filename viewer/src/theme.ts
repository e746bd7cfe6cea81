// SPDX-License-Identifier: MIT
// Colours, light and dark. Free against touching is blue-grey against vermillion (Okabe and Ito, "Color Universal
// Design", 2008), as in the pictures that `graze check --svg` draws: told apart with every kind of colour vision and by
// lightness alone; what touches is hatched as well.

/** The colours that are drawn in WebGL; style.css holds them for both themes, and those of the page beside them. */
const drawn = [
  "ground",
  "grid",
  "axis",
  "free-line",
  "free-fill",
  "touching-line",
  "touching-fill",
  "selected",
  "answer",
  "second",
  "third",
  "faint",
  "ink",
] as const;

export type Palette = Readonly<Record<(typeof drawn)[number], string>>;

type Mode = "light" | "dark";
const storageKey = "graze-theme";

/** The theme in use: the reader's switch, or what the system prefers. */
export class Theme {
  #mode: Mode;
  #palette: Palette;
  #listeners: (() => void)[] = [];

  constructor() {
    const preference = window.matchMedia("(prefers-color-scheme: dark)");
    const stored = remembered();
    this.#mode = stored ?? (preference.matches ? "dark" : "light");
    preference.addEventListener("change", () => {
      if (remembered() === null) this.#use(preference.matches ? "dark" : "light");
    });
    document.documentElement.dataset["theme"] = this.#mode;
    this.#palette = paletteOfPage();
  }

  get mode(): Mode {
    return this.#mode;
  }

  get palette(): Palette {
    return this.#palette;
  }

  toggle(): void {
    const mode = this.#mode === "dark" ? "light" : "dark";
    try {
      localStorage.setItem(storageKey, mode);
    } catch {
      // A page opened from a file may have no storage; the switch then lasts as long as the page.
    }
    this.#use(mode);
  }

  onChange(listener: () => void): void {
    this.#listeners.push(listener);
  }

  #use(mode: Mode): void {
    this.#mode = mode;
    document.documentElement.dataset["theme"] = mode;
    this.#palette = paletteOfPage();
    for (const listener of this.#listeners) listener();
  }
}

function paletteOfPage(): Palette {
  const style = getComputedStyle(document.documentElement);
  const entries = drawn.map((name) => [name, style.getPropertyValue(`--${name}`).trim()] as const);
  return Object.fromEntries(entries) as Palette;
}

function remembered(): Mode | null {
  try {
    const stored = localStorage.getItem(storageKey);
    return stored === "light" || stored === "dark" ? stored : null;
  } catch {
    return null;
  }
}
