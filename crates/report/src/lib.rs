//! Pictures of what a run leaves: its profile as SVG, and all of it as a page.
#![warn(missing_docs)]

mod axis;
mod canvas;
mod chart;
mod colours;
mod legend;
mod line;
mod packed;
mod page;
mod profile;
mod report;
mod study;
mod thin;

pub use chart::{Chart, Level, Scale, chart_svg};
pub use packed::Packed;
pub use page::report_html;
pub use profile::{Curve, Entry, Interval, IntervalKind, Panel, Profile, Stroke, profile_svg};
pub use report::{
    Answer, Cell, ContactPicture, DisplayUnit, Fact, Frames, Part, Place, Report, Section, Sheet,
    Solved, TimeRun, Well,
};
pub use study::{Grid, StudyPage, StudyPart, Verdict, study_html};
pub use thin::thinned;
