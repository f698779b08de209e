//! What a plan takes from the dynamics where it is asked to: how the string sets itself in motion, and what
//! it wears.
//!
//! An [`Event`] begins with the string hanging at rest and moves one set point to that of the operation, in a
//! stated time: the engine's [`Schedule`](wholestring::dynamics::Schedule). What its peaks are against what
//! they come to is an [`EventAnswer`]. Theory: `docs/src/theory/peaks.md`.

mod event;
mod extremes;
mod peak;
mod settings;
mod solve;
mod wear;

pub use event::Event;
pub use peak::{History, Peak};
pub use settings::DynamicPlan;
pub use solve::{EventAnswer, EventTask, NoDynamics};
pub use wear::WearTask;
