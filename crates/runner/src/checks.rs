//! Checks of a summary: their counts, and names of their operations.

pub use wholestring_judge::quantities;

use wholestring_results::{OperationSummary, Severity};

/// Number of checks of a severity that an operation has.
pub fn count(solved: &OperationSummary, severity: Severity) -> usize {
    let same = solved.checks.iter().filter(|check| check.severity == severity);
    same.count()
}

/// Whether a check has the severity of an error.
pub fn has_error(solved: &OperationSummary) -> bool {
    count(solved, Severity::Error) > 0
}

/// Operation and model in words, such as `trip in (soft)`.
pub fn name(solved: &OperationSummary) -> String {
    format!("{} ({})", solved.operation, solved.model)
}
