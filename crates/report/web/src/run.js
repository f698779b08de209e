// The page of a run.

import { choice, el } from "../../../../web/components/dom.ts";
import { facts, keyResults } from "./key_results.js";
import { bottomView } from "./bottom.js";
import { contactMap } from "./contact.js";
import { contents } from "./contents.js";
import { drillOff } from "./drill_off.js";
import { checkList, checksOf, checkTable, openChecks } from "./checks.js";
import { licences } from "./footer.js";
import { header } from "./header.js";
import { history } from "./history.js";
import { countMarks, countText } from "./severities.js";
import { scene } from "./scene.js";
import { pageTable } from "./page_table.js";
import { answeredOperations, chosenRun, operations, readable } from "./solutions.js";
import { spectra } from "./spectra.js";
import { choose, each, on, state } from "./state.js";
import { tracks } from "./tracks.js";

/** Of these operations the one with the most severe check, if that is more than a note. */
function worstOperation(report, among) {
  const all = openChecks(report).filter((of) => among.includes(of.solved.operation));
  if (!all.length || all[0].severity === "note") return null;
  // Of several as grave, the one with the most of them; of those alike the first.
  const grave = all.filter((of) => of.severity === all[0].severity).map((of) => of.solved.operation);
  const count = (operation) => grave.filter((other) => other === operation).length;
  return grave.reduce((worst, operation) => (count(operation) > count(worst) ? operation : worst));
}

/** The name of an operation with what was found of it, for eyes and ears. */
function named(report, operation) {
  const open = checksOf(report, operation).filter((of) => of.severity !== "note");
  const text = open.length ? `${readable(operation)}: ${countText(open)}` : null;
  return [operation, [readable(operation), ...countMarks(open)], text];
}

/** Shows the report of a run. */
export function runPage(report) {
  const all = operations(report);
  // A page opens on an operation that has numbers, if any has.
  const answered = answeredOperations(report);
  const among = answered.length ? answered : all;
  const last = report.runs.filter((run) => among.includes(run.operation)).at(-1);
  Object.assign(state, {
    // What is wrong is seen first.
    operation: worstOperation(report, among) ?? last?.operation ?? among.at(-1),
    depth: (report.well.md_m.at(-1) ?? 0) / 2,
  });

  const parts = { keyResults: keyResults(report), tracks: tracks(report) };
  parts.checks = checkList(report, parts.tracks.zoomTo);
  parts.checkTable = checkTable(report);
  if (report.runs.length) {
    parts.history = history(report, report.time_plots, true);
    parts.contact = contactMap(report);
  }
  if (report.runs.some((run) => run.drill_off)) {
    parts.bit = history(report, report.bit_plots, false);
    parts.drillOff = drillOff(report);
  }
  if (report.runs.some((run) => run.spectra.length)) parts.spectra = spectra(report);
  if (report.runs.some((run) => run.bottom)) parts.bottom = bottomView(() => chosenRun(report)?.bottom, true);
  if (report.well.md_m.length > 1) parts.scene = scene(report);

  /** A part that fails leaves the others drawn. */
  const redrawAll = () => Object.values(parts).forEach((part) => each(part.redraw));

  const section = (id, title, ...children) => el("section", { id }, el("h2", {}, title), children);
  const pageTables = (place) => report.page_tables.filter((table) => table.place === place).map(pageTable);

  function noteOf(run) {
    const rows = run.history.time_s?.length ?? 0;
    const thin =
      rows < run.samples
        ? `${run.samples} samples are drawn as ${rows}, the smallest and the largest of each few: peaks keep their height`
        : `all ${run.samples} samples are drawn`;
    const { frames } = run;
    const moments =
      frames &&
      (frames.time_s.length < frames.kept
        ? `; ${frames.time_s.length} of ${frames.kept} frames`
        : `; all ${frames.kept} frames`);
    const nodes = frames && frames.md_m.length < frames.nodes ? `, ${frames.md_m.length} of ${frames.nodes} nodes` : "";
    return `${readable(run.operation)}: ${thin}${moments ?? ""}${nodes}.`;
  }

  const page = document.getElementById("page");
  const operationChoice =
    all.length > 1
      ? choice(
          "Operation",
          all.map((name) => named(report, name)),
          state.operation,
          (operation) => choose({ operation, times: null, moment: null }),
        )
      : null;
  page.append(
    header(report.title, facts(report), redrawAll),
    section(
      "answer",
      "Answer",
      parts.checks.element,
      operationChoice && el("div", { class: "operations" }, operationChoice),
      parts.keyResults.element,
      parts.checkTable.element,
    ),
    section("tracks", "Along the hole", parts.tracks.element),
  );
  /** Sections of what not every operation has, each with what it needs. */
  const some = [];
  const add = (needs, ...section_) => some.push([section(...section_), needs]);
  if (parts.history) add((run) => run, "history", "In time", parts.history.element);
  if (parts.spectra) add((run) => run?.spectra.length, "spectra", "Spectra", parts.spectra.element);
  if (parts.bit) add((run) => run?.drill_off, "bit", "Bit", parts.bit.element, parts.drillOff.element);
  if (parts.bottom) {
    const note = el("p", { class: "note" }, "As the operation left it.");
    add((run) => run?.bottom, "bottom", "Bottom of the hole", parts.bottom.element, note);
  }
  if (parts.contact) add((run) => run?.contact, "contact", "Contact over depth and time", parts.contact.element);
  page.append(...some.map(([section]) => section));
  if (parts.scene) page.append(section("scene", "In space", parts.scene.element));
  page.append(
    section("results", "All numbers", pageTables("results")),
    ...(report.runs.length ? [section("numerics", "Numerics", pageTables("numerics"))] : []),
    section("inputs", "Inputs, defaults included", pageTables("inputs")),
    el(
      "footer",
      {},
      el(
        "p",
        {},
        `Made by ${report.program}. The tables beside this file hold every digit; this page holds what can be seen. `,
        report.runs.map(noteOf).join(" "),
      ),
      licences(),
    ),
  );

  /** What the chosen operation does not have goes. */
  const links = contents([...page.querySelectorAll("section")]);
  page.querySelector("header").after(links.element);
  const hide = () => {
    some.forEach(([section, needs]) => section.toggleAttribute("hidden", !needs(chosenRun(report))));
    links.redraw();
    for (const button of page.querySelectorAll(".operations button"))
      button.setAttribute("aria-pressed", String(button.dataset.value === state.operation));
  };
  on("operation", hide);
  hide();
  redrawAll();
}
