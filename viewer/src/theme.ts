// SPDX-License-Identifier: MIT
// Colours for light and dark mode, as in the pictures of `graze check --svg`: free shapes are blue-grey, overlapping
// ones vermillion (Okabe and Ito, "Color Universal Design", 2008), touching ones a muted green. Patterns distinguish
// them as well: hatching on overlapping and dots on touching shapes.

/** The colours used in WebGL; style.css defines them for both themes, together with those of the page. */
const drawn = [
  "ground",
  "grid",
  "axis",
  "free-line",
  "free-fill",
  "touching-line",
  "touching-fill",
  "overlapping-line",
  "overlapping-fill",
  "selected",
  "answer",
  "second",
  "third",
  "faint",
  "ink",
] as const;

export type Palette = Readonly<Record<(typeof drawn)[number], string>>;

/** Whether the background is dark; then shadows are darker and large areas paler. */
export function isDark(palette: Palette): boolean {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => Number.parseInt(palette.ground.slice(at, at + 2), 16));
  return red + green + blue < 384;
}

type Mode = "light" | "dark";
const storageKey = "graze-theme";

/** The current theme: the reader's choice, or the system's preference. */
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
      // A page opened from a file may have no storage; the choice then lasts as long as the page.
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
