//! Checks of a plan.

use serde::{Deserialize, Serialize};
use wholestring::{outcome::ModelKind, well::FrictionLevel};
use wholestring_judge::Check;

use super::PlanOperation;
use crate::{
    Row, Table,
    columns::{FRICTION, MODEL, OPERATION},
    row::{parts, rows},
};

parts![Check];

rows! {
    /// A check of one operation at one depth with one friction.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
    pub struct PlanCheck {
        #[cfg_attr(feature = "openapi", schema(value_type = String))]
        model: ModelKind => Words as MODEL, "The model";
        #[cfg_attr(feature = "openapi", schema(value_type = String))]
        friction: FrictionLevel => Words as FRICTION, "Level of friction: `low`, `expected` or `high`";
        #[cfg_attr(feature = "openapi", schema(value_type = String))]
        operation: PlanOperation => Words as OPERATION, "The operation, or the event";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        #[serde(flatten)]
        check: Check, "The check", columns {
            kind => Words, "`tension`, `torsion`, `von_mises`, `hoist`, ...";
            component => Words, "The component; empty for the rig", null_where "it is of the rig";
            md_m => Depth, "Measured depth of the place, or `null` for the rig",
                null_where "it is of the rig";
            load = |check| check.value => Ratio, "The load, in `unit`";
            capacity = |check| check.limit => Ratio, "The capacity, in `unit`";
            unit => Words, "`N`, `N·m` or `Pa`";
            factor => Ratio, "Capacity over load";
            required => Ratio, "The required factor";
            verdict => Words,
                "`OK`, `marginal` (met by less than a tenth), `below required factor` or \
                 `exceeded` (the load is larger than the capacity)";
            severity => Words, "`ok`, `note`, `warning` or `error`";
        };
    }

    /// Columns of `plan_limits.parquet`: a load against its capacity, for each depth of the bit,
    /// model, operation, friction, kind of limit and component at the place with the least reserve.
    pub const PLAN_LIMITS;
}

/// A row for each limit with a load and a capacity.
pub fn plan_limits_table(checks: &[PlanCheck]) -> Table {
    let is_limit = |row: &&PlanCheck| {
        let Check { value, limit, factor, required, .. } = row.check;
        [value, limit, factor, required].iter().all(Option::is_some)
    };
    PlanCheck::table(checks.iter().filter(is_limit))
}
