//! Drawing of a case while it is edited, valid or not.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::Parts;

use crate::{
    answers::{Component, PathView, Section},
    survey::{Start, Stations},
};

/// Survey, path, hole and string.
#[derive(Debug, Serialize, ToSchema)]
pub struct Layout {
    /// The stations, from the case or from its file.
    stations: Stations,
    /// Position of the first station, if the survey's file gives it.
    tie_in: Option<Start>,
    /// The path through them; null if there is none.
    path: Option<PathView>,
    /// Sections of the hole, from the surface down.
    hole: Vec<Section>,
    /// Components of the string, from the surface down; empty if one of them is invalid.
    string: Vec<Component>,
}

impl Layout {
    pub(super) fn of(parts: Parts) -> Self {
        let Parts { stations, tie_in, path, hole, string, bit_depth_m } = parts;
        let sections = hole.iter().flat_map(|hole| hole.sections());
        let string = string.zip(bit_depth_m);
        Self {
            stations: Stations::of(&stations),
            tie_in: tie_in.map(Start::from),
            path: path.as_ref().map(PathView::of),
            hole: sections.map(Section::of).collect(),
            string: string.map_or_else(Vec::new, |(string, bit_m)| Component::all(&string, bit_m)),
        }
    }
}
