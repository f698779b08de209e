//! Quantities of single nodes, of maps of contact over depth and time, and against the weight on
//! bit.

use serde::Serialize;
use wholestring::{
    dynamics::FRAME,
    outcome::{CONTACT_MAP, PROFILE, Quantity, TIME_SERIES},
};

use super::{Shows, declared};

/// A column of frames that the history of a node can show.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct NodeChannel {
    #[serde(flatten)]
    pub(crate) shows: Shows,
    /// Minimum span of the axis, SI.
    pub(crate) min_span: f64,
}

/// Quantities of a node's history, in the order of the choice. A page includes these columns of the
/// frames.
pub(crate) fn node_channels() -> Vec<NodeChannel> {
    [
        (declared!(FRAME, contact_force_N), 1000.0),
        (declared!(FRAME, tension_N), 2e4),
        (declared!(FRAME, torque_N_m), 500.0),
        (declared!(FRAME, rotary_speed_rad_per_s), 1.0),
        (declared!(FRAME, bending_moment_N_m), 500.0),
        (declared!(FRAME, offset_high_m), 0.005),
        (declared!(FRAME, offset_right_m), 0.005),
    ]
    .map(|(quantity, min_span)| NodeChannel { shows: Shows::of(quantity), min_span })
    .into()
}

/// The columns of `frames.parquet` that a page holds.
pub(crate) fn frame_columns() -> Vec<&'static str> {
    node_channels().iter().map(|channel| channel.shows.column).collect()
}

/// A quantity that can colour the string: a column of the frame, or on average of the profile.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct StringColour {
    #[serde(flatten)]
    pub(crate) shows: Shows,
    /// Whether its sign is a side of the hole.
    signed: bool,
}

/// Quantities that can colour the string, in the order of the choice.
pub(crate) fn string_colours() -> Vec<StringColour> {
    let side =
        |quantity: &'static Quantity| StringColour { shows: Shows::of(quantity), signed: true };
    let amount = |quantity| StringColour { signed: false, ..side(quantity) };
    let titled =
        |colour: StringColour, title| StringColour { shows: colour.shows.titled(title), ..colour };
    vec![
        titled(side(declared!(PROFILE, side_force_N_per_m)), "Side force, by side"),
        side(declared!(FRAME, contact_force_N)),
        amount(declared!(FRAME, tension_N)),
        amount(declared!(FRAME, torque_N_m)),
        amount(declared!(FRAME, bending_moment_N_m)),
        amount(declared!(FRAME, rotary_speed_rad_per_s)),
        amount(declared!(PROFILE, von_mises_stress_max_Pa)),
        titled(amount(declared!(PROFILE, contact_fraction)), "Share of time in contact"),
    ]
}

// Quantities of maps of contact over depth and time.

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

// Quantities drawn against the weight on bit.

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
