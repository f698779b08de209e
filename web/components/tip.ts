// Tooltip of a chart at the pointer: names and values.

import { el } from "./dom.ts";

/** A line of it: a colour, or none, and its text. */
export interface TipRow {
  colour?: string | null;
  text: string;
  class?: string | null;
}

const box = el("div", { class: "tip noprint", role: "status", hidden: true });

/** Displays a title and rows at the pointer. */
export function showTip(at: { clientX: number; clientY: number }, title: string, rows: readonly TipRow[]): void {
  if (!box.isConnected) document.body.append(box);
  box.replaceChildren(
    el("strong", {}, title),
    ...rows.map(({ colour, text, class: kind }) =>
      el("div", { class: kind }, colour && el("span", { class: "swatch", style: `background:${colour}` }), text),
    ),
  );
  box.hidden = false;
  const { width, height } = box.getBoundingClientRect();
  const left = at.clientX + 16 + width > innerWidth ? at.clientX - 16 - width : at.clientX + 16;
  const top = Math.min(at.clientY + 12, innerHeight - height - 4);
  box.style.left = `${Math.max(left, 4)}px`;
  box.style.top = `${Math.max(top, 4)}px`;
}

export const hideTip = (): void => {
  box.hidden = true;
};
