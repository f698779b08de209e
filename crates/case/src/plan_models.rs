//! Models of plans.

use wholestring_plan::Statics;

use crate::words::words;

/// The models of a plan.
pub(crate) const STATICS: &[(&str, Statics)] = words!(Statics);
