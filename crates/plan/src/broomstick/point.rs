//! A point of a broomstick.

use serde::Serialize;
use wholestring::{
    operation::OperationKind,
    outcome::{Buckling, ModelKind, Profile, Scalars},
};
use wholestring_judge::{Checks, NoAnswer};

use crate::{FrictionLevel, Share};

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
