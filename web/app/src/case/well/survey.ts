// Stations in the form of a case, and the changes that write them.

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

/** The changes that write a survey into the case, in place of the present one or of the file. */
export function intoCase(values: Table, rows: Value[], tieIn: Start | null): Change[] {
  const well = asTable(values.well);
  const changes: Change[] = [];
  for (const key of ["survey", "survey_unit"]) if (Object.hasOwn(well, key)) changes.push({ remove: `well.${key}` });
  changes.push({ set: "well.stations", to: rows });
  // The position of the first station from the file is written into the case, unless the case has one.
  if (tieIn && !Object.hasOwn(well, "tie_in")) {
    const start = { north: `${tieIn.north_m} m`, east: `${tieIn.east_m} m`, tvd: `${tieIn.tvd_m} m` };
    changes.push({ set: "well.tie_in", to: start });
  }
  return changes;
}
