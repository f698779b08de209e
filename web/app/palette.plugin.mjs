// The colours of the page, from their declaration in the program: `import "virtual:palette.css"`.
import { readFileSync } from "node:fs";

const DECLARED = new URL("../../crates/report/src/draw/palette.rs", import.meta.url);
const LINE = /^\s*colour\("([\w-]+)", 0x([0-9a-f]{6}), 0x([0-9a-f]{6})\),$/gm;

/** Custom properties, light and dark. */
export function paletteCss() {
  const colours = [...readFileSync(DECLARED, "utf8").matchAll(LINE)];
  if (colours.length < 20) throw new Error(`${DECLARED.pathname} declares ${colours.length} colours: has its form changed?`);
  const properties = (place) => colours.map((colour) => `--${colour[1]}:#${colour[place]};`).join("");
  return `:root{${properties(2)}color-scheme:light}\n:root[data-theme=dark]{${properties(3)}color-scheme:dark}\n`;
}

/** The plugin of Vite. */
export const palette = () => ({
  name: "palette",
  resolveId: (id) => (id === "virtual:palette.css" ? "\0palette.css" : null),
  load: (id) => (id === "\0palette.css" ? paletteCss() : null),
});
