//! Pictures of what a run leaves, as SVG.
#![warn(missing_docs)]

mod axis;
mod colours;
mod profile;

pub use profile::{Curve, Entry, Interval, IntervalKind, Panel, Profile, Stroke, profile_svg};
