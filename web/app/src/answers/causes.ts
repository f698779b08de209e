// Keys of the case that a check depends on most.

import type { Answer, Check } from "../api/answers";

/** Keys of the kinds of checks that depend on one value. */
const KEYS: Partial<Record<Check["kind"], string>> = {
  hoist: "rig.hoist_capacity",
  top_drive: "rig.top_drive_torque",
  top_drive_peak: "rig.top_drive_peak_torque",
  breakaway: "rig.top_drive_torque",
  pump_pressure: "rig.pump_pressure_limit",
  overpull: "plan.overpull",
  side_force: "plan.side_force_per_joint",
  weight_not_available: "operation.wob",
  weight_on_bit_not_reached: "operation.wob",
};

/** Kinds that depend on the friction of the deepest section of the hole. */
const BY_FRICTION: readonly Check["kind"][] = ["goes_down", "lock_up", "no_equilibrium", "reach"];

/** The key of the component at the depth of a check, or of the friction or the limit that it depends on. */
export function causeOf({ kind, component, md_m }: Check, answer: Answer | null): string {
  const own = KEYS[kind];
  if (own) return own;
  const { hole = [], string = [] } = answer?.well ?? {};
  if (BY_FRICTION.includes(kind)) return `well.hole.${Math.max(hole.length - 1, 0)}.friction`;
  // The case lists components from the bit up.
  const place = string.findIndex((part) => part.name === component && (md_m === null || md_m <= part.to_m + 1e-6));
  return place < 0 ? "operation" : `string.${string.length - 1 - place}`;
}
