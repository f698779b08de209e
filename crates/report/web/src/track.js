// The curves of each track.

import { largestNear, meanNear } from "./curve.js";

/** Half of the distance between joints, and a little: what touches or bends most within it counts for all of it, m. */
const JOINT_REACH_M = 6;

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
    if (track.touches) curve.values = largestNear(depths, values, JOINT_REACH_M);
    // Bending swings from joint to joint: from afar, what it swings about and how far.
    if (track.swings)
      curve.far = {
        values: meanNear(depths, values, JOINT_REACH_M),
        low:
          low &&
          largestNear(
            depths,
            low.map((v) => -v),
            JOINT_REACH_M,
          ).map((v) => -v),
        high: high && largestNear(depths, high, JOINT_REACH_M),
      };
    return [curve];
  });
}

/** The tracks of a report that have anything to show, with their curves. */
export const tracksOf = (report) =>
  report.tracks.map((track) => ({ ...track, curves: curvesOf(report, track) })).filter((track) => track.curves.length);
