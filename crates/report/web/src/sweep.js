// The page of a sweep: its figure in the reader's units, and the table.

import { asked } from "./answer.js";
import { readReport } from "./data.js";
import { el } from "./dom.js";
import { header } from "./header.js";
import { sheet } from "./sheet.js";
import { on, state } from "./state.js";
import { useDimensions } from "./units.js";

const report = readReport();
useDimensions(report.dimensions);
state.units = report.units;

const holder = el("div", { class: "figure-holder" });
function draw() {
  const figure = document.getElementById(`figure-${state.units}`).content.cloneNode(true);
  holder.replaceChildren(...(figure.firstChild ? [figure] : ["Nothing was solved."]));
}
on("units", draw);
draw();

document
  .getElementById("page")
  .append(
    header(report.title, asked(report), () => {}),
    el("section", { id: "sweep" }, el("h2", {}, "What came out of it"), holder),
    el("section", { id: "cases" }, sheet(report.sheet)),
    el(
      "footer",
      {},
      el(
        "p",
        {},
        `Made by ${report.program}. Each case has a folder beside this file; sweep.csv holds every digit of the table.`,
      ),
    ),
  );
document.documentElement.dataset.ready = "";
