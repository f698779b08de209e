//! `wholestring calibrate`: friction factors from readings at the surface.

mod args;
mod screen;

pub(crate) use args::CalibrateArgs;
pub(crate) use screen::text;
