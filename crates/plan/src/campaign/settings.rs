//! Settings of a campaign.

use wholestring::operation::Operation;

use crate::{fatigue::FatigueSettings, wear::WearFactors};

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
