//! What a case answers at once, while it is written: soft and stiff string,
//! limits, broomstick, and the assembly at rest.

mod answer;
mod assembly;
mod broomstick;
mod column;
mod limits;
mod set_points;
mod tracks;
mod well;

pub(crate) use answer::{Answer, answer};
pub(crate) use assembly::{AssemblyView, assembly};
pub(crate) use broomstick::{Broomstick, broomstick};
pub(crate) use column::Column;
pub(crate) use well::{Component, PathView, Section};
