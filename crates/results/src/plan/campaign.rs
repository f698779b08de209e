//! Fatigue and wear of string and casing by the campaign of a plan.

use serde::{Deserialize, Serialize};
use wholestring::outcome::ModelKind;

use crate::{PLAN_FATIGUE, PLAN_WEAR, Table};

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

/// Damage of a part of the string.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanDamage {
    /// The model.
    pub model: ModelKind,
    /// The component.
    pub component: String,
    /// Distance of the part's lower end from that of the component, m.
    pub from_lower_end_m: f64,
    /// Part of its life that is used up.
    pub damage: f64,
}

/// Wear of a stretch of casing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanWear {
    /// The model.
    pub model: ModelKind,
    /// Section of the hole, counted from one.
    pub section: usize,
    /// Measured depth of its middle, m.
    pub md_m: f64,
    /// Depth of the groove, m; none where no groove holds the worn volume.
    pub groove_m: Option<f64>,
    /// Nominal wall, m; this and the following are none where the casing's pipe or its grade is not
    /// known.
    pub wall_m: Option<f64>,
    /// Wall at the bottom of the groove, m.
    pub wall_left_m: Option<f64>,
    /// Worn part of the wall.
    pub worn: Option<f64>,
    /// Burst of the new and of the worn casing, Pa.
    pub burst_Pa: Option<[f64; 2]>,
    /// Collapse of the new and of the worn casing, Pa.
    pub collapse_Pa: Option<[f64; 2]>,
}

/// A row for each part of the string.
pub fn plan_fatigue_table(damage: &[PlanDamage]) -> Table {
    let mut table = Table::with_columns(PLAN_FATIGUE);
    for part in damage {
        table.append(
            &[("model", &[part.model.name()]), ("component", &[&part.component])],
            &[("from_lower_end_m", &[part.from_lower_end_m]), ("damage", &[part.damage])],
        );
    }
    table
}

/// A row for each stretch of casing.
pub fn plan_wear_table(wear: &[PlanWear]) -> Table {
    let mut table = Table::with_columns(PLAN_WEAR);
    for stretch in wear {
        let number = |value: Option<f64>| [value.unwrap_or(f64::NAN)];
        let of_pair = |pair: Option<[f64; 2]>, place: usize| number(pair.map(|pair| pair[place]));
        table.append(
            &[("model", &[stretch.model.name()])],
            &[
                ("section", &[stretch.section as f64]),
                ("md_m", &[stretch.md_m]),
                ("groove_m", &number(stretch.groove_m)),
                ("wall_m", &number(stretch.wall_m)),
                ("wall_left_m", &number(stretch.wall_left_m)),
                ("worn", &number(stretch.worn)),
                ("burst_new_Pa", &of_pair(stretch.burst_Pa, 0)),
                ("burst_Pa", &of_pair(stretch.burst_Pa, 1)),
                ("collapse_new_Pa", &of_pair(stretch.collapse_Pa, 0)),
                ("collapse_Pa", &of_pair(stretch.collapse_Pa, 1)),
            ],
        );
    }
    table
}
