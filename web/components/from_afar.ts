// A curve that oscillates from joint to joint, at small scale.

import { largestNear, rowOfLargest } from "./curve.ts";
import type { TrackCurve } from "./track.ts";

/** Distance between joints, m, and smallest visible difference as a part of the largest value. */
export interface SwingRule {
  joint_reach_m: number;
  min_difference: number;
}

const negative = (values: ArrayLike<number>): Float32Array => Float32Array.from(values, (value) => -value);

/**
 * The form of a curve at small scale: its values at the joints with their own band, and the smallest values between
 * them if they can be distinguished.
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
