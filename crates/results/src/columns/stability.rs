//! Columns of `stability.parquet`.

use super::specs;
use crate::ColumnSpec;

/// Columns of `stability.parquet`: the map of torsional stability, a row for each rotary speed at
/// each weight on bit.
pub const STABILITY: &[ColumnSpec] = specs! {
    "weight_on_bit_N": Force, "Weight on bit";
    "rotary_speed_rad_per_s": RotarySpeed, "Rotary speed at surface";
    "unstable_roots": Ratio, "Roots of small motions that grow, a pair counted twice";
    "growth_per_s": Growth,
        "How fast the small motion grows that grows most; negative where all die away, `null` where \
         none was found",
        null_where "none was found";
    "frequency_Hz": Frequency, "Its frequency, `null` where none was found", null_where "none was found";
    "complete": Ratio,
        "1 where as many growing motions were followed as there are; 0 where `growth_per_s` is the \
         least that the largest can be";
    "stable": Words,
        "Where this weight is stable: `everywhere` on the map, `from` a speed on, or `nowhere`: not \
         even at the fastest";
    "threshold_rad_per_s": RotarySpeed,
        "Rotary speed from which on it is stable, `null` where it is everywhere or nowhere",
        null_where "the weight is stable at all speeds of the map, or not even at the fastest";
    "surface_torque_N_m": Torque, "Torque at the top while the string turns steadily";
    "stalls": Ratio, "1 where that is more than the top drive gives, else 0";
    "lies_by": Words,
        "Method that said how the string lies in its hole: `stiff`, or `soft` where that found no \
         equilibrium";
};
