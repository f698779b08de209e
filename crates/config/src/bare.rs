//! Numbers without a unit that may have been intended in another one.

use crate::source::Span;

/// A number without a unit, in a case that is shown in units other than SI.
#[derive(Debug)]
pub(crate) struct Bare {
    pub(crate) key: &'static str,
    pub(crate) place: Span,
    /// Its interpretation.
    pub(crate) text: String,
    /// The probable intention.
    pub(crate) meant: String,
}
