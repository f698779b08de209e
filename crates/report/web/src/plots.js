// What the time histories show.

/** Plots by what they show: columns of time.parquet with a name, and the soft string's number beside them. */
export const PLOTS = [
  { title: "Hook load", dimension: "force", columns: [["hook_load_N", "hook load"]], soft: ["tension_N", 0] },
  {
    title: "Torque",
    dimension: "torque",
    columns: [
      ["surface_torque_N_m", "surface"],
      ["friction_torque_N_m", "friction"],
      ["bit_torque_N_m", "bit"],
    ],
    soft: ["torque_N_m", 0],
  },
  {
    title: "Weight on bit",
    dimension: "force",
    columns: [
      ["weight_on_bit_N", "on bit"],
      ["weight_on_bit_set_N", "set"],
    ],
  },
  {
    title: "Rotary speed",
    dimension: "rotary speed",
    columns: [
      ["rotary_speed_rad_per_s", "top"],
      ["bit_rotary_speed_rad_per_s", "bit"],
      ["rotary_speed_set_rad_per_s", "set"],
    ],
  },
  {
    title: "Block velocity, down",
    dimension: "speed",
    columns: [
      ["block_velocity_m_per_s", "block"],
      ["block_velocity_set_m_per_s", "set"],
    ],
  },
  { title: "Axial friction", dimension: "force", columns: [["axial_friction_N", "along the string"]] },
  {
    title: "Neutral point and cut-off depth",
    dimension: "length",
    columns: [
      ["neutral_point_m", "neutral point"],
      ["cutoff_depth_m", "cut-off depth"],
    ],
    points: true,
    down: true,
  },
];

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
