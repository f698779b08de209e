//! Checks of a plan.

use serde::{Deserialize, Serialize};
use wholestring::{
    operation::{Event, OperationKind},
    outcome::ModelKind,
    well::FrictionLevel,
};
use wholestring_judge::Check;

use crate::{
    Row, Table,
    columns::{FRICTION, MODEL, OPERATION},
    row::{named, parts, rows},
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

// Subjects of the checks of a plan: operations, and events of its dynamic part.

/// An operation of a plan, or an event of its dynamic part. The file has its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(into = "&'static str", try_from = "String")]
pub enum PlanOperation {
    /// An operation.
    Kind(OperationKind),
    /// An event.
    Event(Event),
}

impl PlanOperation {
    /// The operation or the event of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        let kind = OperationKind::from_name(name).map(Self::Kind);
        kind.or_else(|| Event::from_name(name).map(Self::Event))
    }

    /// Name in results: `trip_out`, `pick_up_from_slips`, ...
    pub const fn name(self) -> &'static str {
        match self {
            Self::Kind(kind) => kind.name(),
            Self::Event(event) => event.name(),
        }
    }

    /// Name in messages and tables: "trip out", "pick up from slips", ...
    pub const fn words(self) -> &'static str {
        match self {
            Self::Kind(kind) => kind.words(),
            Self::Event(event) => event.words(),
        }
    }
}

named! {
    PlanOperation: name, "an operation or an event", Self::from_name;
}

impl From<PlanOperation> for &'static str {
    fn from(operation: PlanOperation) -> Self {
        operation.name()
    }
}

impl TryFrom<String> for PlanOperation {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        Self::from_name(&name)
            .ok_or_else(|| format!("'{name}' is neither an operation nor an event"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_has_the_name() {
        let kinds = OperationKind::ALL.map(PlanOperation::Kind);
        for operation in kinds.into_iter().chain(Event::ALL.map(PlanOperation::Event)) {
            let value = serde_json::to_value(operation).expect("a name");
            assert_eq!(value, operation.name());
            let read: PlanOperation = serde_json::from_value(value).expect("an operation");
            assert_eq!(read, operation);
        }
        assert!(serde_json::from_str::<PlanOperation>(r#""trip""#).is_err());
    }
}
