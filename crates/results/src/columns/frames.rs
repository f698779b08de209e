//! Columns of `frames.parquet`.

use wholestring::outcome::QuantityKind;

use crate::ColumnSpec;

/// Columns of `frames.parquet`: the whole string, a row per node of every frame. Channels that were not asked
/// for have no column.
pub const FRAMES: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number(
        "time_s",
        QuantityKind::Time,
        "Simulated time from the start, settling included",
    ),
    ColumnSpec::number(
        "node",
        QuantityKind::Ratio,
        "Number of the node, from 0 at the surface",
    ),
    ColumnSpec::number("md_m", QuantityKind::Depth, "Measured depth of the node"),
    ColumnSpec::number(
        "offset_high_m",
        QuantityKind::Length,
        "Offset of the string's axis from the hole's towards the high side",
    ),
    ColumnSpec::number(
        "offset_right_m",
        QuantityKind::Length,
        "Offset to the right, looking down the hole",
    ),
    ColumnSpec::number("north_m", QuantityKind::Length, "North of the node"),
    ColumnSpec::number("east_m", QuantityKind::Length, "East of the node"),
    ColumnSpec::number(
        "tvd_m",
        QuantityKind::Depth,
        "True vertical depth of the node",
    ),
    ColumnSpec::number(
        "velocity_high_m_per_s",
        QuantityKind::Speed,
        "Velocity towards the high side",
    ),
    ColumnSpec::number(
        "velocity_right_m_per_s",
        QuantityKind::Speed,
        "Velocity to the right",
    ),
    ColumnSpec::number(
        "axial_velocity_m_per_s",
        QuantityKind::Speed,
        "Velocity down the hole",
    ),
    ColumnSpec::number(
        "rotary_speed_rad_per_s",
        QuantityKind::RotarySpeed,
        "Rotary speed of the node; positive clockwise looking down the hole",
    ),
    ColumnSpec::number(
        "twist_rad",
        QuantityKind::Angle,
        "Turn of the node against the bit; positive where it leads",
    ),
    ColumnSpec::number(
        "tilt_high_rad",
        QuantityKind::Angle,
        "Angle of the string's axis with the hole's towards the high side",
    ),
    ColumnSpec::number("tilt_right_rad", QuantityKind::Angle, "Angle to the right"),
    ColumnSpec::number(
        "contact_force_N",
        QuantityKind::Force,
        "Contact force of the node, averaged over the sample; positive on the high side",
    ),
    ColumnSpec::number(
        "axial_friction_N",
        QuantityKind::Force,
        "Wall friction along the string on the node, averaged over the sample; positive adds to hook load",
    ),
    ColumnSpec::number(
        "friction_torque_N_m",
        QuantityKind::Torque,
        "Torque of wall friction on the node, averaged over the sample",
    ),
    ColumnSpec::number(
        "tension_N",
        QuantityKind::Force,
        "Effective tension; negative in compression",
    ),
    ColumnSpec::number(
        "torque_N_m",
        QuantityKind::Torque,
        "Torque that the string carries",
    ),
    ColumnSpec::number(
        "bending_moment_N_m",
        QuantityKind::Torque,
        "Bending moment, whatever its direction",
    ),
    ColumnSpec::number(
        "von_mises_stress_Pa",
        QuantityKind::Pressure,
        "Von Mises stress where the body's surface bears most",
    ),
];
