//! Checks of a plan: the governing limit of each operation, and their form in the checkpoint.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use wholestring::{outcome::ModelKind, well::FrictionLevel};
use wholestring_judge::{Check, Quantity, Wording};
use wholestring_results::{PlanCheck, PlanOperation, PlanSummary};
use wholestring_units::UnitSet;

/// For each operation, the limit with the least reserve among those that damage a component or stop
/// the operation, among equals the one at the deeper bit; buckling and a requested overpull are
/// excluded. In the order of the operations.
pub(super) fn governing(checks: &[PlanCheck]) -> Vec<PlanCheck> {
    let mut found: Vec<&PlanCheck> = Vec::new();
    for row in checks.iter().filter(|row| row.check.kind.stops() && row.check.factor.is_some()) {
        match found.iter_mut().find(|other| other.operation == row.operation) {
            Some(other) => {
                let reserve = row.check.reserve().total_cmp(&other.check.reserve());
                if reserve.then(other.bit_depth_m.total_cmp(&row.bit_depth_m)).is_lt() {
                    *other = row;
                }
            }
            None => found.push(row),
        }
    }
    found.into_iter().cloned().collect()
}

/// A sentence for each operation: the governing limit, its component and position, and the reserve.
pub fn governing_sentences(summary: &PlanSummary, units: UnitSet) -> Vec<String> {
    summary.governing.iter().map(|row| sentence(row, units)).collect()
}

fn sentence(row: &PlanCheck, units: UnitSet) -> String {
    let operation = match row.operation {
        PlanOperation::Event(event) => format!("{} by the dynamics", event.label()),
        PlanOperation::Kind(kind) => kind.words().to_owned(),
    };
    let depth = Wording::from(Quantity::depth(row.bit_depth_m).to_string()).in_units(units);
    let check = row.check.sentence_in(units);
    format!("{operation}, {} friction, bit at {depth}: {check}.", row.friction)
}

// Checks of a plan in its checkpoint, whose format has no names and so cannot flatten the fields
// of a check into those of its row.

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

#[cfg(test)]
mod tests {
    use wholestring::operation::OperationKind;
    use wholestring::statics::soft::SoftError;
    use wholestring_judge::{Judge, NoAnswer};

    use super::*;

    /// Of strings that lock up, whose factors are all zero, the one at the deeper bit governs,
    /// whatever the order of the rows.
    #[test]
    fn of_equal_limits_the_one_at_the_deeper_bit_governs() {
        let row = |bit_depth_m: f64| PlanCheck {
            model: ModelKind::Stiff,
            friction: FrictionLevel::High,
            operation: PlanOperation::Kind(OperationKind::Slide),
            bit_depth_m,
            check: Judge::default()
                .unsolved(&NoAnswer::Soft(SoftError::LocksUp { md_m: 10.0 }))
                .checks
                .remove(0),
        };
        for rows in [[row(900.0), row(2400.0)], [row(2400.0), row(900.0)]] {
            let found: Vec<f64> = governing(&rows).iter().map(|row| row.bit_depth_m).collect();
            assert_eq!(found, [2400.0]);
        }
    }
}
