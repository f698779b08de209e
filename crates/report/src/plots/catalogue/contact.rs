//! Quantities of maps of contact over depth and time.

use serde::Serialize;
use wholestring::outcome::CONTACT_MAP;

use super::{Shows, declared};

/// A map of contact.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct ContactPlot {
    /// Name of its file.
    #[serde(skip)]
    pub(crate) name: &'static str,
    #[serde(flatten)]
    pub(crate) shows: Shows,
    /// Whether its sign is a side of the hole.
    pub(crate) sides: bool,
    /// Minimum span of the axis of the history at one depth, SI.
    pub(crate) min_span: f64,
}

/// The maps, in the order of the choice; the first is initially shown.
pub(crate) fn contact_plots() -> [ContactPlot; 2] {
    let map = |name, quantity, sides| ContactPlot {
        name,
        shows: Shows::of(quantity),
        sides,
        min_span: 100.0,
    };
    [
        map("map-side-force", declared!(CONTACT_MAP, side_force_N_per_m), true),
        map("map-contact-force", declared!(CONTACT_MAP, contact_force_N_per_m), false),
    ]
}

/// The columns of `contact.parquet` that are drawn as maps.
pub(crate) fn contact_columns() -> [&'static str; 2] {
    contact_plots().map(|plot| plot.shows.column)
}
