// What was asked, and the answer in five numbers beside their limits.

import { el } from "./dom.js";
import { cellText } from "./sheet.js";
import { chosen, modelName } from "./solutions.js";
import { on } from "./state.js";
import { quantity } from "./units.js";

export function asked(report) {
  const list = el("dl", { class: "asked" });
  const draw = () =>
    list.replaceChildren(
      ...report.asked.map(({ label, value }) => el("div", {}, el("dt", {}, label), el("dd", {}, cellText(value)))),
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

function card(answer, softAnswer) {
  const dimension = answer.value?.dimension;
  const children = [
    el("h3", {}, answer.label),
    el("p", { class: "number" }, cellText(answer.value, dimension === "ratio" || dimension === "percent" ? 3 : 4)),
  ];
  if (answer.worst !== null && dimension)
    children.push(el("p", { class: "note" }, `mean; at most ${quantity(answer.worst, dimension)}`));
  if (softAnswer?.value?.dimension === dimension && dimension)
    children.push(el("p", { class: "note" }, `soft string ${cellText(softAnswer.value, 4)}`));
  const worst = answer.worst ?? answer.value?.value;
  if (answer.limit !== null && Number.isFinite(worst)) {
    const part = worst / answer.limit;
    const [kind, words] = judged(part);
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
          el("strong", {}, `${Math.round(part * 100)} %, ${words}`),
          el("br"),
          `${answer.limit_label} ${dimension === "percent" || dimension === "ratio" ? "" : quantity(answer.limit, dimension)}`,
        ),
      ),
    );
  } else children.push(el("p", { class: "note" }, answer.limit_label));
  return el("div", { class: "card answer" }, children);
}

export function answers(report) {
  const holder = el("div", {});
  const draw = () => {
    const dynamic = chosen(report, "dynamic");
    const soft = chosen(report, "soft");
    const main = dynamic ?? soft;
    const same = (answer) => dynamic && soft?.answers.find((other) => other.label === answer.label);
    const messages = [dynamic, soft]
      .filter((solved) => solved?.message)
      .map((solved) => el("p", { class: "warning" }, `${modelName(solved.model)}: ${solved.message}`));
    holder.replaceChildren(
      ...messages,
      el(
        "div",
        { class: "answers" },
        main.answers.map((answer) => card(answer, same(answer))),
      ),
    );
  };
  on("units operation", draw);
  return { element: holder, redraw: draw };
}
