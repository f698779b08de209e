//! Quantities of single nodes, and quantities that colour the string in space.

use serde::Serialize;
use wholestring::{
    dynamics::FRAME,
    outcome::{PROFILE, Quantity},
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
    pub(crate) signed: bool,
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
