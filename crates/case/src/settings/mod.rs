//! The case with all defaults filled in, for the record of a run.
//!
//! The inputs of the solvers are serialised by the engine's own types, so that every number that
//! they use is in the record too. Renamings for the record are in this module.

mod bit;
mod fields;
mod run;
mod well;
mod whole;

pub(crate) use self::whole::{Given, settings};
pub(crate) use whole::narrow;
