//! Operations of a campaign, with their depths and durations.

use wholestring::{
    operation::{Operation, OperationKind},
    well::HoleKind,
};

use super::{CampaignPart, CampaignSettings};
use crate::{
    Setup,
    fatigue::FatigueSettings,
    lengths_m,
    wear::{CasingError, CasingWear},
};

/// Number of parts of the depth range: a campaign adds depths where those of its plan are more than
/// one part apart.
const PARTS: f64 = 20.0;

/// Depths closer than this are one, m.
const SAME_M: f64 = 1.0;

/// A campaign of the operations of a plan.
#[derive(Debug, Clone)]
pub struct Campaign {
    pub(super) fatigue: FatigueSettings,
    /// The casings before wear.
    pub(super) new: CasingWear,
    /// The operations of the plan, and those that it does not list.
    operations: Vec<Operation>,
    /// The drilling operation: the first on bottom that turns the string, or else the first on
    /// bottom.
    drills: Option<OperationKind>,
    /// Depths of the bit, m, increasing: those of the plan, and others above and between them.
    depths_m: Vec<f64>,
    drilled_from_m: f64,
    drilled_m: Vec<f64>,
    tripped_m: Vec<f64>,
    round_trips: f64,
    off_bottom_s: f64,
}

impl Campaign {
    /// Returns a campaign of the operations of a plan at increasing depths of the bit, m. An
    /// operation that the campaign needs and the plan does not list is taken from its settings,
    /// with precedence for the plan's own. The campaign adds depths above the shallowest depth of
    /// the plan, from where the assembly is in the hole, and between depths that are far apart; the
    /// shallowest of all represents the hole above it.
    ///
    /// # Errors
    /// Those of [`CasingWear::new`].
    pub fn new(
        settings: &CampaignSettings,
        setup: &Setup,
        planned: &[Operation],
        bit_depths_m: &[f64],
    ) -> Result<Self, CasingError> {
        let hole = &setup.well.hole;
        let cased = hole.sections().iter().filter(|section| section.kind == HoleKind::Casing);
        let shoe_m = cased.map(|section| section.to_md_m).fold(0.0, f64::max);
        let drilled_from_m = settings.drilled_from_m.unwrap_or(shoe_m);
        let is_planned =
            |operation: &&Operation| planned.iter().any(|other| other.kind == operation.kind);
        let others: Vec<Operation> =
            settings.operations.iter().filter(|own| !is_planned(own)).copied().collect();
        let depths_m = depths_m(setup, bit_depths_m);
        Ok(Self {
            fatigue: settings.fatigue,
            new: CasingWear::new(hole, &settings.wear_factors)?,
            drills: drilling(planned).or_else(|| drilling(&others)),
            operations: planned.iter().copied().chain(others).collect(),
            drilled_m: lengths_m(&depths_m, drilled_from_m),
            tripped_m: lengths_m(&depths_m, 0.0),
            depths_m,
            drilled_from_m,
            round_trips: settings.round_trips,
            off_bottom_s: settings.off_bottom_s,
        })
    }

    /// Returns the depth of the bit, m, above which an operation is not done: the hole is drilled,
    /// slid and reamed from where the section begins. `None` of other operations, and of a hole in
    /// which nothing is drilled.
    pub fn done_from_m(&self, kind: OperationKind) -> Option<f64> {
        let is_in_section =
            kind.on_bottom() || matches!(kind, OperationKind::Ream | OperationKind::BackReam);
        let deepest_m = self.depths_m.last().copied().unwrap_or(0.0);
        (is_in_section && self.drilled_from_m < deepest_m).then_some(self.drilled_from_m)
    }

    /// Returns the settings of the fatigue model.
    pub fn fatigue_settings(&self) -> &FatigueSettings {
        &self.fatigue
    }

