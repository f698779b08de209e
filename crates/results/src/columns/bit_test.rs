//! Columns of `bit-test.parquet`.

use super::specs;
use crate::ColumnSpec;

/// Columns of `bit-test.parquet`: the bit alone on its rock, a row for each weight at each speed.
pub const BIT_TEST: &[ColumnSpec] = specs! {
    "point": Words, "Name of the point, and of its folder: `wob=60kN,rpm=120`";
    "weight_on_bit_N": Force, "Weight that was put on the bit";
    "rotary_speed_rad_per_s": RotarySpeed, "Rotary speed of the bit";
    "rate_of_penetration_m_per_s": RateOfPenetration, "Mean rate of penetration";
    "rate_of_penetration_error_m_per_s": RateOfPenetration,
        "Standard error of that mean, from its revolutions; `null` of less than two",
        null_where "there are less than two revolutions";
    "depth_of_cut_m": Length, "Mean depth of cut per revolution";
    "torque_N_m": Torque, "Mean torque of the bit on the rock";
    "torque_error_N_m": Torque,
        "Standard error of that mean, from its revolutions; `null` of less than two",
        null_where "there are less than two revolutions";
    "torque_std_N_m": Torque, "Standard deviation of the torque, of means over `averaging_time_s`";
    "weight_borne_N": Force,
        "Mean weight that the rock bore: that on the bit but for what sped it up";
    "weight_on_bit_std_N": Force,
        "Standard deviation of the weight that the rock bore, of means over `averaging_time_s`";
    "specific_energy_Pa": Pressure,
        "Work of the bit per volume of rock that it broke; `null` where it broke nothing",
        null_where "it broke nothing";
    "mechanical_specific_energy_Pa": Pressure,
        "Work of the bit per volume of hole, section times way; `null` where it did not get on",
        null_where "it did not get on";
    "bricks_broken": Ratio, "Elements of the rock that it broke";
    "kinetic_fraction": Ratio,
        "Largest kinetic energy of the rock over the work of its deformation";
    "revolutions": Ratio, "Revolutions that were counted";
    "time_s": Time, "Time that was counted";
    "averaging_time_s": Time, "Time of the means that standard deviations are taken of";
    "status": Words, "`complete`, `interrupted` or `failed`";
    "message": Words, "Why it failed; empty where it did not", null_where "it did not fail";
};
