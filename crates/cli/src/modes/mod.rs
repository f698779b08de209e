//! `wholestring modes`: natural frequencies, critical speeds and the response to a rotating force.

mod args;
mod screen;

pub(crate) use args::ModesArgs;
pub(crate) use screen::text;
