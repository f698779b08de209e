// A curve that swings from joint to joint, seen from afar.

import { largestNear, rowOfLargest } from "./curve.ts";
import type { TrackCurve } from "./track.ts";

/** How far joints are apart, m, and from which part of the largest value on a difference is seen. */
export interface SwingRule {
  joint_reach_m: number;
  min_difference: number;
}

const negative = (values: ArrayLike<number>): Float32Array => Float32Array.from(values, (value) => -value);

/**
 * What is drawn of a curve from afar: its values at the joints, with their own band, and the least of what lies between
 * them where that is seen beside it.
 */
export function fromAfar({ depths, values, low, high }: TrackCurve, rule: SwingRule): Omit<TrackCurve, "depths"> {
  const { joint_reach_m, min_difference } = rule;
  const joints = rowOfLargest(depths, values, joint_reach_m);
  const atJoints = (column: ArrayLike<number>): Float32Array => Float32Array.from(joints, (row) => column[row] ?? NaN);
  const far = { values: atJoints(values), low: low && atJoints(low), high: high && atJoints(high) };
  const between = negative(largestNear(depths, negative(values), joint_reach_m));
  const most = far.values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const visible = between.some((value, i) => Math.abs(value - (far.values[i] ?? NaN)) > min_difference * most);
  return visible ? { ...far, between } : far;
}
