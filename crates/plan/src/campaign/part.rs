//! A part of a campaign.

use wholestring::operation::OperationKind;

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
