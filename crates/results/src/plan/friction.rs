//! Friction of the hole in a plan.

use serde::{Deserialize, Serialize};
use wholestring::well::FrictionLevel;

use crate::{columns::FRICTION, row::rows};

rows! {
    /// Friction of a hole section at a level.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanFriction {
        friction: FrictionLevel => Words as FRICTION, "Level of friction";
        kind: String => Words, "`casing` or `open`";
        from_md_m: f64 => Depth, "Measured depth of the section's upper end";
        to_md_m: f64 => Depth, "Measured depth of its lower end";
        along: f64 => Ratio, "Coefficient of axial friction";
        around: f64 => Ratio, "Coefficient of rotational friction";
    }

    /// Columns of `plan_friction.parquet`: a row for each hole section at each level of friction.
    pub const PLAN_FRICTION;
}
