//! Columns of `bit-test.parquet`.

use wholestring::outcome::QuantityKind;

use crate::ColumnSpec;

/// Columns of `bit-test.parquet`: the bit alone on its rock, a row for each weight at each speed.
pub const BIT_TEST: &[ColumnSpec] = &[
    ColumnSpec::text("point", "Name of the point, and of its folder: `wob=60kN,rpm=120`"),
    ColumnSpec::number("weight_on_bit_N", QuantityKind::Force, "Weight that was put on the bit"),
    ColumnSpec::number(
        "rotary_speed_rad_per_s",
        QuantityKind::RotarySpeed,
        "Rotary speed of the bit",
    ),
    ColumnSpec::number(
        "rate_of_penetration_m_per_s",
        QuantityKind::RateOfPenetration,
        "Mean rate of penetration",
    ),
    ColumnSpec::number(
        "rate_of_penetration_error_m_per_s",
        QuantityKind::RateOfPenetration,
        "Standard error of that mean, from its revolutions; `null` of less than two",
    )
    .null_where("there are less than two revolutions"),
    ColumnSpec::number("depth_of_cut_m", QuantityKind::Length, "Mean depth of cut per revolution"),
    ColumnSpec::number("torque_N_m", QuantityKind::Torque, "Mean torque of the bit on the rock"),
    ColumnSpec::number(
        "torque_error_N_m",
        QuantityKind::Torque,
        "Standard error of that mean, from its revolutions; `null` of less than two",
    )
    .null_where("there are less than two revolutions"),
    ColumnSpec::number(
        "torque_std_N_m",
        QuantityKind::Torque,
        "Standard deviation of the torque, of means over `averaging_time_s`",
    ),
    ColumnSpec::number(
        "weight_borne_N",
        QuantityKind::Force,
        "Mean weight that the rock bore: that on the bit but for what sped it up",
    ),
    ColumnSpec::number(
        "weight_on_bit_std_N",
        QuantityKind::Force,
        "Standard deviation of the weight that the rock bore, of means over `averaging_time_s`",
    ),
    ColumnSpec::number(
        "specific_energy_Pa",
        QuantityKind::Pressure,
        "Work of the bit per volume of rock that it broke; `null` where it broke nothing",
    )
    .null_where("it broke nothing"),
    ColumnSpec::number(
        "mechanical_specific_energy_Pa",
        QuantityKind::Pressure,
        "Work of the bit per volume of hole, section times way; `null` where it did not get on",
    )
    .null_where("it did not get on"),
    ColumnSpec::number("bricks_broken", QuantityKind::Ratio, "Elements of the rock that it broke"),
    ColumnSpec::number(
        "kinetic_fraction",
        QuantityKind::Ratio,
        "Largest kinetic energy of the rock over the work of its deformation",
    ),
    ColumnSpec::number("revolutions", QuantityKind::Ratio, "Revolutions that were counted"),
    ColumnSpec::number("time_s", QuantityKind::Time, "Time that was counted"),
    ColumnSpec::number(
        "averaging_time_s",
        QuantityKind::Time,
        "Time of the means that standard deviations are taken of",
    ),
    ColumnSpec::text("status", "`complete`, `interrupted` or `failed`"),
    ColumnSpec::text("message", "Why it failed; empty where it did not")
        .null_where("it did not fail"),
];
