//! Rules of values that other readers of case data share.

pub use crate::{
    operation::kind::KindRule,
    values::{ModelRule, UNIT_SETS},
};
