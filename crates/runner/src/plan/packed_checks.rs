//! Checks of a plan in its checkpoint, whose format has no names and so cannot flatten the fields
//! of a check into those of its row.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use wholestring::{outcome::ModelKind, well::FrictionLevel};
use wholestring_judge::Check;
use wholestring_results::{PlanCheck, PlanOperation};

/// Model, friction, operation, depth of the bit in m, and the check.
type Row = (ModelKind, FrictionLevel, PlanOperation, f64, Check);

pub(super) fn serialize<S: Serializer>(
    checks: &[PlanCheck],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let row = |row: &PlanCheck| -> Row {
        let PlanCheck { model, friction, operation, bit_depth_m, check } = row.clone();
        (model, friction, operation, bit_depth_m, check)
    };
    checks.iter().map(row).collect::<Vec<Row>>().serialize(serializer)
}

pub(super) fn deserialize<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Vec<PlanCheck>, D::Error> {
    let rows = Vec::<Row>::deserialize(deserializer)?;
    let check = |(model, friction, operation, bit_depth_m, check)| PlanCheck {
        model,
        friction,
        operation,
        bit_depth_m,
        check,
    };
    Ok(rows.into_iter().map(check).collect())
}
