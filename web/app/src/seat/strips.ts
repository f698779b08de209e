// The strip charts of the driller's seat, from left to right.

import type { Layout } from "../api/live";
import type { Samples } from "./samples";
import type { Curve } from "./strip";

export interface StripPlan {
  title: string;
  dimension: string;
  /** Smallest range, SI. */
  least: number;
  curves: (Curve & { name: string })[];
  /** Limits of its first column, SI. */
  limits: { label: string; value: number }[];
  /** Whether it is hidden while it does not change. */
  optional: boolean;
}

type Knob = keyof Layout["knobs"];

interface Declared {
  title: string;
  least: number;
  curves: [string, string, boolean?][];
  /** The knob without which the quantity has no meaning in an operation. */
  needs?: Knob;
  optional?: boolean;
}

const DECLARED: Declared[] = [
  { title: "Hook load", least: 5000, curves: [["hook_load_N", "load"]] },
  { title: "Torque", least: 500, curves: [["surface_torque_N_m", "surface"], ["bit_torque_N_m", "bit"]], needs: "rotary_speed_rad_per_s" },
  {
    title: "Rotary speed", least: 1, needs: "rotary_speed_rad_per_s",
    curves: [["rotary_speed_rad_per_s", "surface"], ["bit_rotary_speed_rad_per_s", "bit"], ["rotary_speed_set_rad_per_s", "set", true]],
  },
  { title: "Weight on bit", least: 5000, curves: [["weight_on_bit_N", "weight"], ["weight_on_bit_set_N", "set", true]], needs: "weight_on_bit_N" },
  { title: "ROP", least: 2e-4, curves: [["rate_of_penetration_m_per_s", "rate"]], needs: "weight_on_bit_N", optional: true },
  { title: "Pump pressure", least: 1e5, curves: [["pump_pressure_Pa", "pressure"]], needs: "flow_rate_m3_per_s", optional: true },
  { title: "Block", least: 0.005, curves: [["block_velocity_m_per_s", "down"], ["block_velocity_set_m_per_s", "set", true]], optional: true },
];

/** The strips of the quantities that have a meaning in the operation of a layout. */
export function stripsOf(layout: Layout): StripPlan[] {
  const meant = DECLARED.filter(({ needs }) => needs === undefined || layout.knobs[needs] !== null);
  return meant.map(({ title, least, curves, optional = false }) => {
    const known = curves.map(([column, name, isSet]) => ({
      name,
      column: layout.samples.findIndex((channel) => channel.name === column),
      colour: "",
      isSet: isSet ?? false,
    }));
    let line = 0;
    for (const curve of known) curve.colour = curve.isSet ? "frame" : `line-${line++}`;
    const dimension = layout.samples[known[0]!.column]?.dimension ?? "ratio";
    const limits = layout.limits.filter(({ column }) => column === curves[0]![0]);
    return { title, dimension, least, optional, limits, curves: known.filter((curve) => curve.column >= 0) };
  });
}

/** Time without a change after which an optional chart is hidden, s. */
const STILL_S = 10;

/** A change of this part of the smallest range counts. */
const CHANGE = 0.02;

/** Whether the quantities of a chart have not changed in all samples that are kept, for some time. */
export function isStill({ curves, least }: StripPlan, samples: Samples): boolean {
  if ((samples.next - samples.first) * samples.interval_s < STILL_S) return false;
  return curves.every(({ column }) => {
    const values = samples.columns[column]!;
    let [low, high] = [Infinity, -Infinity];
    for (let number = samples.first; number < samples.next; number++) {
      const value = values[samples.place(number)]!;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    return !(high - low > CHANGE * least);
  });
}
