// Light and dark, and paper, which is light.

import { isPrinting } from "../../../../web/components/printing.ts";
import { remember, remembered } from "./memory.js";
import { choose, state } from "./state.js";

const system = matchMedia("(prefers-color-scheme: dark)");

/** Whether the page is dark now. */
const isDark = () => !isPrinting() && (state.theme === "dark" || (state.theme === "auto" && system.matches));

/** Sets the looks; `redraw` draws again what is drawn in colours of its own. */
export function followTheme(redraw) {
  state.theme = remembered("theme", ["auto", "light", "dark"]) ?? state.theme;
  const set = () => {
    document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  };
  const apply = () => {
    set();
    redraw();
  };
  system.addEventListener("change", apply);
  const print = (now) => () => {
    for (const details of document.querySelectorAll("details.prints")) {
      if (now) {
        details.dataset.was = details.open ? "open" : "";
        details.open = true;
      } else details.open = details.dataset.was === "open";
    }
    apply();
  };
  addEventListener("beforeprint", print(true));
  addEventListener("afterprint", print(false));
  set();
  return (theme) => {
    choose({ theme });
    remember("theme", theme);
    apply();
  };
}
