//! What a case answers at once, while it is written: soft and stiff string.

mod answer;
mod broomstick;
mod column;
mod tracks;
mod well;

pub(crate) use answer::{Answer, answer};
pub(crate) use broomstick::{Broomstick, broomstick};
pub(crate) use column::Column;
