// How grave findings are: a word, a shape and a colour for each level.

import { el, svg } from "../../../../web/components/dom.ts";

/** From the gravest: word, colour of the page, outline of the shape in a square of 16. */
export const LEVELS = {
  error: ["Error", "over", "M5 1h6l4 4v6l-4 4h-6l-4-4v-6z"],
  warning: ["Warning", "near", "M8 1.5L15.5 14.5H.5z"],
  note: ["Note", "accent", "M8 1.5a6.5 6.5 0 1 0 .01 0z"],
};
const RANK = Object.keys(LEVELS);
const SIGN = { error: "M5.5 5.5l5 5m0-5l-5 5", warning: "M8 6v4.2m0 1.6v.6", note: "M8 7v4.5m0-7v.6" };

export const byLevel = (a, b) => RANK.indexOf(a.level) - RANK.indexOf(b.level);

/** The gravest level of some findings; null of none. */
export const worstOf = (findings) => RANK.find((level) => findings.some((of) => of.level === level)) ?? null;

/** The shape of a level. */
export function levelMark(level) {
  const [word, ink, outline] = LEVELS[level];
  return svg(
    "svg",
    { class: "level-mark", viewBox: "0 0 16 16", width: 15, height: 15, role: "img", "aria-label": word },
    svg("path", { d: outline, fill: `var(--${ink})` }),
    svg("path", { d: SIGN[level], stroke: "var(--paper)", "stroke-width": 1.8, fill: "none" }),
  );
}

/** `2 errors, 1 warning` */
export function countText(findings) {
  return RANK.flatMap((level) => {
    const count = findings.filter((of) => of.level === level).length;
    return count ? [`${count} ${LEVELS[level][0].toLowerCase()}${count > 1 ? "s" : ""}`] : [];
  }).join(", ");
}

/** The same with shapes. */
export const countMarks = (findings) =>
  RANK.flatMap((level) => {
    const count = findings.filter((of) => of.level === level).length;
    return count ? [el("span", { class: `count level-${level}` }, levelMark(level), String(count))] : [];
  });
