// The case of the current screen, for its links and for the title of the window.

import { listCases } from "../api/cases";
import { route } from "../router.svelte";
import type { Screen } from "../screens";

/** Titles of the screens. */
export const TITLES: Record<string, string> = {
  cases: "Cases",
  case: "Case",
  answers: "Answers",
  seat: "Driller's seat",
  work: "Work",
  results: "Results",
  compare: "Comparison",
  import: "Import",
};

/** Screens whose id is that of a case. */
const OF_CASE: readonly Screen[] = ["case", "answers", "seat", ...(__ALONE__ ? [] : (["work"] as const))];

let found = $state.raw<{ id: string; name: string } | null>(null);
/** The case of a screen with another id. */
let foreign = $state.raw<{ screenId: string; id: string } | null>(null);

const id = (): string => {
  const { screen, id } = route.now;
  if (OF_CASE.includes(screen)) return id;
  return foreign?.screenId === id ? foreign.id : "";
};

/** The case of the current screen; null if it has none. */
export const currentCase = {
  get now(): { id: string; name: string } | null {
    const now = id();
    return now === "" ? null : { id: now, name: found?.id === now ? found.name : "" };
  },
};

/** Sets the name of a case. */
export function nameCase(id: string, name: string): void {
  if (found?.id !== id || found.name !== name) found = { id, name };
}

/** Sets the case of a screen with another id, such as results, by its name. */
export async function caseNamed(screenId: string, name: string): Promise<void> {
  const own = (await listCases()).find((one) => one.name === name);
  if (!own) return;
  foreign = { screenId, id: own.id };
  nameCase(own.id, own.name);
}

/** Keeps the name of the case and the title of the window up to date; called once. */
export function followRoute(): void {
  $effect(() => {
    const now = currentCase.now;
    if (!now || now.name !== "" || route.now.screen === "case") return;
    listCases().then(
      (cases) => {
        const own = cases.find((one) => one.id === now.id);
        if (own) nameCase(own.id, own.name);
      },
      () => {
        // The screen reports that the server does not answer.
      },
    );
  });
  $effect(() => {
    const screen = TITLES[route.now.screen] ?? "";
    const parts = [currentCase.now?.name ?? "", screen, "wholestring"].filter((part) => part !== "");
    document.title = parts.join(" – ");
  });
}
