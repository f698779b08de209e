// The units of this page: those that the reader chose last, or else its own.

import { UNIT_SETS, useDimensions } from "../../../../web/components/units.ts";
import { remember, remembered } from "./memory.js";
import { on, state } from "./state.js";

export function usePageUnits(table, own) {
  state.units = remembered("units", UNIT_SETS) ?? own;
  useDimensions(table, () => state.units);
  on("units", () => remember("units", state.units));
}
