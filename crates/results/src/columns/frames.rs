//! Columns of `frames.parquet`.

use crate::ColumnSpec;

/// Columns of `frames.parquet`: the whole string, a row per node of every frame. Channels that were not asked
/// for have no column.
pub const FRAMES: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number(
        "time_s",
        "s",
        "Simulated time from the start, settling included",
    ),
    ColumnSpec::number("node", "", "Number of the node, from 0 at the surface"),
    ColumnSpec::number("md_m", "m", "Measured depth of the node"),
    ColumnSpec::number(
        "offset_high_m",
        "m",
        "Offset of the string's axis from the hole's towards the high side",
    ),
    ColumnSpec::number(
        "offset_right_m",
        "m",
        "Offset to the right, looking down the hole",
    ),
    ColumnSpec::number("north_m", "m", "North of the node"),
    ColumnSpec::number("east_m", "m", "East of the node"),
    ColumnSpec::number("tvd_m", "m", "True vertical depth of the node"),
    ColumnSpec::number(
        "velocity_high_m_per_s",
        "m/s",
        "Velocity towards the high side",
    ),
    ColumnSpec::number("velocity_right_m_per_s", "m/s", "Velocity to the right"),
    ColumnSpec::number("axial_velocity_m_per_s", "m/s", "Velocity down the hole"),
    ColumnSpec::number(
        "rotary_speed_rad_per_s",
        "rad/s",
        "Rotary speed of the node; positive clockwise looking down the hole",
    ),
    ColumnSpec::number(
        "twist_rad",
        "rad",
        "Turn of the node against the bit; positive where it leads",
    ),
    ColumnSpec::number(
        "tilt_high_rad",
        "rad",
        "Angle of the string's axis with the hole's towards the high side",
    ),
    ColumnSpec::number("tilt_right_rad", "rad", "Angle to the right"),
    ColumnSpec::number(
        "contact_force_N",
        "N",
        "Contact force of the node, averaged over the sample; positive on the high side",
    ),
    ColumnSpec::number(
        "axial_friction_N",
        "N",
        "Wall friction along the string on the node, averaged over the sample; positive adds to hook load",
    ),
    ColumnSpec::number(
        "friction_torque_N_m",
        "N·m",
        "Torque of wall friction on the node, averaged over the sample",
    ),
    ColumnSpec::number(
        "tension_N",
        "N",
        "Effective tension; negative in compression",
    ),
    ColumnSpec::number("torque_N_m", "N·m", "Torque that the string carries"),
    ColumnSpec::number(
        "bending_moment_N_m",
        "N·m",
        "Bending moment, whatever its direction",
    ),
    ColumnSpec::number(
        "von_mises_stress_Pa",
        "Pa",
        "Von Mises stress where the body's surface bears most",
    ),
];
