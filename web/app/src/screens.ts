// Components of the screens; each is fetched when first displayed.

import type { Component } from "svelte";
import type { Route } from "./router.svelte";

/** Properties of every screen. */
export interface ScreenProps {
  route: Route;
}

/** Every screen by its name in the address: `#/NAME/ID`. */
const SCREENS = {
  cases: () => import("./cases/CasesScreen.svelte"),
  answers: () => import("./answers/AnswersScreen.svelte"),
  case: () => import("./case/CaseScreen.svelte"),
  seat: () => import("./seat/SeatScreen.svelte"),
  // Screens that require the program and its folder.
  ...(__ALONE__
    ? {}
    : {
        work: () => import("./work/WorkScreen.svelte"),
        results: () => import("./work/ResultScreen.svelte"),
        compare: () => import("./work/CompareScreen.svelte"),
        import: () => import("./work/ImportScreen.svelte"),
      }),
} satisfies Record<string, () => Promise<{ default: Component<ScreenProps> | Component }>>;

export type Screen = keyof typeof SCREENS;

export const isScreen = (name: string): name is Screen => Object.hasOwn(SCREENS, name);

export async function screenOf(screen: Screen): Promise<Component<ScreenProps>> {
  const found: unknown = (await SCREENS[screen]!()).default;
  return found as Component<ScreenProps>;
}
