// Figures and tables as files: SVG with the colours that the page has now, CSV in the reader's units.

import { el } from "../../../../web/components/dom.ts";

/** Gives the reader a file. */
export function save(name, content, type) {
  const address = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  const link = el("a", { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** A name for a file: `Hook load, without block` becomes `hook-load-without-block`. */
export const slug = (title) =>
  title
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, "-")
    .replace(/^-|-$/g, "") || "figure";

/** A cell of CSV (RFC 4180). What a spreadsheet would take for a formula is marked by an apostrophe. */
function field(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return "";
  if (typeof value === "number") return String(Number(value.toPrecision(9)));
  const text = /^[=+@\t\r]|^-(?![\d.])/.test(value) ? `'${value}` : value;
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Heads and rows as the text of a CSV file. */
export const csv = (heads, rows) => [heads, ...rows].map((row) => Array.from(row, field).join(",")).join("\r\n") + "\r\n";

/** What a picture takes from the page's looks. */
const LOOKS = [
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "stroke-linejoin",
  "opacity",
  "font-family",
  "font-size",
  "font-weight",
  "text-anchor",
  "paint-order",
];

/** Pictures of the page, one below the other, as the text of an SVG file that needs no page. */
export function svgFile(pictures) {
  const sizes = pictures.map((picture) => picture.viewBox.baseVal);
  const width = Math.max(...sizes.map((size) => size.width));
  const height = sizes.reduce((sum, size) => sum + size.height, 0);
  let top = 0;
  const paper = getComputedStyle(document.documentElement).getPropertyValue("--paper");
  const body = pictures.map((picture, i) => {
    const copy = picture.cloneNode(true);
    const originals = [picture, ...picture.querySelectorAll("*")];
    [copy, ...copy.querySelectorAll("*")].forEach((element, k) => {
      const style = getComputedStyle(originals[k]);
      if (style.visibility === "hidden" || style.display === "none") return element.setAttribute("display", "none");
      element.removeAttribute("style");
      for (const look of LOOKS) {
        const value = style.getPropertyValue(look);
        if (value) element.setAttribute(look, value);
      }
    });
    const { width, height } = sizes[i];
    for (const [name, value] of Object.entries({ x: 0, y: top, width, height })) copy.setAttribute(name, value);
    top += height;
    return new XMLSerializer().serializeToString(copy);
  });
  return (
    `<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
    `viewBox="0 0 ${width} ${height}">\n<rect width="100%" height="100%" fill="${paper}"/>\n${body.join("\n")}\n</svg>\n`
  );
}

/**
 * Buttons that give what is shown under a title as files: `svg` and `csv` give their text, `png` a canvas. The title may be
 * a function.
 */
export function downloads(title, { svg, csv, png }) {
  const name = () => slug(typeof title === "function" ? title() : title);
  const button = (ending, act) =>
    el(
      "button",
      { type: "button", class: "download", title: `Download as ${ending}`, "data-download": ending.toLowerCase(), onclick: act },
      ending,
    );
  return el(
    "span",
    { class: "downloads noprint" },
    svg && button("SVG", () => save(`${name()}.svg`, svg(), "image/svg+xml")),
    png && button("PNG", () => png().toBlob((blob) => save(`${name()}.png`, blob))),
    csv && button("CSV", () => save(`${name()}.csv`, csv(), "text/csv")),
  );
}
