//! Drawn quantities of a run: one list for the page and for the files. The selection, order and
//! form are chosen here; name and unit of each are in its declaration.

mod node;
mod time_plots;
mod tracks;

use serde::Serialize;
use wholestring::{
    dynamics::NodeSignal,
    outcome::{Quantity, QuantityKind, Signal},
};

pub(crate) use self::{
    node::{NodeChannel, StringColour, frame_columns, node_channels, string_colours},
    time_plots::{TimePlot, bit_plots, time_plots},
    tracks::{Source, Track, tracks},
};
use super::near::JOINT_REACH_M;
use crate::figure::{OUTLIERS, Outliers};
pub(crate) use node::{
    ContactPlot, DrillOffPlot, contact_columns, contact_plots, drill_off_columns, drill_off_plots,
};

/// Rules for drawing tracks, on the page and in files alike.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct Rules {
    /// Length of string in view, m, above which joints are too many to distinguish.
    pub(crate) far_m: f64,
    /// Half of the distance between joints, and a little, m.
    pub(crate) joint_reach_m: f64,
    /// A curve is distinguishable from another where they differ by this part of the largest value
    /// somewhere.
    pub(crate) min_difference: f64,
    /// Values that no axis reaches.
    pub(crate) outliers: Outliers,
}

pub(crate) const RULES: Rules =
    Rules { far_m: 400.0, joint_reach_m: JOINT_REACH_M, min_difference: 0.01, outliers: OUTLIERS };

/// The declaration of a column; a column that does not exist is a compile error.
macro_rules! declared {
    ($list:ident, $column:ident) => {{
        const DECLARED: &wholestring::outcome::Quantity =
            wholestring::outcome::Column::declared($list, stringify!($column));
        DECLARED
    }};
}
use declared;

/// The dimension in which pages and pictures show a kind of quantity: shares in percent, radial
/// lengths as diameters.
pub fn shown_dimension(kind: QuantityKind) -> &'static str {
    match kind {
        QuantityKind::Ratio => "percent",
        QuantityKind::Length => "diameter",
        other => other.dimension(),
    }
}

/// The dimension of a signal, of nodes or of the whole string, by its declaration; `None` for a
/// signal that this version does not know.
pub(crate) fn spectrum_dimension(signal: &str, of_nodes: bool) -> Option<&'static str> {
    let quantity = if of_nodes {
        let found = NodeSignal::ALL.into_iter().find(|candidate| candidate.name() == signal);
        found?.quantity()
    } else {
        Signal::ALL.into_iter().find(|candidate| candidate.name() == signal)?.quantity()
    };
    Some(match quantity.kind {
        // Vibration has another dimension than a trip speed.
        QuantityKind::Speed => "lateral speed",
        // A length of the whole string is its stretch; nodes move laterally.
        QuantityKind::Length if !of_nodes => "length",
        other => shown_dimension(other),
    })
}

/// Data that a picture takes from the declaration of its quantity.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Shows {
    /// Name of the column.
    pub(crate) column: &'static str,
    pub(crate) title: String,
    pub(crate) dimension: &'static str,
}

impl Shows {
    fn of(quantity: &'static Quantity) -> Self {
        Self {
            column: quantity.name,
            title: quantity.label(),
            dimension: shown_dimension(quantity.kind),
        }
    }

    /// The same with a title that is more specific to the picture.
    fn titled(self, title: &str) -> Self {
        Self { title: title.into(), ..self }
    }
}
