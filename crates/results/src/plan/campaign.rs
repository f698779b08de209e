//! Fatigue and wear of string and casing by the campaign of a plan.

use serde::{Deserialize, Serialize};
use wholestring::outcome::ModelKind;

use crate::{columns::MODEL, row::rows};

/// Fatigue of a component: its worst part, and the place where an hour of drilling at the deepest
/// depth uses up most of its life.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanFatigue {
    /// The model.
    pub model: ModelKind,
    /// The component.
    pub component: String,
    /// Part of the life of its worst part that the campaign uses up.
    pub damage: f64,
    /// Distance of that part's lower end from that of the component, m.
    pub from_lower_end_m: f64,
    /// Fatigue of an hour; none where nothing drills.
    pub hour: Option<PlanFatigueHour>,
}

/// Fatigue of an hour of drilling.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanFatigueHour {
    /// Measured depth of the largest damage, m.
    pub md_m: f64,
    /// Part of the life used up in an hour.
    pub damage_per_hour: f64,
    /// Amplitude of the bending stress, Pa.
    pub bending_Pa: f64,
    /// Dogleg severity of the hole, rad/m.
    pub dogleg_rad_per_m: f64,
    /// The permissible one, rad/m; none where the yield strength is not known.
    pub permissible_dogleg_rad_per_m: Option<f64>,
}

rows! {
    /// Damage of a part of the string.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PlanDamage {
        model: ModelKind => Words as MODEL, "The model";
        component: String => Words, "The component";
        from_lower_end_m: f64 => Length,
            "Distance of the part's lower end from that of the component";
        damage: f64 => Ratio,
            "Part of its life used up by the campaign, by Miner's rule; failure at one";
    }

    /// Columns of `plan_fatigue.parquet`: a row for each 10 m of each component, from the bit up,
    /// of each model.
    pub const PLAN_FATIGUE;
}

rows! {
    /// Wear of a stretch of casing.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanWear {
        model: ModelKind => Words as MODEL, "The model";
        section: usize => Ratio, "Section of the hole, counted from one";
        md_m: f64 => Depth, "Measured depth of the middle of the stretch";
        groove_m: Option<f64> => Length,
            "Depth of the groove, more than the wall where it is worn through; `null` where no \
             groove holds the volume",
            null_where "no groove holds the volume";
        wall_m: Option<f64> => Length, "Nominal wall; `null` where the casing's pipe is not known",
            null_where "the casing's pipe is not known";
        wall_left_m: Option<f64> => Length, "Wall at the bottom of the groove, or `null`",
            null_where "the casing's pipe is not known";
        worn: Option<f64> => Ratio, "Worn part of the wall, or `null`",
            null_where "the casing's pipe is not known";
        burst_Pa: Option<[f64; 2]>,
            "Burst of the new and of the worn casing; none where its grade is not known",
            columns {
                burst_new_Pa = |pair| pair[0] => Pressure, "Burst of the new casing, or `null`",
                    null_where "its grade is not known";
                burst_Pa = |pair| pair[1] => Pressure, "Burst of the worn casing, or `null`",
                    null_where "its grade is not known";
            };
        collapse_Pa: Option<[f64; 2]>,
            "Collapse of the new and of the worn casing without tension; none as the burst",
            columns {
                collapse_new_Pa = |pair| pair[0] => Pressure,
                    "Collapse of the new casing without tension, or `null`",
                    null_where "its grade is not known";
                collapse_Pa = |pair| pair[1] => Pressure,
                    "Collapse of the worn casing, or `null`",
                    null_where "its grade is not known";
            };
    }

    /// Columns of `plan_wear.parquet`: a row for each 5 m of casing, from the surface down, of each
    /// model.
    pub const PLAN_WEAR;
}
