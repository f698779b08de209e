//! Inputs of a plan from dynamic runs, where requested: starts of motion, and casing wear.
//!
//! An [`Event`] begins with the string hanging at rest and moves one set point to that of the
//! operation, in a given time: the engine's [`Schedule`](wholestring::dynamics::Schedule). An
//! [`EventAnswer`] contains its peaks and the steady values after them. Theory:
//! `docs/src/theory/peaks.md`.

mod peak;
mod settings;
mod solve;
mod wear;

pub use peak::{History, Peak};
pub use settings::DynamicPlan;
pub use solve::{EventAnswer, EventTask, NoDynamics};
pub use wear::WearTask;
pub use wholestring::operation::Event;
