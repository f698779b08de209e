// Settings of the reader for all screens, stored in this browser.

export const UNIT_SETS = ["si", "metric", "field"] as const;
export type UnitSet = (typeof UNIT_SETS)[number];
export const THEMES = ["auto", "light", "dark"] as const;
export type Theme = (typeof THEMES)[number];

const PREFIX = "wholestring.";

function remembered<T extends string>(name: string, known: readonly T[]): T | null {
  try {
    const stored = localStorage.getItem(PREFIX + name);
    return known.find((value) => value === stored) ?? null;
  } catch {
    return null;
  }
}

function remember(name: string, value: string): void {
  try {
    localStorage.setItem(PREFIX + name, value);
  } catch {
    // Without storage in the browser, the choice applies until the page is closed.
  }
}

const system = matchMedia("(prefers-color-scheme: dark)");

class Settings {
  #chosenUnits = $state<UnitSet | null>(remembered("units", UNIT_SETS));
  #caseUnits = $state<UnitSet>("si");
  #theme = $state<Theme>(remembered("theme", THEMES) ?? "auto");
  #system = $state(system.matches);

  constructor() {
    system.addEventListener("change", () => {
      this.#system = system.matches;
      this.#dress();
    });
    this.#dress();
  }

  /** The units of all numbers: those chosen by the reader, otherwise those of the last displayed case. */
  get units(): UnitSet {
    return this.#chosenUnits ?? this.#caseUnits;
  }

  set units(units: UnitSet) {
    this.#chosenUnits = units;
    remember("units", units);
  }

  /** The units chosen by the reader; null for those of the case. */
  get chosenUnits(): UnitSet | null {
    return this.#chosenUnits;
  }

  /** Sets the units of a case, until the reader chooses others. */
  followCase(units: UnitSet): void {
    this.#caseUnits = units;
  }

  get theme(): Theme {
    return this.#theme;
  }

  set theme(theme: Theme) {
    this.#theme = theme;
    remember("theme", theme);
    this.#dress();
  }

  /** Whether the page is dark; drawings with their own colours follow it. */
  get dark(): boolean {
    return this.#theme === "dark" || (this.#theme === "auto" && this.#system);
  }

  #dress(): void {
    document.documentElement.dataset.theme = this.dark ? "dark" : "light";
  }
}

export const settings = new Settings();
