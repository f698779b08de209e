// The top of a page: its title, and the switches that hold for all of it.

import { choice, el } from "../../../../web/components/dom.ts";
import { choose, state } from "./state.js";
import { followTheme } from "./theme.js";

/** `redraw` draws again what is drawn in colours of its own. */
export function header(title, below, redraw) {
  const setTheme = followTheme(redraw);
  return el(
    "header",
    {},
    el(
      "div",
      { class: "title-line" },
      el("h1", {}, title),
      el(
        "div",
        { class: "controls noprint" },
        choice(
          "Units",
          [
            ["si", "SI"],
            ["metric", "Metric"],
            ["field", "US field"],
          ],
          state.units,
          (units) => choose({ units }),
        ),
        choice(
          "Colours",
          [
            ["auto", "Auto"],
            ["light", "Light"],
            ["dark", "Dark"],
          ],
          state.theme,
          setTheme,
        ),
        el("button", { type: "button", onclick: () => print() }, "Print"),
      ),
    ),
    below,
  );
}
