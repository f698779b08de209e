// Quantities of a frame for the profiles and for the colours in space.

import type { Layout } from "../api/live";
import type { Frame } from "./connection.svelte";
import type { ValueAt } from "./profile";

export interface Quantity {
  key: string;
  title: string;
  dimension: string;
  value: ValueAt;
  signed: boolean;
  colour: string;
  /** Smallest range, SI. */
  least: number;
}

/** Offset below which a node does not whirl, m, as in the summary of a run. */
const SMALLEST_WHIRL_M = 1e-4;

/** The quantities of the frames of a layout. */
export function quantitiesOf(layout: Layout): Quantity[] {
  const place = (name: string) => layout.frame.findIndex((channel) => channel.name === name);
  const column = (name: string): ValueAt => {
    const k = place(name);
    return (frame, node) => frame.values[k * frame.nodes + node]!;
  };
  const [md, contact] = [place("md_m"), place("contact_force_N")];
  const sideForce: ValueAt = ({ values, nodes }: Frame, node: number) => {
    const above = values[md * nodes + Math.max(node - 1, 0)]!;
    const below = values[md * nodes + Math.min(node + 1, nodes - 1)]!;
    return values[contact * nodes + node]! / Math.max(0.5 * (below - above), 1e-3);
  };
  const [high, right] = [column("offset_high_m"), column("offset_right_m")];
  const [upwards, sideways] = [column("velocity_high_m_per_s"), column("velocity_right_m_per_s")];
  // Clockwise looking down the hole, from the high side to the right, is positive.
  const whirl: ValueAt = (frame, node) => {
    const [x, y] = [high(frame, node), right(frame, node)];
    const square = x * x + y * y;
    if (square < SMALLEST_WHIRL_M * SMALLEST_WHIRL_M) return 0;
    return (x * sideways(frame, node) - y * upwards(frame, node)) / square;
  };
  const quantity = (
    key: string, title: string, dimension: string, value: ValueAt, signed: boolean, colour: string, least: number,
  ): Quantity => ({ key, title, dimension, value, signed, colour, least });
  return [
    quantity("torque", "Torque", "torque", column("torque_N_m"), false, "line-1", 100),
    quantity("tension", "Tension", "force", column("tension_N"), false, "line-0", 1000),
    quantity("side_force", "Side force", "force per length", sideForce, true, "line-2", 10),
    quantity("rotary_speed", "Rotary speed", "rotary speed", column("rotary_speed_rad_per_s"), false, "line-3", 0.5),
    quantity("whirl", "Circling", "rotary speed", whirl, true, "line-4", 1),
  ];
}
