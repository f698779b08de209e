//! The case with all defaults filled in, for the record of a run.
//!
//! What the solvers were given is written as the engine's own types write it, so that a number
//! which they get is in the record too. Where the record has another name for it, the change of
//! name stands here.

mod bit;
mod fields;
mod hoist;
mod narrowed;
mod operation;
mod rock;
mod run;
mod string;
mod well;
mod whole;

pub(crate) use self::{
    narrowed::narrow,
    whole::{Given, settings},
};
