//! Numbers without a unit that may have been meant in another one.

use crate::source::Span;

/// A number without a unit, in a case that is shown in units other than SI.
#[derive(Debug)]
pub(crate) struct Bare {
    pub(crate) key: &'static str,
    pub(crate) place: Span,
    /// What it was taken as.
    pub(crate) text: String,
    /// What may have been meant.
    pub(crate) meant: String,
}
