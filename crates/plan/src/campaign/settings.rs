//! What a campaign consists of.

use wholestring::{
    operation::{Operation, OperationKind},
    well::{Hole, HoleKind},
};

use crate::{
    fatigue::FatigueSettings,
    lengths_m,
    wear::{CasingError, CasingWear, WearFactors},
};

/// How often and how long the operations of a plan are carried out, and what they are held against.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct CampaignSettings {
    /// Measured depth from which the section is drilled, m. Default: the deepest casing shoe.
    pub drilled_from_m: Option<f64>,
    /// How often the string is run and pulled. Default 1.
    pub round_trips: f64,
    /// How long it turns off bottom at the deepest depth, s. Default none.
    pub off_bottom_s: f64,
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
            fatigue: FatigueSettings::default(),
            wear_factors: WearFactors::default(),
        }
    }
}

/// A campaign of the operations of a plan.
#[derive(Debug, Clone)]
pub struct Campaign {
    pub(super) fatigue: FatigueSettings,
    /// The casings before anything wore them.
    pub(super) new: CasingWear,
    /// What drills the section: the first operation on bottom that turns the string, or else the first on
    /// bottom.
    drills: Option<OperationKind>,
    depths_m: Vec<f64>,
    drilled_m: Vec<f64>,
    tripped_m: Vec<f64>,
    round_trips: f64,
    off_bottom_s: f64,
}

impl Campaign {
    /// Of some operations at growing depths of the bit, m.
    ///
    /// # Errors
    /// Those of [`CasingWear::new`].
    pub fn new(
        settings: &CampaignSettings,
        hole: &Hole,
        operations: &[Operation],
        bit_depths_m: &[f64],
    ) -> Result<Self, CasingError> {
        let cased = hole.sections().iter().filter(|of| of.kind == HoleKind::Casing);
        let shoe_m = cased.map(|of| of.to_md_m).fold(0.0, f64::max);
        let from_m = settings.drilled_from_m.unwrap_or(shoe_m);
        let on_bottom = || operations.iter().map(|of| of.kind).filter(|of| of.on_bottom());
        Ok(Self {
            fatigue: settings.fatigue,
            new: CasingWear::new(hole, &settings.wear_factors)?,
            drills: on_bottom().find(|of| of.rotates()).or_else(|| on_bottom().next()),
            depths_m: bit_depths_m.to_vec(),
            drilled_m: lengths_m(bit_depths_m, from_m),
            tripped_m: lengths_m(bit_depths_m, 0.0),
            round_trips: settings.round_trips,
            off_bottom_s: settings.off_bottom_s,
        })
    }

    /// Whether an operation drills the last of the section.
    pub(super) fn is_last_drilling(&self, operation: &Operation) -> bool {
        Some(operation.kind) == self.drills && self.depths_m.last() == Some(&operation.bit_depth_m)
    }

    /// How long an operation goes on at its depth of the bit, s; none where it is no part of the campaign.
    pub(super) fn duration_s(&self, operation: &Operation) -> Option<f64> {
        let place = self.depths_m.iter().position(|of| *of == operation.bit_depth_m)?;
        let at = |length_m: f64| {
            let speed_m_per_s = operation.axial_velocity_m_per_s().abs();
            (speed_m_per_s > 0.0).then(|| length_m / speed_m_per_s)
        };
        let duration_s = match operation.kind {
            kind if Some(kind) == self.drills => at(self.drilled_m[place]),
            OperationKind::TripIn | OperationKind::TripOut => {
                at(self.round_trips * self.tripped_m[place])
            }
            OperationKind::RotateOffBottom if place + 1 == self.depths_m.len() => {
                Some(self.off_bottom_s)
            }
            _ => None,
        };
        duration_s.filter(|of| *of > 0.0)
    }

    /// How long an operation goes on at all depths of the campaign that are nearest to its own, among these, m:
    /// of one that is looked at there alone. None where it is no part of the campaign.
    pub(crate) fn duration_near_s(&self, operation: &Operation, among_m: &[f64]) -> Option<f64> {
        let nearest = |depth_m: f64| {
            let far = |of: &&f64| (**of - depth_m).abs();
            among_m.iter().min_by(|a, b| far(a).total_cmp(&far(b))).copied()
        };
        let at = |depth_m: &f64| {
            let operation = Operation { bit_depth_m: *depth_m, ..*operation };
            self.duration_s(&operation)
        };
        let near = self.depths_m.iter().filter(|of| nearest(**of) == Some(operation.bit_depth_m));
        let all_s: f64 = near.filter_map(at).sum();
        Some(all_s).filter(|of| *of > 0.0)
    }
}
