// The curves of each track.

import { largestNear, rowOfLargest } from "../../../../web/components/curve.ts";
import { curveId } from "./solutions.js";
import { state } from "./state.js";

const negative = (values) => values.map((value) => -value);

/**
 * A curve that swings from joint to joint as it is from afar: its values at the joints, with their own band, and the least
 * of what lies between them where that is seen beside it.
 */
function fromAfar({ depths, values, low, high }, { joint_reach_m, min_difference }) {
  const joints = rowOfLargest(depths, values, joint_reach_m);
  const atJoints = (column) => column && Float32Array.from(joints, (row) => column[row]);
  const far = { values: atJoints(values), low: atJoints(low), high: atJoints(high) };
  const between = negative(largestNear(depths, negative(values), joint_reach_m));
  const most = far.values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const visible = between.some((value, i) => Math.abs(value - far.values[i]) > min_difference * most);
  return visible ? { ...far, between } : far;
}

/** Depths and values of a track's curves, with who drew them. */
function curvesOf(report, track) {
  if (track.from === "well") {
    const values = report.well[track.column];
    return values.length ? [{ depths: report.well.md_m, values, well: true }] : [];
  }
  return report.solved.flatMap((solved) => {
    const table = track.from === "wear" ? solved.wear : solved.profile;
    const values = table[track.column];
    if (!values) return [];
    const depths = table.md_m;
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
