//! Checks of a summary: counted, and named with their operation.

pub use wholestring_judge::quantities;

use wholestring_results::{OperationSummary, Severity};

/// Number of checks of a severity that an operation has.
pub fn count(solved: &OperationSummary, severity: Severity) -> usize {
    let same = solved.checks.iter().filter(|check| check.severity == severity);
    same.count()
}

/// Whether a check forbids the operation or its answer.
pub fn has_error(solved: &OperationSummary) -> bool {
    count(solved, Severity::Error) > 0
}

/// Operation and model as people name them: `trip in (soft)`.
pub fn name(solved: &OperationSummary) -> String {
    format!("{} ({})", solved.operation.replace('_', " "), solved.model.name())
}
