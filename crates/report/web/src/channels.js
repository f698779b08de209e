// What the time history of a node shows.

/** What the chosen node may show: column of frames.parquet, name, dimension, and the least span of its axis, SI. */
export const NODE_CHANNELS = [
  ["contact_force_N", "Contact force of the node", "force", 1000],
  ["tension_N", "Effective tension", "force", 2e4],
  ["torque_N_m", "Torque", "torque", 500],
  ["rotary_speed_rad_per_s", "Rotary speed", "rotary speed", 1],
  ["bending_moment_N_m", "Bending moment", "torque", 500],
  ["offset_high_m", "Offset to the high side", "diameter", 0.005],
  ["offset_right_m", "Offset to the right", "diameter", 0.005],
];
