// The read-outs of the top row: quantities, and the kinds of alarms that concern each.

import type { Layout, Status } from "../api/live";
import type { Check, Severity } from "../api/answers";
import type { CheckKind } from "../api/types";

export interface Readout {
  key: string;
  label: string;
  dimension: string;
  /** Decimals of a depth; other numbers have four digits. */
  decimals?: number;
  /** Columns of the samples: value, and a second one with its word. */
  column: string | null;
  second?: [string, string];
  /** Knob without which the quantity has no meaning in an operation. */
  needs?: keyof Layout["knobs"];
  kinds: CheckKind[];
}

export const READOUTS: Readout[] = [
  { key: "bit", label: "Bit depth", dimension: "length", decimals: 2, column: "bit_depth_m", kinds: [] },
  { key: "hole", label: "Hole depth", dimension: "length", decimals: 2, column: null, kinds: [] },
  { key: "hook", label: "Hook load", dimension: "force", column: "hook_load_N", kinds: ["hoist", "tension", "goes_down"] },
  {
    key: "weight", label: "Weight on bit", dimension: "force", column: "weight_on_bit_N", second: ["weight_on_bit_set_N", "set"], needs: "weight_on_bit_N",
    kinds: ["weight_not_available", "weight_on_bit_not_reached", "weight_on_bit_exceeded", "helical_buckling"],
  },
  {
    key: "torque", label: "Torque", dimension: "torque", column: "surface_torque_N_m", second: ["bit_torque_N_m", "bit"],
    kinds: ["torsion", "tension_and_torsion", "make_up", "top_drive", "top_drive_peak", "top_drive_stalled", "top_drive_at_limit"],
  },
  {
    key: "speed", label: "Rotary speed", dimension: "rotary speed", column: "rotary_speed_rad_per_s", second: ["bit_rotary_speed_rad_per_s", "bit"],
    needs: "rotary_speed_rad_per_s", kinds: ["stick_slip", "backward_whirl", "forward_whirl"],
  },
  { key: "rate", label: "ROP", dimension: "rate of penetration", column: "rate_of_penetration_m_per_s", needs: "weight_on_bit_N", kinds: [] },
  { key: "pressure", label: "Pump pressure", dimension: "pressure", column: "pump_pressure_Pa", needs: "flow_rate_m3_per_s", kinds: ["pump_pressure"] },
];

/** The read-outs that have a meaning in the operation of a layout. */
export const readoutsOf = (layout: Layout): Readout[] =>
  READOUTS.filter(({ needs }) => needs === undefined || layout.knobs[needs] !== null);

/** Severity of the first alarm of some kinds: the server gives the most severe first. */
export const severityOf = (alarms: Status["alarms"], kinds: CheckKind[]): Severity | null =>
  alarms.find((alarm: Check) => kinds.includes(alarm.kind))?.severity ?? null;
