//! The governing limit of each operation, in the summary and in sentences.

use wholestring_judge::{Quantity, Wording};
use wholestring_results::{PlanCheck, PlanOperation, PlanSummary};
use wholestring_units::UnitSet;

/// For each operation, the limit with the least reserve among those that damage a component or stop
/// the operation; buckling and a requested overpull are excluded. In the order of the operations.
pub(super) fn governing(checks: &[PlanCheck]) -> Vec<PlanCheck> {
    let mut found: Vec<&PlanCheck> = Vec::new();
    for row in checks.iter().filter(|row| row.check.kind.stops() && row.check.factor.is_some()) {
        match found.iter_mut().find(|other| other.operation == row.operation) {
            Some(other) if row.check.reserve() < other.check.reserve() => *other = row,
            Some(_) => {}
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
