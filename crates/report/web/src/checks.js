// Checks: what an engineer must know of the results, the most severe first.

import { el } from "../../../../web/components/dom.ts";
import { depthText, ofReader, plain, quantity } from "../../../../web/components/units.ts";
import { bySeverity, countText, SEVERITIES, severityMark } from "./severities.js";
import { modelName, readable } from "./solutions.js";
import { choose, on, state } from "./state.js";

/** Of more checks than these, those that are neither errors nor of the chosen operation are folded away. */
const MOST = 8;

/** Every check of a report that needs attention, with what was solved that it is about, the most severe first. */
export const openChecks = (report) =>
  report.solved
    .flatMap((solved) => solved.checks.filter(({ severity }) => severity !== "ok").map((check) => ({ ...check, solved })))
    .sort(bySeverity);

/** Those of an operation by all models. */
export const checksOf = (report, operation) => openChecks(report).filter((check) => check.solved.operation === operation);

/** Those of the chosen operation that have a place, the least severe first. */
export const placedOf = (report) =>
  checksOf(report, state.operation)
    .filter((check) => check.md_m !== null)
    .reverse();

/** The place of a check in the reader's units; null where it has none. */
export function placeText({ md_m, to_md_m }) {
  if (md_m === null) return null;
  const at = depthText(md_m);
  // A stretch shorter than the unit of a depth is a place.
  const to = to_md_m === null ? at : depthText(to_md_m);
  return to === at ? `at ${at}` : `${at} to ${to}`;
}

const numberText = (cell) => (typeof cell === "number" ? plain(cell, 4) : quantity(cell.value, cell.dimension, 4, plain));

/** The list of all checks that need attention; `zoom` shows an interval of depths. */
export function checkList(report, zoom) {
  const holder = el("div", { class: "check-list" });
  const many = new Set(report.solved.map((solved) => solved.operation)).size > 1;
  const models = new Set(report.solved.map((solved) => solved.model)).size > 1;

  function item(check) {
    const { severity, solved, sentences } = check;
    const [word] = SEVERITIES[severity];
    const place = placeText(check);
    const choosable = many && solved.operation !== state.operation;
    const whose = [many && readable(solved.operation), models && modelName(report, solved)].filter(Boolean).join(", ");
    return el(
      "li",
      { class: `check level-${severity}` },
      el("span", { class: "level" }, severityMark(severity), ` ${word}`),
      el(
        "span",
        { class: "message" },
        whose &&
          (choosable
            ? el(
                "button",
                {
                  type: "button",
                  class: "link",
                  title: "Show this operation",
                  onclick: () => choose({ operation: solved.operation, times: null, moment: null }),
                },
                whose,
              )
            : el("strong", {}, whose)),
        whose && ": ",
        ofReader(sentences),
        el(
          "span",
          { class: "note" },
          place && " ",
          place &&
            el(
              "button",
              {
                type: "button",
                class: "link",
                title: "Show these depths along the hole",
                onclick: () => {
                  choose({ operation: solved.operation, times: null, moment: null });
                  zoom(check);
                },
              },
              place,
            ),
        ),
      ),
    );
  }

  function draw() {
    const all = openChecks(report);
    const first = (of) => of.severity === "error" || (of.severity === "warning" && of.solved.operation === state.operation);
    const folded = all.length > MOST ? all.filter((of) => !first(of)) : [];
    const open = holder.querySelector("details")?.open ?? false;
    holder.replaceChildren(
      ...(all.length
        ? [
            el("ul", { class: "checks" }, all.filter((of) => !folded.includes(of)).map(item)),
            folded.length > 0 &&
              el(
                "details",
                { class: "prints", open },
                el("summary", {}, `${folded.length} more: ${countText(folded)}`),
                el("ul", { class: "checks" }, folded.map(item)),
              ),
          ].filter(Boolean)
        : []),
    );
  }

  on("units operation", draw);
  return { element: holder, redraw: draw };
}

const two = (factor) => (factor === null ? "–" : factor >= 100 ? "over 100" : factor.toFixed(2));

/** The checks of the chosen operation as a table, the verdict first, and what could not be checked. */
export function checkTable(report) {
  const holder = el("div", { class: "check-table" });

  function row({ severity, verdict, label, component, value, limit, factor, required, ...check }) {
    const place = [component, placeText(check)].filter(Boolean).join(", ");
    const words = verdict === severity ? SEVERITIES[severity][0] : verdict;
    return el(
      "tr",
      {},
      el("td", { class: `verdict severity-${severity}` }, severityMark(severity), ` ${words}`),
      el("th", { scope: "row" }, label),
      el("td", {}, place),
      el("td", { class: "number", "data-head": "load" }, value === null ? "–" : numberText(value)),
      el("td", { class: "number", "data-head": "capacity" }, limit === null ? "–" : numberText(limit)),
      el("td", { class: "number", "data-head": "factor" }, two(factor)),
      el("td", { class: "number", "data-head": "required" }, two(required)),
    );
  }

  function table(solved, many) {
    const heads = ["Verdict", "Check", "Where", "Load", "Capacity", "Factor", "Required"];
    const caption = many ? `${readable(solved.operation)}, ${modelName(report, solved)}` : readable(solved.operation);
    return el(
      "div",
      { class: "scrolls", tabindex: "0", role: "region", "aria-label": `Checks: ${caption}` },
      el(
        "table",
        {},
        el("caption", {}, `Checks: ${caption}`),
        el("thead", {}, el("tr", {}, ...heads.map((head) => el("th", { scope: "col" }, head)))),
        el("tbody", {}, [...solved.checks].sort(bySeverity).map(row)),
      ),
      solved.unchecked.length > 0 && el("p", { class: "note" }, `Not checked for want of data: ${solved.unchecked.join("; ")}.`),
    );
  }

  function draw() {
    const all = report.solved.filter((solved) => solved.operation === state.operation && solved.checks.length > 0);
    holder.replaceChildren(...all.map((solved) => table(solved, all.length > 1)));
  }

  on("units operation", draw);
  draw();
  return { element: holder, redraw: draw };
}
