//! Findings in words.

mod drift;
pub mod quantities;
mod sentence;

use wholestring::findings as core;
use wholestring_results::{Finding, Level, OperationSummary};

pub use sentence::{Around, shorter_element};

/// The findings of an operation as its summary holds them, the gravest first.
pub fn in_words(
    found: &[core::Finding],
    of: &OperationSummary,
    around: &Around<'_>,
) -> Vec<Finding> {
    let in_words = |found: &core::Finding| Finding {
        kind: found.kind.name().into(),
        level: found.level,
        md_m: found.from_md_m,
        to_md_m: found.to_md_m,
        value: found.value,
        limit: found.limit,
        unit: found.kind.unit().into(),
        message: sentence::sentence(found, of, around),
    };
    found.iter().map(in_words).collect()
}

/// How many findings of a level an operation has.
pub fn count(of: &OperationSummary, level: Level) -> usize {
    let same = of.findings.iter().filter(|of| of.level == level);
    same.count()
}

/// Whether something was found that forbids the operation or its answer.
pub fn is_wrong(of: &OperationSummary) -> bool {
    count(of, Level::Error) > 0
}

/// Operation and model as people name them: `trip in (soft)`.
pub fn name(of: &OperationSummary) -> String {
    format!("{} ({})", of.operation.replace('_', " "), of.model.name())
}
