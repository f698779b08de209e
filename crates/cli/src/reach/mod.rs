//! `wholestring reach`: greatest depth of the well, and the limit that stops it.

mod args;
mod screen;

pub(crate) use args::ReachArgs;
pub(crate) use screen::text;
