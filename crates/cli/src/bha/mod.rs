//! `wholestring bha`: static analysis of the bottom-hole assembly.

mod args;
mod screen;

pub(crate) use args::BhaArgs;
pub(crate) use screen::text;
