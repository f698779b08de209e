// The page of a bit test: what the bit did at each weight and speed, and the bottoms that it left.

import { el, select } from "../../../../web/components/dom.ts";
import { quantity } from "../../../../web/components/units.ts";
import { facts } from "./key_results.js";
import { bottomView } from "./bottom.js";
import { contents } from "./contents.js";
import { downloads } from "./downloads.js";
import { figure } from "./figure.js";
import { licences } from "./footer.js";
import { header } from "./header.js";
import { pageTable, tableDownloads } from "./page_table.js";
import { on } from "./state.js";

const section = (id, title, ...children) => el("section", { id }, el("h2", {}, title), children);

/** A section with a figure that the page holds. */
function drawn(id, title, name) {
  const { element, file, there } = figure(name, "No point was finished.");
  return section(id, [title, downloads(title, { svg: there() ? file : null })], element);
}

/** Shows a bit test. */
export function bitTestPage(report) {
  const { bottoms } = report;
  let chosen = bottoms.length - 1;
  const bottom = bottoms.length ? bottomView(() => bottoms[chosen].bottom, false) : null;
  const chooser = el("div", { class: "tools noprint" });
  const caption = el("p", { class: "note" });
  const name = ({ weight_N, rotary_rad_per_s }) =>
    `${quantity(weight_N, "force", 3)} at ${quantity(rotary_rad_per_s, "rotary speed", 3)}`;
  const offer = () => {
    const options = bottoms.map((of, i) => [String(i), name(of)]);
    chooser.replaceChildren(
      select("Point: ", options, String(chosen), (value) => {
        chosen = Number(value);
        describe();
        bottom.redraw();
      }),
    );
    describe();
  };
  const describe = () => (caption.textContent = `After ${name(bottoms[chosen])}.`);
  const [points, ...inputs] = report.page_tables;
  const page = document.getElementById("page");
  page.append(
    header(report.title, facts(report), () => bottom?.redraw()),
    ...(report.message ? [el("p", { class: "warning" }, report.message)] : []),
    drawn("drill-off", "Drill-off", "drill-off"),
    drawn("energy", "Specific energy", "specific-energy"),
  );
  if (bottom) {
    offer();
    on("units", offer);
    page.append(section("bottom", "Bottom of the hole", chooser, bottom.element, caption));
  }
  page.append(
    section("points", ["Points", tableDownloads(points)], pageTable(points)),
    ...(inputs.length ? [section("inputs", "Inputs, defaults included", inputs.map(pageTable))] : []),
    el(
      "footer",
      {},
      el("p", {}, `Made by ${report.program}. The tables beside this file hold every digit.`),
      licences(),
    ),
  );
  page.querySelector("header").after(contents([...page.querySelectorAll("section:has(h2)")]).element);
  bottom?.redraw();
}
