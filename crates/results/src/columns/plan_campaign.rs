//! Columns of fatigue and wear by the campaign of a plan.

use super::MODEL;
use crate::ColumnSpec;

/// Adds the column of the model.
macro_rules! specs_of_model {
    ($($name:literal: $kind:ident, $meaning:literal $(, null_where $none:literal)?;)+) => {
        &[
            MODEL,
            $($crate::columns::specs!(@one $name, $kind, $meaning)$(.null_where($none))?),+
        ]
    };
}

/// Columns of `plan_fatigue.parquet`: a row for each 10 m of each component, from the bit up, of
/// each model.
pub const PLAN_FATIGUE: &[ColumnSpec] = specs_of_model! {
    "component": Words, "The component";
    "from_lower_end_m": Length, "Distance of the part's lower end from that of the component";
    "damage": Ratio, "Part of its life used up by the campaign, by Miner's rule; failure at one";
};

/// Columns of `plan_wear.parquet`: a row for each 5 m of casing, from the surface down, of each
/// model.
pub const PLAN_WEAR: &[ColumnSpec] = specs_of_model! {
    "section": Ratio, "Section of the hole, counted from one";
    "md_m": Depth, "Measured depth of the middle of the stretch";
    "groove_m": Length,
        "Depth of the groove, more than the wall where it is worn through; `null` where no groove \
         holds the volume",
        null_where "no groove holds the volume";
    "wall_m": Length, "Nominal wall; `null` where the casing's pipe is not known",
        null_where "the casing's pipe is not known";
    "wall_left_m": Length, "Wall at the bottom of the groove, or `null`",
        null_where "the casing's pipe is not known";
    "worn": Ratio, "Worn part of the wall, or `null`",
        null_where "the casing's pipe is not known";
    "burst_new_Pa": Pressure, "Burst of the new casing, or `null`",
        null_where "its grade is not known";
    "burst_Pa": Pressure, "Burst of the worn casing, or `null`",
        null_where "its grade is not known";
    "collapse_new_Pa": Pressure, "Collapse of the new casing without tension, or `null`",
        null_where "its grade is not known";
    "collapse_Pa": Pressure, "Collapse of the worn casing, or `null`",
        null_where "its grade is not known";
};
