//! Columns of the tables of a static BHA analysis.

use super::specs;
use crate::ColumnSpec;

/// Columns of `bha.parquet`: the assembly and the pipe that was solved with it, one row per node
/// from the bit up.
pub const BHA: &[ColumnSpec] = specs! {
    "component": Words, "Component at the node";
    "from_bit_m": Length, "Distance from the bit";
    "md_m": Depth, "Measured depth";
    "hole_radius_m": Length, "Radius of the hole";
    "offset_high_m": Length, "Offset of the string's axis from the hole's towards the high side";
    "offset_right_m": Length, "The same to the right, looking down the hole";
    "tilt_high_rad": Angle,
        "Tilt of the string's axis downwards against the hole's, towards the high side; at a bend \
         of the part above it";
    "tilt_right_rad": Angle, "The same to the right";
    "push_high_N": Force, "Contact force on the wall towards the high side";
    "push_right_N": Force, "The same to the right";
    "bending_moment_high_N_m": Torque,
        "Bending moment whose centre of curvature is towards the high side";
    "bending_moment_right_N_m": Torque, "The same to the right";
    "bending_moment_N_m": Torque, "Size of the bending moment";
    "tension_N": Force, "Effective tension";
    "torque_N_m": Torque, "Torque";
    "bending_stress_Pa": Pressure, "Largest bending stress from here to the next node below";
    "von_mises_stress_Pa": Pressure, "Largest von Mises stress from here to the next node below";
};

/// Columns of `bha_contacts.parquet`: the contacts of the assembly, one row per contact from the
/// bit up, the bit first.
pub const BHA_CONTACTS: &[ColumnSpec] = specs! {
    "touching": Words, "Touching part: `bit`, `blades`, `joint` or `body`";
    "component": Words, "Component of the touching part";
    "md_m": Depth, "Measured depth of the middle of its force";
    "from_bit_m": Length, "Its lower end, from the bit";
    "to_bit_m": Length, "Its upper end, from the bit";
    "force_high_N": Force, "Force on the wall towards the high side";
    "force_right_N": Force, "The same to the right, looking down the hole";
    "force_N": Force, "Size of the force";
    "side_rad": Angle, "Angle of the force from the high side, clockwise looking down the hole";
};

/// Columns of `bha_sweep.parquet`: the assembly at other tool faces, weights and inclinations, one
/// row for each.
pub const BHA_SWEEP: &[ColumnSpec] = specs! {
    "varied": Words, "Quantity varied: `toolface`, `weight` or `inclination`";
    "message": Words, "Reason why there is no equilibrium; else empty",
        null_where "there is an equilibrium";
    "toolface_rad": Angle, "Tool face of the lowest bend; `null` without one",
        null_where "no component has a bend";
    "weight_on_bit_N": Force, "Weight on bit";
    "inclination_rad": Angle, "Inclination of the hole at the bit";
    "side_force_high_N": Force,
        "Side force of the bit on the rock towards the high side; this and the following are \
         `null` without an equilibrium",
        null_where "there is no equilibrium";
    "side_force_right_N": Force, "The same to the right, looking down the hole; or `null`",
        null_where "there is no equilibrium";
    "tilt_high_rad": Angle,
        "Tilt of the bit against the hole's axis towards the high side; or `null`",
        null_where "there is no equilibrium";
    "tilt_right_rad": Angle, "The same to the right; or `null`",
        null_where "there is no equilibrium";
    "largest_bending_moment_N_m": Torque, "Largest bending moment of the assembly; or `null`",
        null_where "there is no equilibrium";
    "largest_von_mises_stress_Pa": Pressure, "Largest von Mises stress of it; or `null`",
        null_where "there is no equilibrium";
    "sag_inclination_rad": Angle,
        "Correction of the first survey sensor's inclination; `null` without a sensor",
        null_where "there is no survey sensor";
    "sag_azimuth_rad": Angle,
        "The same of its azimuth; `null` without a sensor and where the hole is within 1° of the \
         vertical",
        null_where "there is no survey sensor or the hole is within 1° of the vertical";
};
