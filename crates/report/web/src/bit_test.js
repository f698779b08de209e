// The page of a bit test: what the bit did at each weight and speed, and the bottoms that it left.

import { asked } from "./answer.js";
import { bottomView } from "./bottom.js";
import { el, select } from "./dom.js";
import { licences } from "./footer.js";
import { header } from "./header.js";
import { sheet } from "./sheet.js";
import { on, state } from "./state.js";
import { quantity } from "./units.js";

const section = (id, title, ...children) => el("section", { id }, el("h2", {}, title), children);

/** A figure that the page holds in each set of units; none where it has none. */
function figure(name) {
  const holder = el("div", { class: "figure-holder" });
  const draw = () => {
    const template = document.getElementById(`${name}-${state.units}`);
    holder.replaceChildren(...(template ? [template.content.cloneNode(true)] : ["No point was finished."]));
  };
  on("units", draw);
  draw();
  return holder;
}

/** Shows a bit test. */
export function bitTestPage(report) {
  const { bottoms } = report;
  let chosen = bottoms.length - 1;
  const bottom = bottoms.length ? bottomView(() => bottoms[chosen].bottom, false) : null;
  const chooser = el("div", { class: "tools noprint" });
  const told = el("p", { class: "note" });
  const name = ({ weight_N, rotary_rad_per_s }) =>
    `${quantity(weight_N, "force", 3)} at ${quantity(rotary_rad_per_s, "rotary speed", 3)}`;
  const offer = () => {
    const options = bottoms.map((of, i) => [String(i), name(of)]);
    chooser.replaceChildren(
      select("Point: ", options, String(chosen), (value) => {
        chosen = Number(value);
        tell();
        bottom.redraw();
      }),
    );
    tell();
  };
  const tell = () => (told.textContent = `After ${name(bottoms[chosen])}.`);
  const [points, ...inputs] = report.sheets;
  const page = document.getElementById("page");
  page.append(
    header(report.title, asked(report), () => bottom?.redraw()),
    ...(report.message ? [el("p", { class: "warning" }, report.message)] : []),
    section("drill-off", "Drill-off", figure("drill-off")),
    section("energy", "Specific energy", figure("specific-energy")),
  );
  if (bottom) {
    offer();
    on("units", offer);
    page.append(section("bottom", "Bottom of the hole", chooser, bottom.element, told));
  }
  page.append(
    el("section", { id: "points" }, sheet(points)),
    ...(inputs.length ? [section("inputs", "Inputs, defaults included", inputs.map(sheet))] : []),
    el(
      "footer",
      {},
      el("p", {}, `Made by ${report.program}. The tables beside this file hold every digit.`),
      licences(),
    ),
  );
  bottom?.redraw();
}
