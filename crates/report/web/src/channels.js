// What the time history of a node shows.

/** What the chosen node may show: column of frames.parquet, name and dimension. */
export const NODE_CHANNELS = [
  ["contact_force_N", "Contact force of the node", "force"],
  ["tension_N", "Effective tension", "force"],
  ["torque_N_m", "Torque", "torque"],
  ["rotary_speed_rad_per_s", "Rotary speed", "rotary speed"],
  ["bending_moment_N_m", "Bending moment", "torque"],
  ["offset_high_m", "Offset to the high side", "diameter"],
  ["offset_right_m", "Offset to the right", "diameter"],
];
