// The end of a page.

import { el } from "../../../../web/components/dom.ts";

/** Whose programs the page is made with. */
export const licences = () =>
  el(
    "details",
    {},
    el("summary", {}, "Plots by uPlot, 3D by three.js: their licences (MIT)"),
    el("pre", {}, document.getElementById("licences").content.textContent),
  );
