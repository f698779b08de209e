//! Effects of all operations of a plan together on string and casing.
//!
//! The section is drilled from a depth to the deepest of the bit; the string is pulled and run, and
//! turns off bottom at the end. Each solved operation has its [`Share`], and the shares of all add
//! up.

mod schedule;
mod share;

pub use schedule::Campaign;
pub use share::Share;

use wholestring::operation::{Operation, OperationKind};

use crate::{fatigue::FatigueSettings, wear::WearFactors};

// Settings of a campaign.

/// Number and duration of the operations of a plan, and the properties for wear and fatigue.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct CampaignSettings {
    /// Measured depth from which the section is drilled, m. Default: the deepest casing shoe.
    pub drilled_from_m: Option<f64>,
    /// Number of times that the string is run and pulled. Default 1.
    pub round_trips: f64,
    /// Duration of rotation off bottom at the deepest depth, s. Default none.
    pub off_bottom_s: f64,
    /// Operations with their set points, of which the campaign uses those that it needs and the
    /// plan does not list. Default none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub operations: Vec<Operation>,
    /// Fatigue of the string.
    pub fatigue: FatigueSettings,
    /// Wear factors of the casings.
    pub wear_factors: WearFactors,
}

impl Default for CampaignSettings {
    fn default() -> Self {
        Self {
            drilled_from_m: None,
            round_trips: 1.0,
            off_bottom_s: 0.0,
            operations: Vec::new(),
            fatigue: FatigueSettings::default(),
            wear_factors: WearFactors::default(),
        }
    }
}

// A part of a campaign.

/// A part of a campaign: all that one operation does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CampaignPart {
    /// Whether it drills the section.
    pub drills: bool,
    /// The operation; `None` where neither the plan nor the case has one for it.
    pub operation: Option<OperationKind>,
    /// Measured depth where it begins, m.
    pub from_m: f64,
    /// Measured depth where it ends, m.
    pub to_m: f64,
    /// Duration, s; `None` where it is not counted: without an operation, or with one that has no
    /// speed.
    pub duration_s: Option<f64>,
}
