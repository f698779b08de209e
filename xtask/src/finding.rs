//! Result of a step.

use crate::count::Count;

pub(crate) enum Finding {
    Done,
    Tested(Count),
    Skipped(String),
}
