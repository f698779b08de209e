// The current screen, from the part of the address after `#`.

import { isScreen, type Screen } from "./screens";

/** A screen, the id of its content, and the query of the address. */
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
/** Called before a screen is left; returns whether it may be. */
let guard: (() => boolean) | null = null;

addEventListener("hashchange", (event) => {
  if (guard && !guard()) {
    history.replaceState(null, "", new URL(event.oldURL).hash);
    return;
  }
  current = parse(location.hash);
});

/** The current route; reactive in templates and effects. */
export const route = {
  get now(): Route {
    return current;
  },
};

/** The address of a screen, for links. */
export function address(screen: Screen, id = "", query: Record<string, string> = {}): string {
  const search = new URLSearchParams(query).toString();
  const path = screen === "cases" ? "#/" : `#/${screen}${id === "" ? "" : `/${encodeURIComponent(id)}`}`;
  return search === "" ? path : `${path}?${search}`;
}

/** Goes to a screen. */
export function go(screen: Screen, id = "", query: Record<string, string> = {}): void {
  location.hash = address(screen, id, query);
}

/** Keeps the user on this screen while `may` returns false; returns the function that ends this. */
export function guardLeaving(may: () => boolean): () => void {
  guard = may;
  return () => {
    if (guard === may) guard = null;
  };
}
