//! What the campaign of a plan does to string and casing.

use serde::{Deserialize, Serialize};

use crate::{PLAN_FATIGUE, PLAN_WEAR, Table};

/// Fatigue of a component: its worst part, and the place where an hour of drilling at the deepest
/// depth costs most.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanFatigue {
    /// Name of the model.
    pub model: String,
    /// The component.
    pub component: String,
    /// Part of its life that the campaign takes of its worst part.
    pub damage: f64,
    /// Distance of that part's lower end from that of the component, m.
    pub from_lower_end_m: f64,
    /// What an hour costs; none where nothing drills.
    pub hour: Option<PlanFatigueHour>,
}

/// What an hour of drilling costs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanFatigueHour {
    /// Measured depth where it costs most, m.
    pub md_m: f64,
    /// Part of the life that goes in an hour.
    pub damage_per_hour: f64,
    /// Amplitude of the bending stress, Pa.
    pub bending_Pa: f64,
    /// Dogleg severity of the hole, rad/m.
    pub dogleg_rad_per_m: f64,
    /// The permissible one, rad/m; none where the yield strength is not known.
    pub permissible_dogleg_rad_per_m: Option<f64>,
}

/// Damage of a part of the string.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanDamage {
    /// Name of the model.
    pub model: String,
    /// The component.
    pub component: String,
    /// Distance of the part's lower end from that of the component, m.
    pub from_lower_end_m: f64,
    /// Part of its life that is gone.
    pub damage: f64,
}

/// Wear of a stretch of casing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanWear {
    /// Name of the model.
    pub model: String,
    /// Section of the hole, counted from one.
    pub section: usize,
    /// Measured depth of its middle, m.
    pub md_m: f64,
    /// Depth of the groove, m; none where no groove holds what is gone.
    pub groove_m: Option<f64>,
    /// Nominal wall, m; this and what follows none where the casing's pipe or its grade is not
    /// known.
    pub wall_m: Option<f64>,
    /// Wall at the bottom of the groove, m.
    pub wall_left_m: Option<f64>,
    /// Part of the wall that is gone.
    pub worn: Option<f64>,
    /// Burst of the new and of the worn casing, Pa.
    pub burst_Pa: Option<[f64; 2]>,
    /// Collapse of the new and of the worn casing, Pa.
    pub collapse_Pa: Option<[f64; 2]>,
}

/// A row for each part of the string.
pub fn plan_fatigue_table(damage: &[PlanDamage]) -> Table {
    let mut table = Table::with_columns(PLAN_FATIGUE);
    for of in damage {
        table.append(
            &[("model", &[&of.model]), ("component", &[&of.component])],
            &[("from_lower_end_m", &[of.from_lower_end_m]), ("damage", &[of.damage])],
        );
    }
    table
}

/// A row for each stretch of casing.
pub fn plan_wear_table(wear: &[PlanWear]) -> Table {
    let mut table = Table::with_columns(PLAN_WEAR);
    for of in wear {
        let number = |value: Option<f64>| [value.unwrap_or(f64::NAN)];
        let of_pair = |pair: Option<[f64; 2]>, place: usize| number(pair.map(|of| of[place]));
        table.append(
            &[("model", &[&of.model])],
            &[
                ("section", &[of.section as f64]),
                ("md_m", &[of.md_m]),
                ("groove_m", &number(of.groove_m)),
                ("wall_m", &number(of.wall_m)),
                ("wall_left_m", &number(of.wall_left_m)),
                ("worn", &number(of.worn)),
                ("burst_new_Pa", &of_pair(of.burst_Pa, 0)),
                ("burst_Pa", &of_pair(of.burst_Pa, 1)),
                ("collapse_new_Pa", &of_pair(of.collapse_Pa, 0)),
                ("collapse_Pa", &of_pair(of.collapse_Pa, 1)),
            ],
        );
    }
    table
}
