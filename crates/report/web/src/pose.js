// Where the string lies in the hole, and what colours it: at a moment where frames were kept, on average otherwise.

import { below, valueAt } from "../../../../web/components/curve.ts";
import { chosen, hasProfile } from "./solutions.js";

/** The string as the mean over the window has it; as the equilibrium has it where that is all. */
function meanPose(report, solved) {
  const { profile } = solved;
  const depths = profile.md_m;
  const offset = profile.lateral_offset_m ?? lying(report, profile);
  const angle = climbs(profile);
  return {
    depths,
    high: offset.map((value, i) => -value * Math.cos(angle[i])),
    right: offset.map((value, i) => value * Math.sin(angle[i])),
    values: (name) => profile[name],
    has: (name) => Boolean(profile[name]) && name !== "contact_force_N",
  };
}

/** A string in equilibrium lies on the wall, on the side of its side force. */
function lying(report, profile) {
  return profile.md_m.map((depth) => {
    const within = (part) => depth >= part.from_m && depth <= part.to_m;
    const section = report.hole.find(within);
    const part = report.string.find(within);
    return section && part ? (section.diameter_m - part.contact_od_m) / 2 : 0;
  });
}

/** The angle from the low side: of the contact force where the node touches, of its neighbours where it does not. */
function climbs(profile) {
  const known = [];
  for (let i = 0; i < profile.md_m.length; i++) {
    const climb = profile.climb_rad?.[i];
    if (Number.isFinite(climb)) known.push([profile.md_m[i], Math.cos(climb), Math.sin(climb)]);
    else if (!profile.climb_rad && Number.isFinite(profile.side_force_N_per_m?.[i]) && profile.side_force_N_per_m[i] !== 0)
      known.push([profile.md_m[i], profile.side_force_N_per_m[i] > 0 ? -1 : 1, 0]);
  }
  if (known.length === 0) return profile.md_m.map(() => 0);
  const columns = [0, 1, 2].map((k) => Float32Array.from(known, (row) => row[k]));
  const near = (depth, column) => {
    const value = valueAt(columns[0], column, Math.min(Math.max(depth, columns[0][0]), columns[0].at(-1)));
    return Number.isFinite(value) ? value : 0;
  };
  return profile.md_m.map((depth) => Math.atan2(near(depth, columns[2]), near(depth, columns[1])));
}

/** The string at a frame. */
function framePose(frames, k) {
  const nodes = frames.md_m.length;
  const slice = (name) => frames.channels[name].subarray(k * nodes, (k + 1) * nodes);
  return {
    depths: frames.md_m.map((depth) => depth + frames.moved_m[k]),
    high: slice("offset_high_m"),
    right: slice("offset_right_m"),
    values: slice,
    has: (name) => Boolean(frames.channels[name]),
  };
}

/** The pose of the chosen operation; `k` is the frame, or null for the mean. None where no model has an answer. */
export function poseOf(report, run, k) {
  if (run?.frames && k !== null) return framePose(run.frames, k);
  const solved = chosen(report).find(hasProfile);
  return solved ? meanPose(report, solved) : null;
}

/** The quantities that can colour the string. */
export const quantitiesOf = (report, pose) => report.string_colours.filter(({ column }) => pose.has(column));

/** The range of a quantity over all that may be shown of it, so that colours mean the same at all times. */
export function rangeOf(pose, run, k, name, signed) {
  const all = (run?.frames && k !== null ? run.frames.channels[name] : pose.values(name)) ?? [];
  const finite = Array.from(all)
    .filter(Number.isFinite)
    .sort((a, b) => a - b);
  if (finite.length === 0) return [0, 1];
  const at = (part) => finite[Math.round(part * (finite.length - 1))];
  if (signed) {
    const size = Math.max(Math.abs(at(0.01)), Math.abs(at(0.99))) || 1;
    return [-size, size];
  }
  const [low, high] = [at(0.002), at(0.998)];
  return low < high ? [low, high] : [low - 0.5 * Math.abs(low || 1), high + 0.5 * Math.abs(high || 1)];
}

/** The frame that is nearest in time. */
export function frameAt(frames, time) {
  const next = Math.min(Math.max(below(frames.time_s, time), 1), frames.time_s.length - 1);
  if (next < 1) return 0;
  return time - frames.time_s[next - 1] < frames.time_s[next] - time ? next - 1 : next;
}
