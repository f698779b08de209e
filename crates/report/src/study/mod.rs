//! The page of a study, and its figures and tables.

mod figure;
mod page;
mod picture;
mod styles;
mod tables;

pub use figure::{Curve, MapData, Series, StudyFigure};
pub(crate) use page::study_html_in_units;
pub use page::{Grid, Head, StudyPage, StudyPart, Verdict, address, study_html};
pub use tables::StudyTable;