    /// Returns every operation that is a part of the campaign, with the depth of its bit.
    pub fn operations(&self) -> impl Iterator<Item = Operation> + '_ {
        let depths = |operation: &Operation| {
            let operation = *operation;
            let depths_m = self.depths_m.iter();
            depths_m.map(move |bit_depth_m| Operation { bit_depth_m: *bit_depth_m, ..operation })
        };
        let all = self.operations.iter().flat_map(depths);
        all.filter(|operation| self.duration_s(operation).is_some())
    }

    /// Returns the parts of the campaign, counted or not.
    pub fn parts(&self) -> Vec<CampaignPart> {
        use OperationKind::{RotateOffBottom, TripIn, TripOut};
        let deepest_m = self.depths_m.last().copied().unwrap_or(0.0);
        let part = |kind: Option<OperationKind>, from_m: f64, length_m: f64| {
            let own = self.operations.iter().find(|operation| Some(operation.kind) == kind);
            let speed = own.map(|operation| operation.axial_velocity_m_per_s().abs());
            let duration_s = speed.filter(|speed| *speed > 0.0).map(|speed| length_m / speed);
            let operation = own.map(|operation| operation.kind);
            CampaignPart { drills: false, operation, from_m, to_m: deepest_m, duration_s }
        };
        let mut parts = Vec::new();
        if self.drilled_from_m < deepest_m {
            let length_m = deepest_m - self.drilled_from_m;
            let drilled = part(self.drills, self.drilled_from_m, length_m);
            parts.push(CampaignPart { drills: true, ..drilled });
        }
        if self.round_trips > 0.0 {
            let length_m = self.round_trips * deepest_m;
            parts.extend([TripIn, TripOut].map(|kind| part(Some(kind), 0.0, length_m)));
        }
        if self.off_bottom_s > 0.0 {
            let turns = part(Some(RotateOffBottom), deepest_m, 0.0);
            let duration_s = turns.operation.map(|_| self.off_bottom_s);
            parts.push(CampaignPart { duration_s, ..turns });
        }
        parts
    }

    /// Whether an operation drills the last of the section.
    pub(super) fn is_last_drilling(&self, operation: &Operation) -> bool {
        Some(operation.kind) == self.drills && self.depths_m.last() == Some(&operation.bit_depth_m)
    }

    /// Returns the duration of an operation at its depth of the bit, s; `None` where it is no part
    /// of the campaign.
    pub fn duration_s(&self, operation: &Operation) -> Option<f64> {
        let place = self.depths_m.iter().position(|depth| *depth == operation.bit_depth_m)?;
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
        duration_s.filter(|duration_s| *duration_s > 0.0)
    }

    /// Returns the duration of an operation at all depths of the campaign that are nearest to its
    /// own, among these, m, for an operation that is evaluated there only. `None` where it is no
    /// part of the campaign.
    pub(crate) fn duration_near_s(&self, operation: &Operation, among_m: &[f64]) -> Option<f64> {
        let nearest = |depth_m: f64| {
            let far = |other_m: &&f64| (**other_m - depth_m).abs();
            among_m.iter().min_by(|a, b| far(a).total_cmp(&far(b))).copied()
        };
        let at = |depth_m: &f64| {
            let operation = Operation { bit_depth_m: *depth_m, ..*operation };
            self.duration_s(&operation)
        };
        let is_near = |depth_m: &&f64| nearest(**depth_m) == Some(operation.bit_depth_m);
        let all_s: f64 = self.depths_m.iter().filter(is_near).filter_map(at).sum();
        Some(all_s).filter(|all_s| *all_s > 0.0)
    }
}

/// Returns the drilling operation among some: the first on bottom that turns the string, or else
/// the first on bottom.
fn drilling(operations: &[Operation]) -> Option<OperationKind> {
    let on_bottom = || operations.iter().map(|own| own.kind).filter(|kind| kind.on_bottom());
    on_bottom().find(|kind| kind.rotates()).or_else(|| on_bottom().next())
}

/// Returns the depths of the bit of a campaign, m: those of a plan, and others above and between
/// them such that no two are farther apart than one of the [`PARTS`], from where the assembly is in
/// the hole.
fn depths_m(setup: &Setup, bit_depths_m: &[f64]) -> Vec<f64> {
    let Some(last_m) = bit_depths_m.last() else { return Vec::new() };
    let apart_m = last_m / PARTS;
    let mut above_m = setup.shallowest_m();
    let mut depths_m = Vec::new();
    for depth_m in bit_depths_m {
        let way_m = depth_m - above_m;
        // The campaign adds a shallowest depth where the plan's is deeper.
        if depths_m.is_empty() && way_m >= SAME_M {
            depths_m.push(above_m);
        }
        let count = (way_m / apart_m).ceil().max(1.0) as usize;
        let between_m = (1..count).map(|step| above_m + way_m * step as f64 / count as f64);
        depths_m.extend(between_m);
        depths_m.push(*depth_m);
        above_m = *depth_m;
    }
    depths_m
}
