// The strip charts of the driller's seat, from left to right.

import type { Layout } from "../api/live";
import type { Curve } from "./strip";

export interface StripPlan {
  title: string;
  dimension: string;
  /** Smallest range, SI. */
  least: number;
  curves: (Curve & { name: string })[];
}

const PLANS: [string, number, [string, string, boolean?][]][] = [
  ["Hook load", 5000, [["hook_load_N", "hook load"]]],
  ["Torque", 500, [["surface_torque_N_m", "surface"], ["bit_torque_N_m", "bit"]]],
  ["Rotary speed", 1, [["rotary_speed_rad_per_s", "top"], ["bit_rotary_speed_rad_per_s", "bit"], ["rotary_speed_set_rad_per_s", "set", true]]],
  ["Weight on bit", 5000, [["weight_on_bit_N", "weight"], ["weight_on_bit_set_N", "set", true]]],
  ["Rate of penetration", 2e-4, [["rate_of_penetration_m_per_s", "rate"]]],
  ["Standpipe pressure", 1e5, [["pump_pressure_Pa", "pressure"]]],
  ["Block", 0.005, [["block_velocity_m_per_s", "speed down"], ["block_velocity_set_m_per_s", "set", true]]],
];

/** The strips that a layout has the columns for. */
export function stripsOf(layout: Layout): StripPlan[] {
  // Without a rheology there is no pressure loss of the mud.
  const plans = PLANS.filter(([title]) => title !== "Standpipe pressure" || layout.knobs.flow_rate_m3_per_s !== null);
  return plans.map(([title, least, curves]) => {
    const known = curves.map(([column, name, isSet]) => ({
      name,
      column: layout.samples.findIndex((channel) => channel.name === column),
      colour: "",
      isSet: isSet ?? false,
    }));
    let line = 0;
    for (const curve of known) curve.colour = curve.isSet ? "frame" : `line-${line++}`;
    const dimension = layout.samples[known[0]!.column]?.dimension ?? "ratio";
    return { title, dimension, least, curves: known.filter((curve) => curve.column >= 0) };
  });
}
