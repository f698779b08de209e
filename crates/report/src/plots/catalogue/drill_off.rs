//! Quantities drawn against the weight on bit.

use serde::Serialize;
use wholestring::outcome::{Quantity, TIME_SERIES};

use super::{Shows, declared};

/// A quantity of the bit against its weight.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct DrillOffPlot {
    #[serde(flatten)]
    pub(crate) shows: Shows,
    /// Heading on a page.
    pub(crate) heading: String,
    /// Minimum span of the axis, SI.
    pub(crate) min_span: f64,
}

/// The weight, then the quantities drawn against it.
pub(crate) fn drill_off_plots() -> [DrillOffPlot; 3] {
    let plot = |quantity: &'static Quantity, min_span| DrillOffPlot {
        heading: format!("{} against weight", quantity.label()),
        shows: Shows::of(quantity),
        min_span,
    };
    let torque = plot(declared!(TIME_SERIES, bit_torque_N_m), 500.0);
    [
        plot(declared!(TIME_SERIES, weight_on_bit_N), 1e4),
        plot(declared!(TIME_SERIES, rate_of_penetration_m_per_s), 5e-4),
        DrillOffPlot {
            heading: "Torque against weight".into(),
            shows: torque.shows.titled("Torque on bit"),
            ..torque
        },
    ]
}

/// The columns of `time.parquet` that are drawn against the first of them, the weight on bit.
pub(crate) fn drill_off_columns() -> [&'static str; 3] {
    drill_off_plots().map(|plot| plot.shows.column)
}
