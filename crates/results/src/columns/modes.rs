//! Columns of the tables of linear vibration.

use super::specs;
use crate::ColumnSpec;

/// Columns of `modes.parquet`: a row for each natural mode.
pub const MODES: &[ColumnSpec] = specs! {
    "family": Words, "`lateral` of the assembly, `axial` or `torsional` of the whole string";
    "number": Ratio, "Number within the family, from 1";
    "frequency_Hz": Frequency, "Natural frequency at the operation's rotary speed";
    "whirl": Words, "`forward`, `backward` or `planar`; empty for other families",
        null_where "the mode is not lateral";
    "precession": Ratio,
        "Precession: 1 for a circle with the rotation, -1 against it, 0 to and fro";
    "lateral_energy": Ratio, "Lateral part of its kinetic energy";
    "axial_energy": Ratio, "Axial part of its kinetic energy";
    "torsional_energy": Ratio, "Torsional part of its kinetic energy";
    "most_strained_md_m": Depth, "Measured depth of the largest strain of the string's steel";
    "most_strained_from_bit_m": Length, "The same place, from the bit";
    "component": Words, "The component at that place";
};

/// Columns of `mode_shapes.parquet`: a row for each mode at each node that moves with it.
pub const MODE_SHAPES: &[ColumnSpec] = specs! {
    "family": Words, "As in `modes.parquet`";
    "number": Ratio, "As in `modes.parquet`";
    "md_m": Depth, "Measured depth of the node";
    "high_m": Length,
        "Displacement towards the high side, in phase with the largest; the largest is 1 m, for a \
         torsional mode the largest turn is 1 rad";
    "right_m": Length, "Displacement to the right of it as one looks down the hole, in phase";
    "high_later_m": Length, "Displacement towards the high side a quarter of a period later";
    "right_later_m": Length, "Displacement to the right a quarter of a period later";
    "along_m": Length, "Axial displacement, in phase";
    "turn_rad": Angle, "Turn about the axis, in phase";
};

/// Columns of `campbell.parquet`: a row for each branch at each rotary speed.
pub const CAMPBELL: &[ColumnSpec] = specs! {
    "branch": Ratio, "Number of the branch, from 0: lateral ones first";
    "family": Words, "As in `modes.parquet`";
    "number": Ratio, "Number within the family, from 1";
    "whirl": Words,
        "At the fastest speed: `forward`, `backward` or `planar`; empty for other families",
        null_where "the mode is not lateral";
    "rotary_speed_rad_per_s": RotarySpeed, "Rotary speed";
    "frequency_Hz": Frequency, "Natural frequency";
};

/// Columns of `critical_speeds.parquet`: a row for each rotary speed at which an order of the
/// rotation coincides with a natural frequency.
pub const CRITICAL_SPEEDS: &[ColumnSpec] = specs! {
    "order": Ratio, "Excitations per turn";
    "rotary_speed_rad_per_s": RotarySpeed, "Rotary speed";
    "frequency_Hz": Frequency, "Natural frequency at that speed";
    "branch": Ratio, "Branch of `campbell.parquet`";
    "family": Words, "As in `modes.parquet`";
    "number": Ratio, "Number within the family, from 1";
    "most_strained_md_m": Depth,
        "Measured depth of the mode's largest strain of the string's steel";
    "most_strained_from_bit_m": Length, "The same place, from the bit";
    "component": Words, "The component at that place";
};

/// Columns of `response.parquet`: a row for each rotary speed.
pub const RESPONSE: &[ColumnSpec] = specs! {
    "rotary_speed_rad_per_s": RotarySpeed, "Rotary speed";
    "amplitude_m": Length,
        "Largest displacement of a node of the assembly from its position at rest";
    "amplitude_md_m": Depth, "Measured depth of that node";
    "bending_stress_Pa": Pressure, "Largest bending stress added by the vibration";
    "bending_stress_md_m": Depth, "Measured depth of that stress";
    "component": Words, "The component of that stress";
};
