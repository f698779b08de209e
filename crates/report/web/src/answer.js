// What was asked, and the answer in five numbers beside their limits.

import { el } from "./dom.js";
import { findingsOf } from "./findings.js";
import { levelMark, LEVELS, worstOf } from "./levels.js";
import { cellText } from "./sheet.js";
import { chosen, chosenAtRest, modelName } from "./solutions.js";
import { on, state } from "./state.js";
import { plain, quantity } from "./units.js";

export function asked(report) {
  const list = el("dl", { class: "asked" });
  const draw = () =>
    list.replaceChildren(
      ...report.asked.map(({ label, value }) => el("div", {}, el("dt", {}, label), el("dd", {}, cellText(value, value?.dimension === "length" ? 5 : 4, plain)))),
    );
  on("units", draw);
  draw();
  return list;
}

/** How much of a limit is used, in words that need no colour. */
function judged(part) {
  if (part > 1) return ["over", "over the limit"];
  if (part > 0.8) return ["near", "near the limit"];
  return ["within", "within the limit"];
}

/** What says that a number has findings of its own: a card may not look well beside an error of the same quantity. */
function flag(level, findings) {
  const few = findings.length === 1 ? "see the finding above" : `see the ${findings.length} findings above`;
  return el("p", { class: `flag level-${level}` }, levelMark(level), el("strong", {}, ` ${LEVELS[level][0]}`), `: ${few}`);
}

/** Quantities of which the least span of a chart says what is nothing: a hundredth of it. */
const NOTHING = { part: 0.01, of: ["force", "torque"] };

/** A cell in which what is nothing beside the quantity's usual size, such as a torque of 3 N·m, is 0. */
function sized(cell, report) {
  if (!NOTHING.of.includes(cell?.dimension)) return cell;
  const spans = report.time_plots.filter((plot) => plot.dimension === cell.dimension).map((plot) => plot.min_span);
  return Math.abs(cell.value) < NOTHING.part * Math.max(...spans) ? { ...cell, value: 0 } : cell;
}

function card(report, answer, beside, findings) {
  const mine = findings.filter((of) => answer.about.some((word) => of.kind.includes(word)));
  const level = worstOf(mine);
  const dimension = answer.value?.dimension;
  const children = [
    el("h3", {}, answer.label),
    el("p", { class: "number" }, cellText(sized(answer.value, report), dimension === "ratio" || dimension === "percent" ? 3 : 4)),
  ];
  if (answer.worst !== null && dimension)
    children.push(el("p", { class: "note" }, `mean; at most ${quantity(sized({ value: answer.worst, dimension }, report).value, dimension)}`));
  for (const { label, value } of answer.more) children.push(el("p", { class: "note" }, `${cellText(value, 4)} ${label}`));
  if (beside?.answer?.value?.dimension === dimension && dimension)
    children.push(el("p", { class: "note" }, `${beside.name} ${cellText(sized(beside.answer.value, report), 4)}`));
  if (level) children.push(flag(level, mine));
  const worst = answer.held ?? answer.worst ?? answer.value?.value;
  if (answer.limit !== null && Number.isFinite(worst)) {
    const part = worst / answer.limit;
    // Of a number that something is wrong with, a small part of the limit is no praise.
    const wrong = level === "error" || level === "warning";
    const [kind, words] = wrong && part <= 0.8 ? ["", "of the limit"] : judged(part);
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
          el("strong", {}, `${Math.round(part * 100)} %${wrong && part <= 0.8 ? "" : ","} ${words}`),
          el("br"),
          `${answer.limit_label} ${dimension === "percent" || dimension === "ratio" ? "" : quantity(answer.limit, dimension)}`,
        ),
      ),
    );
  } else children.push(el("p", { class: "note" }, answer.limit_label));
  return el("div", { class: `card answer${level ? ` has-${level}` : ""}` }, children);
}

export function answers(report) {
  const holder = el("div", {});
  const draw = () => {
    const all = chosen(report);
    const [main] = all;
    const rest = chosenAtRest(report);
    const beside = (answer) =>
      rest && rest !== main && { name: modelName(report, rest), answer: rest.answers.find((other) => other.label === answer.label) };
    const messages = all
      .filter((solved) => solved.message)
      .map((solved) => el("p", { class: "warning" }, `${modelName(report, solved)}: ${solved.message}`));
    holder.replaceChildren(
      ...messages,
      el(
        "div",
        { class: "answers" },
        main.answers.map((answer) => card(report, answer, beside(answer), findingsOf(report, state.operation))),
      ),
    );
  };
  on("units operation", draw);
  return { element: holder, redraw: draw };
}
