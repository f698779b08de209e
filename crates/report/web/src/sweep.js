// The page of a sweep: its figure in the reader's units, and the table.

import { el } from "../../../../web/components/dom.ts";
import { facts } from "./key_results.js";
import { contents } from "./contents.js";
import { readReport } from "./data.js";
import { downloads } from "./downloads.js";
import { figure } from "./figure.js";
import { header } from "./header.js";
import { cellText, pageTable, tableDownloads } from "./page_table.js";
import { usePageUnits } from "./page_units.js";
import { SEVERITIES, severityMark } from "./severities.js";
import { on } from "./state.js";
import { ofReader } from "../../../../web/components/units.ts";

const report = readReport();
usePageUnits(report.dimensions, report.units);

/** What a point shows: the case by its keys, what came out of it, and what was found. */
function describe(row) {
  const { heads, rows } = report.page_table;
  const { check, page } = report.rows[row];
  const ends = heads.indexOf("Operation") + 1;
  const text = (i) => `${heads[i]}: ${cellText(rows[row][i], 4)}`;
  const keys = rows[row].slice(0, ends - 2).map((value, i) => `${heads[i]} ${cellText(value)}`);
  const columns = heads.map((_, i) => i).filter((i) => i >= ends - 2 && rows[row][i] !== null && !rows[row][i].href);
  const lines = columns.filter((i) => rows[row][i] !== "").map((i) => ({ text: text(i) }));
  if (ofReader(check)) lines.push({ text: ofReader(check), class: "mine" });
  if (page) lines.push({ text: "click for its report" });
  return { title: keys.join(", "), rows: lines, href: page };
}

const drawn = figure("figure", "Nothing was solved.", describe);
/** The verdict in the head of the page: how many cases have errors or warnings, and the most severe check. */
function verdict({ severity, counts, sentences }) {
  const [word] = SEVERITIES[severity];
  const text = counts[0].toUpperCase() + counts.slice(1);
  const most = el("span", {});
  const draw = () => (most.textContent = ofReader(sentences) && ` Most severe: ${ofReader(sentences)}`);
  on("units", draw);
  draw();
  return el(
    "div",
    { class: `check level-${severity} verdict` },
    el("span", { class: "level" }, severityMark(severity), ` ${word}`),
    el("span", {}, el("strong", {}, `${text}.`), most),
  );
}

const save = downloads("Sweep", { svg: drawn.there() ? drawn.file : null });
const sections = [
  el("section", { id: "sweep" }, el("h2", {}, "What came out of it", save, tableDownloads(report.page_table)), drawn.element),
  el("section", { id: "cases" }, el("h2", {}, "All cases", tableDownloads(report.page_table)), pageTable(report.page_table)),
];
const hint = el(
  "p",
  { class: "hint noprint" },
  "point at a case to read it, click to open its report where it has one; click a name of the legend to hide its curves; a ring marks a case with errors, a dashed one a case with warnings",
);
sections[0].querySelector("h2").after(hint);
document
  .getElementById("page")
  .append(
    header(report.title, [report.verdict && verdict(report.verdict), facts(report)].filter(Boolean), () => {}),
    contents(sections).element,
    ...sections,
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
