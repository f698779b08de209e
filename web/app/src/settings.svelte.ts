// What the reader has chosen for every screen; kept in this browser.

export const UNIT_SETS = ["si", "metric", "field"] as const;
export type UnitSet = (typeof UNIT_SETS)[number];
export const THEMES = ["auto", "light", "dark"] as const;
export type Theme = (typeof THEMES)[number];

const PREFIX = "wholestring.";

function remembered<T extends string>(name: string, known: readonly T[]): T | null {
  try {
    const kept = localStorage.getItem(PREFIX + name);
    return known.find((value) => value === kept) ?? null;
  } catch {
    return null;
  }
}

function remember(name: string, value: string): void {
  try {
    localStorage.setItem(PREFIX + name, value);
  } catch {
    // A browser that keeps nothing: the choice holds until the page is closed.
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

  /** The units of all numbers: those that the reader has chosen, else those of the case that was shown last. */
  get units(): UnitSet {
    return this.#chosenUnits ?? this.#caseUnits;
  }

  set units(units: UnitSet) {
    this.#chosenUnits = units;
    remember("units", units);
  }

  /** The units that the reader has chosen; null where a case says its own. */
  get chosenUnits(): UnitSet | null {
    return this.#chosenUnits;
  }

  /** Shows numbers in the units of a case, until the reader chooses others. */
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

  /** Whether the page is dark now; drawings in colours of their own follow it. */
  get dark(): boolean {
    return this.#theme === "dark" || (this.#theme === "auto" && this.#system);
  }

  #dress(): void {
    document.documentElement.dataset.theme = this.dark ? "dark" : "light";
  }
}

export const settings = new Settings();
