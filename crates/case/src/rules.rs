//! Rules of values that other files about cases have too.

pub use crate::{model_rule::ModelRule, operation_kind::KindRule, unit_set::UNIT_SETS};
