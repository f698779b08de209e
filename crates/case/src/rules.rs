//! Rules of values that other readers of case data share.

pub use crate::{model_rule::ModelRule, operation_kind::KindRule, unit_set::UNIT_SETS};
