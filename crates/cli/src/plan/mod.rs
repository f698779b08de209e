//! `wholestring plan`: torque and drag at every bit depth, with low, expected and high friction.

mod args;
mod screen;

pub(crate) use args::PlanArgs;
pub(crate) use screen::text;
