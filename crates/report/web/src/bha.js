// The page of a static BHA analysis: how it lies, what it does to the bit, how it bends, and what was varied.

import { el } from "../../../../web/components/dom.ts";
import { ofReader } from "../../../../web/components/units.ts";
import { facts } from "./key_results.js";
import { contents } from "./contents.js";
import { downloads } from "./downloads.js";
import { figure } from "./figure.js";
import { licences } from "./footer.js";
import { header } from "./header.js";
import { pageTable, tableDownloads } from "./page_table.js";
import { SEVERITIES, severityMark } from "./severities.js";
import { on } from "./state.js";

const section = (id, title, ...children) => el("section", { id }, el("h2", {}, title), children);

/** A section with a figure that the page holds. */
function drawn(id, title, name, ...notes) {
  const { element, file, there } = figure(name, "Nothing was solved.");
  return section(id, [title, downloads(title, { svg: there() ? file : null })], element, notes);
}

/** A table with its title, which one whose columns are quantities does not show itself. */
const titled = (table) => (table.place === "cases" ? [el("h3", {}, table.title, tableDownloads(table)), pageTable(table, EXACT)] : pageTable(table));

/** Contacts and sensors are identified by their depth. */
const EXACT = { exact: true };

const note = (text) => el("p", { class: "note" }, text);

/** What the assembly does to the inclination, in the reader's units. */
function tendency(report) {
  const line = el("p", { class: "verdict" });
  const draw = () => {
    line.textContent = ofReader(report.tendency).map((sentence) => `${sentence}.`).join(" ");
    line.hidden = line.textContent === "";
  };
  on("units", draw);
  draw();
  return line;
}

/** The checks that need attention, in the reader's units. */
function judged(report) {
  const list = el("ul", { class: "checks" });
  const draw = () =>
    list.replaceChildren(
      ...report.checks.map(({ severity, sentences }) =>
        el(
          "li",
          { class: `check level-${severity}` },
          el("span", { class: "level" }, severityMark(severity), ` ${SEVERITIES[severity][0]}`),
          el("span", { class: "message" }, ofReader(sentences)),
        ),
      ),
    );
  on("units", draw);
  draw();
  return report.checks.length > 0 ? el("div", { class: "check-list" }, list) : null;
}

const VARIED = { toolface: "Tool face", weight: "Weight on bit", inclination: "Inclination" };

/** Shows a static BHA analysis. */
export function bhaPage(report) {
  const results = report.page_tables.filter((table) => table.place !== "inputs");
  const inputs = report.page_tables.filter((table) => table.place === "inputs");
  const [contacts, ...others] = results;
  const page = document.getElementById("page");
  page.append(
    header(report.title, [judged(report), tendency(report), facts(report)].filter(Boolean), () => {}),
    ...(report.message ? [el("p", { class: "warning" }, report.message)] : []),
    drawn(
      "views",
      "The assembly in its hole",
      "views",
      note(
        "The wall is the two lines. A side force of the bit towards the high side builds inclination, one to the right " +
          "turns the hole to the right. Directions are as one looks down the hole.",
      ),
    ),
    section("contacts", ["Contacts", tableDownloads(contacts)], pageTable(contacts, EXACT)),
    drawn("bending", "Bending", "bending"),
    ...report.sweeps.map(([name]) => drawn(name, VARIED[name] ?? name, name)),
    section("results", "Numbers", others.flatMap(titled)),
    ...(inputs.length ? [section("inputs", "Inputs, defaults included", inputs.map(pageTable))] : []),
    el(
      "footer",
      {},
      el("p", {}, `Made by ${report.program}. The tables beside this file hold every digit.`),
      licences(),
    ),
  );
  page.querySelector("header").after(contents([...page.querySelectorAll("section:has(h2)")]).element);
}
