//! Findings in words: in the summary, on the screen, and as an exit status.

#[path = "../../../cli/src/findings.rs"]
mod screen;
mod sentence;

use wholestring::{findings as core, rig::Rig};
use wholestring_results::{Finding, Level, OperationSummary, Summary};
use wholestring_units::UnitSet;

pub(crate) use screen::lines;

use crate::failure::Failure;

/// The findings of an operation as its summary holds them, the gravest first.
pub(crate) fn told(
    found: &[core::Finding],
    of: &OperationSummary,
    rig: &Rig,
    units: UnitSet,
) -> Vec<Finding> {
    let told = |found: &core::Finding| Finding {
        kind: found.kind.name().into(),
        level: found.level,
        md_m: found.from_md_m,
        to_md_m: found.to_md_m,
        value: found.value,
        limit: found.limit,
        unit: found.kind.unit().into(),
        message: sentence::sentence(found, of, rig, units),
    };
    found.iter().map(told).collect()
}

/// How many findings of a level an operation has.
pub(crate) fn count(of: &OperationSummary, level: Level) -> usize {
    let same = of.findings.iter().filter(|of| of.level == level);
    same.count()
}

/// Whether something was found that forbids the operation or its answer.
pub(crate) fn is_wrong(of: &OperationSummary) -> bool {
    count(of, Level::Error) > 0
}

/// Why `--strict` does not let a run pass.
pub(crate) fn refused(summary: &Summary) -> Option<Failure> {
    let wrong = summary.operations.iter().filter(|of| is_wrong(of));
    let wrong: Vec<String> = wrong.map(name).collect();
    let message = format!("error: errors were found: {}", wrong.join(", "));
    (!wrong.is_empty()).then_some(Failure::Refused(message))
}

/// `trip in (soft)`
pub(crate) fn name(of: &OperationSummary) -> String {
    format!("{} ({})", of.operation.replace('_', " "), of.model.name())
}
