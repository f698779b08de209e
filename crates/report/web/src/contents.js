// Where one finds what on the page.

import { el } from "../../../../web/components/dom.ts";

/** Links to the sections of a page; `redraw` leaves out those that are hidden. */
export function contents(sections) {
  const links = sections.map((section) => [
    section,
    el("a", { href: `#${section.id}` }, section.querySelector("h2").firstChild.textContent),
  ]);
  const element = el("nav", { class: "contents noprint", "aria-label": "Contents" }, links.map(([, link]) => link));
  const redraw = () => links.forEach(([section, link]) => link.toggleAttribute("hidden", section.hidden));
  redraw();
  return { element, redraw };
}
