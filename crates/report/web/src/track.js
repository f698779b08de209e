// The curves of each track.

import { largestNear } from "../../../../web/components/curve.ts";
import { fromAfar } from "../../../../web/components/from_afar.ts";
import { curveId } from "./solutions.js";
import { state } from "./state.js";

/** Depths and values of a track's curves, with who drew them. */
function curvesOf(report, track) {
  if (track.from === "well") {
    const values = report.well[track.column];
    return values?.length ? [{ depths: report.well.md_m, values, well: true }] : [];
  }
  return report.solved.flatMap((solved) => {
    const table = track.from === "wear" ? solved.wear : solved.profile;
    const values = table[track.column];
    const depths = table.md_m;
    if (!values || !depths) return [];
    const [low, high] = (track.band ?? []).map((name) => table[name]);
    const curve = { solved, depths, values, low, high };
    if (track.touches) curve.values = largestNear(depths, values, report.rules.joint_reach_m);
    if (track.swings) curve.far = fromAfar(curve, report.rules);
    return [curve];
  });
}

/** The tracks of a report that have anything to show, with their curves. */
export const tracksOf = (report) =>
  report.tracks.map((track) => ({ ...track, curves: curvesOf(report, track) })).filter((track) => track.curves.length);

/** A value of a track in which what is nothing beside its least span, such as rounding, is 0. */
export const sized = (track, value) => (Math.abs(value) < 1e-4 * track.min_span ? 0 : value);

/** Whether the reader wants to see a curve. */
export const isShown = (curve) => curve.well || !state.hidden.has(curveId(curve.solved));

/** The curves of a track that are seen between two depths, as they are from so far. */
export function drawnOf(report, track, [from, to]) {
  const far = to - from > report.rules.far_m;
  return track.curves.filter(isShown).map((curve) => (far && curve.far ? { ...curve, ...curve.far } : curve));
}
