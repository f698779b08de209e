//! A point of a broomstick.

use std::fmt;

use serde::Serialize;
use wholestring::{
    findings::Finding,
    operation::OperationKind,
    outcome::{Buckling, ModelKind, Profile, Scalars},
    statics::{soft::SoftError, stiff::StiffError},
    string::AssemblyError,
};

use super::FrictionLevel;
use crate::{Share, limits::Limits};

/// The models that a plan is made by: states of equilibrium, which take milliseconds to seconds.
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

    /// Which of the engine's models it is.
    pub const fn kind(self) -> ModelKind {
        match self {
            Self::Soft => ModelKind::Soft,
            Self::Stiff => ModelKind::Stiff,
        }
    }

    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        self.kind().method().name
    }
}

/// Why a point has no answer.
#[derive(Debug, Clone, PartialEq)]
pub enum NoAnswer {
    /// The string cannot be as long as the bit is deep.
    Assembly(AssemblyError),
    /// The soft string has none.
    Soft(SoftError),
    /// The stiff string has none.
    Stiff(StiffError),
}

impl fmt::Display for NoAnswer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Assembly(error) => error.fmt(f),
            Self::Soft(error) => error.fmt(f),
            Self::Stiff(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for NoAnswer {}

impl From<AssemblyError> for NoAnswer {
    fn from(error: AssemblyError) -> Self {
        Self::Assembly(error)
    }
}

impl From<SoftError> for NoAnswer {
    fn from(error: SoftError) -> Self {
        Self::Soft(error)
    }
}

impl From<StiffError> for NoAnswer {
    fn from(error: StiffError) -> Self {
        Self::Stiff(error)
    }
}

/// One operation at one depth with one friction.
#[derive(Debug, Clone, PartialEq)]
pub struct BroomstickPoint {
    /// The model that solved it.
    pub model: Statics,
    /// How much friction there is.
    pub friction: FrictionLevel,
    /// What is done.
    pub operation: OperationKind,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// What came of it, or why nothing did.
    pub outcome: Result<PointAnswer, NoAnswer>,
}

/// What came of a point.
#[derive(Debug, Clone, PartialEq)]
pub struct PointAnswer {
    /// Torque and drag.
    pub scalars: Scalars,
    /// What compression makes of the string where it makes most of it.
    pub buckling: Buckling,
    /// What is to be reported of it, the gravest first.
    pub findings: Vec<Finding>,
    /// How near it is to what string and rig bear.
    pub limits: Limits,
    /// What it takes of string and casing; none where it is no part of a campaign.
    pub share: Option<Share>,
}

impl PointAnswer {
    pub(super) fn new(
        scalars: Scalars,
        profile: &Profile,
        findings: Vec<Finding>,
        limits: Limits,
        share: Option<Share>,
    ) -> Self {
        let rows = 0..profile.md_m.len();
        let buckling = rows.map(|row| profile.buckling(row)).max().unwrap_or(Buckling::None);
        Self { scalars, buckling, findings, limits, share }
    }
}
