//! Contents of the page of weights picked from a log, and its pictures.

mod figures;
mod page;

pub use figures::{picked_depth_figure, picked_log_figure, picked_stand_figure};
pub use page::picks_html;

use wholestring::operation::OperationKind;

use crate::{PageHead, figure::Ink, operation_colour::operation_colour};

/// Weights picked from a log as their page shows them. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct PickedLog {
    /// Head of the page, under the name of the log.
    pub head: PageHead,
    /// The whole log.
    pub trace: PickedTrace,
    /// The picked windows, in the order of the log.
    pub windows: Vec<PickedWindow>,
    /// Some stands.
    pub stands: Vec<PickedStand>,
    /// Hook load in slips, N.
    pub slips_N: Option<f64>,
    /// Force added to logged hook loads, N: the block's weight, where the sensor was set to zero
    /// with it.
    pub added_N: f64,
    /// Interpretation of the log, in sentences.
    pub notes: Vec<String>,
}

/// Points of a log, s and SI.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PickedTrace {
    /// Height of the block.
    pub block: Vec<(f64, f64)>,
    /// Measured depth of the bit.
    pub bit_depth: Vec<(f64, f64)>,
    /// Logged hook load.
    pub hook_load: Vec<(f64, f64)>,
    /// Torque.
    pub torque: Vec<(f64, f64)>,
    /// Rotary speed.
    pub rotary: Vec<(f64, f64)>,
}

/// Purpose of a window.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PickedKind {
    /// The hook load while the string is pulled out.
    PickUp,
    /// The hook load while it is run in.
    SlackOff,
    /// Hook load and torque while it rotates off bottom.
    Rotating,
    /// The torque while it drills.
    Drilling,
}

impl PickedKind {
    const ALL: [Self; 4] = [Self::SlackOff, Self::Rotating, Self::PickUp, Self::Drilling];

    fn words(self) -> &'static str {
        match self {
            Self::PickUp => "pick-up",
            Self::SlackOff => "slack-off",
            Self::Rotating => "rotating off bottom",
            Self::Drilling => "drilling",
        }
    }

    /// Its colour, which is that of the operation on a plan's broomstick.
    fn ink(self) -> Ink {
        let operation = match self {
            Self::PickUp => OperationKind::TripOut,
            Self::SlackOff => OperationKind::TripIn,
            Self::Rotating => OperationKind::RotateOffBottom,
            Self::Drilling => OperationKind::Drill,
        };
        Ink::Line(operation_colour(operation))
    }
}

/// A value and its standard error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PickedValue {
    /// The value; a weight includes the block.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
}

/// A window and its picked values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PickedWindow {
    /// Purpose of the window.
    pub kind: PickedKind,
    /// The stand.
    pub stand: usize,
    /// Beginning and end, s.
    pub time_s: [f64; 2],
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Speed of the block, positive upwards, m/s.
    pub speed_m_per_s: f64,
    /// Rotary speed, rad/s.
    pub rotary_rad_per_s: f64,
    /// Hook load, N.
    pub weight_N: Option<PickedValue>,
    /// Torque, N·m.
    pub torque_N_m: Option<PickedValue>,
}

/// A stand from slips to slips.
#[derive(Debug, Clone, PartialEq)]
pub struct PickedStand {
    /// Its number.
    pub stand: usize,
    /// Work done with it: `drilled`.
    pub work: String,
    /// Its log.
    pub trace: PickedTrace,
    /// The windows picked from it.
    pub windows: Vec<PickedWindow>,
    /// Rejected windows: purpose, beginning and end, s, and reason.
    pub refused: Vec<(PickedKind, [f64; 2], String)>,
}
