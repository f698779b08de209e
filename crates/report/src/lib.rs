//! Pictures of what a run leaves, as SVG.
#![warn(missing_docs)]

mod axis;
mod canvas;
mod colours;
mod legend;
mod line;
mod profile;

pub use profile::{Curve, Entry, Interval, IntervalKind, Panel, Profile, Stroke, profile_svg};
