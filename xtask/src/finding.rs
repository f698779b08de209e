//! What a step found out.

use crate::count::Count;

pub(crate) enum Finding {
    Done,
    Tested(Count),
    Skipped(String),
}
