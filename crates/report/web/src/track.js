// What each track shows, and its curves.

import { largestNear, meanNear } from "./curve.js";

/** Half of the distance between joints, and a little: what touches or bends most within it counts for all of it, m. */
const JOINT_REACH_M = 6;

const TRACKS = [
  {
    title: "Effective tension",
    dimension: "force",
    column: "tension_N",
    band: ["tension_p05_N", "tension_p95_N"],
    zero: true,
  },
  { title: "Torque", dimension: "torque", column: "torque_N_m", band: ["torque_p05_N_m", "torque_p95_N_m"] },
  { title: "Side force", dimension: "force per length", column: "side_force_N_per_m", sides: true },
  {
    title: "In contact",
    dimension: "percent",
    column: "contact_fraction",
    touches: true,
    range: [0, 1.04],
    classes: true,
  },
  {
    title: "Bending moment",
    dimension: "torque",
    column: "bending_moment_N_m",
    band: ["bending_moment_p05_N_m", "bending_moment_p95_N_m"],
    swings: true,
  },
  { title: "Wear work, hole", dimension: "work per length", column: "wear_work_J_per_m", from: "wear" },
  { title: "Inclination", dimension: "angle", column: "inclination_rad", from: "well", zero: true },
  { title: "Dogleg severity", dimension: "dogleg severity", column: "dogleg_rad_per_m", from: "well", zero: true },
];

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
  TRACKS.map((track) => ({ ...track, curves: curvesOf(report, track) })).filter((track) => track.curves.length);
