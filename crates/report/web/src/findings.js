// Findings: what an engineer must know of the results, the gravest first.

import { el } from "../../../../web/components/dom.ts";
import { depthText, plain, quantity } from "../../../../web/components/units.ts";
import { byLevel, countText, levelMark, LEVELS } from "./levels.js";
import { modelName, readable } from "./solutions.js";
import { choose, on, state } from "./state.js";

/** Of more findings than these, those that are neither errors nor of the chosen operation are folded away. */
const MOST = 8;

/** Every finding of a report with what was solved that it is about, the gravest first. */
export const allFindings = (report) =>
  report.solved.flatMap((solved) => solved.findings.map((finding) => ({ ...finding, solved }))).sort(byLevel);

/** The findings of an operation by all models. */
export const findingsOf = (report, operation) =>
  allFindings(report).filter((finding) => finding.solved.operation === operation);

/** The findings of the chosen operation that have a place, the least grave first. */
export const placedOf = (report) =>
  findingsOf(report, state.operation)
    .filter((finding) => finding.md_m !== null)
    .reverse();

/** `hook_load_negative` as people write it, with a capital. */
export const kindText = (kind) => kind.replaceAll("_", " ").replace(/^./, (letter) => letter.toUpperCase());

/** Where a finding stands, in the reader's units; null where it has no place. */
export function placeText({ md_m, to_md_m }) {
  if (md_m === null) return null;
  const at = depthText(md_m);
  return to_md_m === null ? `at ${at}` : `${at} to ${depthText(to_md_m)}`;
}

const numberText = (cell) => (typeof cell === "number" ? plain(cell, 4) : quantity(cell.value, cell.dimension, 4, plain));

/** What was found against its limit in the reader's units, where those are not the message's; null where it is no number. */
function numbers({ value, limit }, messageUnits) {
  // The message has them in its own units.
  if (value === null || state.units === messageUnits) return null;
  return limit === null ? numberText(value) : `${numberText(value)} against ${numberText(limit)}`;
}

/** The list of all findings; `zoom` shows an interval of depths. */
export function findingList(report, zoom) {
  const holder = el("div", { class: "finding-list" });
  const many = new Set(report.solved.map((solved) => solved.operation)).size > 1;
  const models = new Set(report.solved.map((solved) => solved.model)).size > 1;

  function item(finding) {
    const { level, solved, message } = finding;
    const [word] = LEVELS[level];
    const place = placeText(finding);
    const choosable = many && solved.operation !== state.operation;
    const whose = [many && readable(solved.operation), models && modelName(report, solved)].filter(Boolean).join(", ");
    return el(
      "li",
      { class: `finding level-${level}` },
      el("span", { class: "level" }, levelMark(level), ` ${word}`),
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
        message,
        el(
          "span",
          { class: "note" },
          numbers(finding, report.message_units) && ` ${numbers(finding, report.message_units)}`,
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
                  zoom(finding);
                },
              },
              place,
            ),
        ),
      ),
    );
  }

  function draw() {
    const all = allFindings(report);
    const first = (of) => of.level === "error" || (of.level === "warning" && of.solved.operation === state.operation);
    const folded = all.length > MOST ? all.filter((of) => !first(of)) : [];
    const open = holder.querySelector("details")?.open ?? false;
    holder.replaceChildren(
      ...(all.length
        ? [
            el("ul", { class: "findings" }, all.filter((of) => !folded.includes(of)).map(item)),
            folded.length > 0 &&
              el(
                "details",
                { class: "prints", open },
                el("summary", {}, `${folded.length} more: ${countText(folded)}`),
                el("ul", { class: "findings" }, folded.map(item)),
              ),
          ].filter(Boolean)
        : []),
    );
  }

  on("units operation", draw);
  return { element: holder, redraw: draw };
}
