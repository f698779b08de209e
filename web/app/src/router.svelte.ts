// Which screen is shown: the part of the address behind `#`.

import { isScreen, type Screen } from "./screens";

/** A screen, the thing that it shows, and what else the address says. */
export interface Route {
  screen: Screen;
  id: string;
  query: URLSearchParams;
}

function parse(hash: string): Route {
  const [path = "", query = ""] = hash.replace(/^#\/?/, "").split("?");
  const [screen = "", ...rest] = path.split("/");
  return {
    screen: isScreen(screen) ? screen : "cases",
    id: decodeURIComponent(rest.join("/")),
    query: new URLSearchParams(query),
  };
}

let current = $state.raw(parse(location.hash));
/** Asked before a screen is left; says whether it may be. */
let guard: (() => boolean) | null = null;

addEventListener("hashchange", (event) => {
  if (guard && !guard()) {
    history.replaceState(null, "", new URL(event.oldURL).hash);
    return;
  }
  current = parse(location.hash);
});

/** The route that is shown; follow it in templates and effects. */
export const route = {
  get now(): Route {
    return current;
  },
};

/** The address of a screen, for links. */
export function address(screen: Screen, id = "", query: Record<string, string> = {}): string {
  const asked = new URLSearchParams(query).toString();
  const path = screen === "cases" ? "#/" : `#/${screen}${id === "" ? "" : `/${encodeURIComponent(id)}`}`;
  return asked === "" ? path : `${path}?${asked}`;
}

/** Goes to a screen. */
export function go(screen: Screen, id = "", query: Record<string, string> = {}): void {
  location.hash = address(screen, id, query);
}

/** Holds the reader on this screen while `may` says no; gives what lets go. */
export function guardLeaving(may: () => boolean): () => void {
  guard = may;
  return () => {
    if (guard === may) guard = null;
  };
}
