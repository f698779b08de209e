// The case in a few facts, and the five numbers that matter most, beside their limits.

import { el } from "../../../../web/components/dom.ts";
import { ofReader, plain, quantity } from "../../../../web/components/units.ts";
import { checksOf } from "./checks.js";
import { severityMark, SEVERITIES, worstOf } from "./severities.js";
import { cellText } from "./page_table.js";
import { chosen, chosenAnswer, chosenAtRest, hasNumbers, modelName } from "./solutions.js";
import { on, state } from "./state.js";

export function facts(report) {
  const list = el("dl", { class: "facts" });
  const draw = () =>
    list.replaceChildren(
      ...report.facts.map(({ label, value }) => el("div", {}, el("dt", {}, label), el("dd", {}, cellText(value, value?.dimension === "length" ? 5 : 4, plain)))),
    );
  on("units", draw);
  draw();
  return list;
}

const INKS = { ok: "within", note: "near", warning: "near", error: "over" };

/** The colour and the verdict of the limit that governs a number; no verdict where the judge has none. */
function judged(checks, kinds) {
  const limits = checks.filter((check) => kinds.includes(check.kind) && check.factor !== null);
  const [governing] = limits.sort((a, b) => a.factor / a.required - b.factor / b.required);
  return governing ? [INKS[governing.severity], `of the limit: ${governing.verdict}`] : ["", "of the limit"];
}

/** The mark of a number that has open checks: a card may not look well beside an error of the same quantity. */
function flag(level, checks) {
  const few = checks.length === 1 ? "see the check above" : `see the ${checks.length} checks above`;
  return el("p", { class: `flag level-${level}` }, severityMark(level), el("strong", {}, ` ${SEVERITIES[level][0]}`), `: ${few}`);
}

/** Quantities of which the least span of a chart says what is nothing: a hundredth of it. */
const NOTHING = { part: 0.01, of: ["force", "torque"] };

/** A cell in which what is nothing beside the quantity's usual size, such as a torque of 3 N·m, is 0. */
function sized(cell, report) {
  if (!NOTHING.of.includes(cell?.dimension)) return cell;
  const spans = report.time_plots.filter((plot) => plot.dimension === cell.dimension).map((plot) => plot.min_span);
  return Math.abs(cell.value) < NOTHING.part * Math.max(...spans) ? { ...cell, value: 0 } : cell;
}

function card(report, result, beside, checks) {
  const open = checksOf(report, state.operation);
  const mine = open.filter((of) => result.check_kinds.includes(of.kind));
  const level = worstOf(mine);
  const dimension = result.value?.dimension;
  const children = [
    el("h3", {}, result.label),
    el("p", { class: "number" }, cellText(sized(result.value, report), dimension === "ratio" || dimension === "percent" ? 3 : 4)),
  ];
  if (result.largest !== null && dimension)
    children.push(el("p", { class: "note" }, `mean; at most ${quantity(sized({ value: result.largest, dimension }, report).value, dimension)}`));
  for (const { label, value } of result.more) children.push(el("p", { class: "note" }, `${cellText(value, 4)} ${label}`));
  if (beside?.result?.value?.dimension === dimension && dimension)
    children.push(el("p", { class: "note" }, `${beside.name} ${cellText(sized(beside.result.value, report), 4)}`));
  if (level) children.push(flag(level, mine));
  const compared = result.compared ?? result.largest ?? result.value?.value;
  if (result.limit !== null && Number.isFinite(compared)) {
    const part = compared / result.limit;
    const [kind, words] = judged(checks, result.check_kinds);
    children.push(
      el(
        "div",
        { class: `limit ${kind}` },
        el(
          "div",
          { class: "bar" },
          el("div", { class: "used", style: `width:${Math.min(Math.max(part, 0), 1) * 100}%` }),
        ),
        el(
          "p",
          { class: "note" },
          el("strong", {}, `${Math.round(part * 100)} % ${words}`),
          el("br"),
          `${result.limit_label} ${dimension === "percent" || dimension === "ratio" ? "" : quantity(result.limit, dimension)}`,
        ),
      ),
    );
  } else children.push(el("p", { class: "note" }, result.limit_label));
  return el("div", { class: `card key-result${level ? ` has-${level}` : ""}` }, children);
}

export function keyResults(report) {
  const holder = el("div", {});
  const draw = () => {
    const all = chosen(report);
    const main = chosenAnswer(report);
    const rest = chosenAtRest(report);
    const beside = (result) =>
      rest && rest !== main && { name: modelName(report, rest), result: rest.key_results.find((other) => other.label === result.label) };
    const messages = all
      .filter((solved) => solved.message)
      .map((solved) => el("p", { class: "warning" }, `${modelName(report, solved)}: ${ofReader(solved.message)}`));
    if (main && main !== all[0] && hasNumbers(main)) messages.push(el("p", { class: "note" }, `Numbers of the ${modelName(report, main)}:`));
    if (!main || !hasNumbers(main)) messages.push(el("p", { class: "note" }, "No model has numbers of this operation."));
    holder.replaceChildren(
      ...messages,
      el(
        "div",
        { class: "key-results" },
        (main?.key_results ?? []).map((result) => card(report, result, beside(result), main.checks)),
      ),
    );
  };
  on("units operation", draw);
  return { element: holder, redraw: draw };
}
