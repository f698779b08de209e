//! Columns of `stability.parquet`.

use super::specs;
use crate::ColumnSpec;

/// Columns of `stability.parquet`: the map of torsional stability, a row for each rotary speed at
/// each weight on bit.
pub const STABILITY: &[ColumnSpec] = specs! {
    "weight_on_bit_N": Force, "Weight on bit";
    "rotary_speed_rad_per_s": RotarySpeed, "Rotary speed at surface";
    "unstable_roots": Ratio, "Growing roots of the linear vibration, a pair counted twice";
    "growth_per_s": Growth,
        "Growth rate of the fastest growing motion; negative where all decay, `null` where \
         none was found",
        null_where "none was found";
    "frequency_Hz": Frequency, "Its frequency, `null` where none was found",
        null_where "none was found";
    "complete": Ratio,
        "1 where all growing motions were followed; 0 where `growth_per_s` is a lower bound of \
         the largest growth";
    "stable": Words,
        "Stability of this weight: `everywhere` on the map, `from` a speed on, or `nowhere`: not \
         even at the fastest";
    "threshold_rad_per_s": RotarySpeed,
        "Rotary speed from which it is stable, `null` where it is stable everywhere or nowhere",
        null_where "the weight is stable at all speeds of the map, or not even at the fastest";
    "surface_torque_N_m": Torque, "Torque at the top while the string turns steadily";
    "stalls": Ratio, "1 where that exceeds the torque of the top drive, else 0";
    "lies_by": Words,
        "Method that computed the string's position in the hole: `stiff`, or `soft` where that \
         found no equilibrium";
};
