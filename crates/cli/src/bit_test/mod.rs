//! `wholestring bit-test`: the bit alone on its rock, at every weight and every speed.

mod args;
mod screen;

pub(crate) use args::BitTestArgs;
pub(crate) use screen::text;
