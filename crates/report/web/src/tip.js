// What a chart says beside the pointer: names and values.

import { el } from "./dom.js";

const box = el("div", { class: "tip noprint", role: "status", hidden: true });

/** Shows a title and rows beside the pointer; each row has a colour, or none, and its text. */
export function showTip(event, title, rows) {
  if (!box.isConnected) document.body.append(box);
  box.replaceChildren(
    el("strong", {}, title),
    ...rows.map(({ colour, text, class: kind }) =>
      el("div", { class: kind }, colour && el("span", { class: "swatch", style: `background:${colour}` }), text),
    ),
  );
  box.hidden = false;
  const { width, height } = box.getBoundingClientRect();
  const left = event.clientX + 16 + width > innerWidth ? event.clientX - 16 - width : event.clientX + 16;
  const top = Math.min(event.clientY + 12, innerHeight - height - 4);
  box.style.left = `${Math.max(left, 4)}px`;
  box.style.top = `${Math.max(top, 4)}px`;
}

export const hideTip = () => (box.hidden = true);
