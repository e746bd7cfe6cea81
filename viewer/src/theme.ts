// SPDX-License-Identifier: MIT
// Colours, light and dark, those of the pictures that `graze check --svg` draws: free shapes are blue-grey, overlapping ones
// vermillion (Okabe and Ito, "Color Universal Design", 2008), touching ones a calmer green. Patterns tell them apart as well:
// lines over what overlaps, dots over what touches.

/** The colours that are drawn in WebGL; style.css holds them for both themes, and those of the page beside them. */
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

/** Whether the ground is dark, where shadows have to be deeper and large areas paler. */
export function isDark(palette: Palette): boolean {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => Number.parseInt(palette.ground.slice(at, at + 2), 16));
  return red + green + blue < 384;
}

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
