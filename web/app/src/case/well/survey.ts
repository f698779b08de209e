// Stations as a case has them, and the changes that put them there.

import type { Change, Start, Stations, Table, Value } from "../../api/cases";
import type { Scalar } from "../kinds";
import { asTable } from "../values";
import { fromSi } from "../written";

/** Stations as rows of `well.stations`. */
export function stationRows(stations: Stations, cells: Scalar[]): Value[] {
  const [md, inclination, azimuth] = cells;
  if (!md || !inclination || !azimuth) return [];
  return stations.md_m.map((md_m, index) => [
    fromSi(md, md_m),
    fromSi(inclination, stations.inclination_rad[index] ?? 0),
    fromSi(azimuth, stations.azimuth_rad[index] ?? 0),
  ]);
}

/** The changes that put a survey into the case, in the place of the one that it has or of the file that it names. */
export function intoCase(values: Table, rows: Value[], tieIn: Start | null): Change[] {
  const well = asTable(values.well);
  const changes: Change[] = [];
  for (const key of ["survey", "survey_unit"]) if (Object.hasOwn(well, key)) changes.push({ remove: `well.${key}` });
  changes.push({ set: "well.stations", to: rows });
  // What the file said of its first station is said by the case then; what the case says holds.
  if (tieIn && !Object.hasOwn(well, "tie_in")) {
    const start = { north: `${tieIn.north_m} m`, east: `${tieIn.east_m} m`, tvd: `${tieIn.tvd_m} m` };
    changes.push({ set: "well.tie_in", to: start });
  }
  return changes;
}
