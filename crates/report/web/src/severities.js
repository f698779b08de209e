// Severities of checks: a word and a shape for each.

import { el, svg } from "../../../../web/components/dom.ts";

/** From the most severe: word, and outline of the shape in a square of 16. */
export const SEVERITIES = {
  error: ["Error", "M5 1h6l4 4v6l-4 4h-6l-4-4v-6z"],
  warning: ["Warning", "M8 1.5L15.5 14.5H.5z"],
  note: ["Note", "M8 1.5a6.5 6.5 0 1 0 .01 0z"],
  ok: ["OK", "M8 1.5a6.5 6.5 0 1 0 .01 0z"],
};

/** The colour of a severity, which the style sheet declares for pages with and without a program. */
export const inkOf = (level) => `var(--severity-${level})`;
const RANK = Object.keys(SEVERITIES);
const SIGN = { error: "M5.5 5.5l5 5m0-5l-5 5", warning: "M8 6v4.2m0 1.6v.6", note: "M8 7v4.5m0-7v.6", ok: "M4.8 8.3l2.2 2.3 4.3-4.8" };

export const bySeverity = (a, b) => RANK.indexOf(a.severity) - RANK.indexOf(b.severity);

/** The highest severity of some checks; null of none. */
export const worstOf = (checks) => RANK.find((level) => checks.some((of) => of.severity === level)) ?? null;

/** The shape of a severity. */
export function severityMark(level) {
  const [word, outline] = SEVERITIES[level];
  return svg(
    "svg",
    { class: "level-mark", viewBox: "0 0 16 16", width: 15, height: 15, role: "img", "aria-label": word },
    svg("path", { d: outline, fill: inkOf(level) }),
    svg("path", { d: SIGN[level], stroke: "var(--paper)", "stroke-width": 1.8, fill: "none" }),
  );
}

/** `2 errors, 1 warning` */
export function countText(checks) {
  return RANK.flatMap((level) => {
    const count = checks.filter((of) => of.severity === level).length;
    return count ? [`${count} ${SEVERITIES[level][0].toLowerCase()}${count > 1 ? "s" : ""}`] : [];
  }).join(", ");
}

/** The same with shapes. */
export const countMarks = (checks) =>
  RANK.flatMap((level) => {
    const count = checks.filter((of) => of.severity === level).length;
    return count ? [el("span", { class: `count level-${level}` }, severityMark(level), String(count))] : [];
  });
