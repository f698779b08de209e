// What is drawn in the tracks, in words; curves are hidden and shown there.

import { el, svg } from "../../../../web/components/dom.ts";
import { placedOf } from "./checks.js";
import { SEVERITIES } from "./severities.js";
import { curveId, curveName, look, readable } from "./solutions.js";
import { choose, state } from "./state.js";

/** What curves, bands and marks mean; `between` says whether curves between the joints are drawn. */
export function trackLegend(report, between) {
  const curves = report.solved.map((solved) => {
    const { colour, dash, shape, hollow } = look(report, solved);
    const id = curveId(solved);
    const hidden = state.hidden.has(id);
    const name = curveName(report, solved);
    return el(
      "button",
      {
        type: "button",
        class: "key",
        "aria-pressed": String(!hidden),
        title: hidden ? `Show ${name}` : `Hide ${name}`,
        onclick: () => {
          const next = new Set(state.hidden);
          if (!next.delete(id)) next.add(id);
          choose({ hidden: next });
          // What was drawn anew keeps the keyboard's place.
          document.querySelector(`.legend [data-curve="${id}"]`)?.focus();
        },
        "data-curve": id,
      },
      svg(
        "svg",
        { width: 30, height: 12 },
        svg("line", { x1: 1, x2: 29, y1: 6, y2: 6, stroke: colour, class: "curve", "stroke-dasharray": dash?.join(" ") }),
        shape &&
          svg("path", {
            d: shape,
            transform: "translate(15 6)",
            fill: hollow ? "var(--paper)" : colour,
            stroke: hollow ? colour : "var(--paper)",
            class: "marker",
          }),
      ),
      name,
    );
  });
  const found = [...new Set(placedOf(report).map((check) => check.severity))].reverse().map((level) =>
    el(
      "span",
      { class: "key" },
      svg(
        "svg",
        { width: 20, height: 12 },
        svg("rect", { width: 20, height: 12, class: `found level-${level}` }),
        svg("rect", { x: 15, width: 5, height: 12, class: `found-bar level-${level}` }),
      ),
      `${SEVERITIES[level][0].toLowerCase()} here, ${readable(state.operation)}`,
    ),
  );
  const band = report.runs.length
    ? [
        el(
          "span",
          { class: "key" },
          svg(
            "svg",
            { width: 26, height: 10 },
            svg("rect", { width: 26, height: 10, fill: "var(--muted)", class: "band" }),
          ),
          "5–95 % of the time",
        ),
      ]
    : [];
  const dotted = between
    ? [
        el(
          "span",
          { class: "key" },
          svg(
            "svg",
            { width: 30, height: 12 },
            svg("line", { x1: 1, x2: 29, y1: 6, y2: 6, stroke: "var(--muted)", class: "curve between" }),
          ),
          "between the joints",
        ),
      ]
    : [];
  const side = ["high", "low"].map((name) =>
    el(
      "span",
      { class: "key" },
      svg("svg", { width: 14, height: 10 }, svg("rect", { width: 14, height: 10, class: `${name}-side` })),
      `on the ${name} side`,
    ),
  );
  return [...curves, ...dotted, ...band, ...side, ...found];
}
