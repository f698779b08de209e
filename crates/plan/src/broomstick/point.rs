//! A point of a broomstick.

use serde::Serialize;
use wholestring::{
    operation::OperationKind,
    outcome::{Buckling, ModelKind, Profile, Scalars},
};
use wholestring_judge::{Checks, NoAnswer};

use crate::{FrictionLevel, Setup, Share};

/// The models of a plan: states of equilibrium, which take milliseconds to seconds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub enum Statics {
    /// Without bending stiffness.
    Soft,
    /// With bending stiffness and clearance.
    Stiff,
}

impl Statics {
    /// Every one, the fastest first.
    pub const ALL: [Self; 2] = [Self::Soft, Self::Stiff];

    /// Returns the engine's model.
    pub const fn kind(self) -> ModelKind {
        match self {
            Self::Soft => ModelKind::Soft,
            Self::Stiff => ModelKind::Stiff,
        }
    }

    /// Returns the name in case files and results.
    pub const fn name(self) -> &'static str {
        self.kind().method().name
    }
}

/// One operation at one depth with one friction.
#[derive(Debug, Clone, PartialEq)]
pub struct BroomstickPoint {
    /// The model that solved it.
    pub model: Statics,
    /// Friction level.
    pub friction: FrictionLevel,
    /// The operation.
    pub operation: OperationKind,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// The result, or the reason why there is none.
    pub outcome: Result<PointAnswer, NoAnswer>,
    /// The checks of the result, or the verdict that there is none.
    pub checks: Checks,
}

/// The result of a point.
#[derive(Debug, Clone, PartialEq)]
pub struct PointAnswer {
    /// Torque and drag.
    pub scalars: Scalars,
    /// Buckling of the string where it is most severe.
    pub buckling: Buckling,
    /// Share of the campaign in wear and damage; `None` where the point is no part of a campaign.
    pub share: Option<Share>,
}

impl PointAnswer {
    pub(super) fn new(scalars: Scalars, profile: &Profile, share: Option<Share>) -> Self {
        let rows = 0..profile.md_m.len();
        let buckling = rows.map(|row| profile.buckling(row)).max().unwrap_or(Buckling::None);
        Self { scalars, buckling, share }
    }
}

// Depths of the bit.

/// Depths closer than this are one, m.
const SAME_M: f64 = 1.0;

/// Returns this number of depths of the bit, m, evenly from one to another, and the lower ends of
/// hole sections between them. Without the first they begin where drill pipe does: with the
/// bottom-hole assembly in the hole and little more.
pub fn bit_depths_m(setup: &Setup, from_m: Option<f64>, to_m: f64, count: usize) -> Vec<f64> {
    let from_m = from_m.unwrap_or_else(|| setup.shallowest_m()).min(to_m);
    let steps = count.max(2) - 1;
    // The ends are returned unchanged.
    let place = |step: usize| match step {
        0 => from_m,
        step if step == steps => to_m,
        step => from_m + (to_m - from_m) * step as f64 / steps as f64,
    };
    let ends = setup.well.hole.sections().iter().map(|section| section.to_md_m);
    let ends: Vec<f64> =
        ends.filter(|end| *end > from_m + SAME_M && *end < to_m - SAME_M).collect();
    // A section's end replaces an even depth close to it.
    let taken = |depth: f64| ends.iter().any(|end| (end - depth).abs() < SAME_M);
    let even = (0..=steps).map(place).filter(|depth| !taken(*depth));
    let mut depths_m: Vec<f64> = even.chain(ends.iter().copied()).collect();
    depths_m.sort_by(f64::total_cmp);
    depths_m.dedup_by(|a, b| (*a - *b).abs() < SAME_M);
    if let Some(last) = depths_m.last_mut() {
        *last = to_m;
    }
    depths_m
}
