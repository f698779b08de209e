//! The verdict on an operation for which a model has no result.

use std::fmt;

use wholestring::{
    statics::{soft::SoftError, stiff::StiffError},
    string::AssemblyError,
};

use crate::{Check, CheckKind, LimitSettings, Severity, Verdict};

/// Reason why a model has no result.
#[derive(Debug, Clone, PartialEq)]
pub enum NoAnswer {
    /// The string cannot reach from the surface to the depth of the bit.
    Assembly(AssemblyError),
    /// The soft string has no result.
    Soft(SoftError),
    /// The stiff string has no result.
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
        match error {
            StiffError::Soft(error) => Self::Soft(error),
            error => Self::Stiff(error),
        }
    }
}

impl NoAnswer {
    /// The verdict in a few words, for the cell of a table.
    pub const fn words(&self) -> &'static str {
        match self {
            Self::Assembly(_) => "does not fit",
            Self::Soft(SoftError::LocksUp { .. })
            | Self::Stiff(StiffError::LocksUp { .. } | StiffError::RunsAway { .. }) => "locks up",
            Self::Soft(_) => "not solved",
            Self::Stiff(StiffError::Rolls { .. }) => "no static equilibrium: whirls",
            Self::Stiff(StiffError::ElementBuckles { .. }) => "an element buckles",
            Self::Stiff(StiffError::ThroughWall { .. }) => "goes through the wall",
            Self::Stiff(_) => "did not converge",
        }
    }

    /// Whether the iterations ended without an equilibrium, though there may be one.
    pub(crate) const fn is_not_converged(&self) -> bool {
        matches!(self, Self::Stiff(StiffError::NotConverged { .. }))
    }

    /// The check without its sentence. A string that locks up has a factor of zero, because no push
    /// moves it.
    pub(crate) fn check(&self, settings: &LimitSettings) -> Check {
        let no_equilibrium = Check::reported(CheckKind::NoEquilibrium, Severity::Error);
        match self {
            Self::Soft(SoftError::LocksUp { md_m })
            | Self::Stiff(StiffError::LocksUp { md_m } | StiffError::RunsAway { md_m, .. }) => {
                let check = Check::reported(CheckKind::LockUp, Severity::Error).at(*md_m);
                Check {
                    verdict: Verdict::Exceeded,
                    factor: Some(0.0),
                    required: Some(settings.factors.lock_up),
                    ..check
                }
            }
            Self::Stiff(StiffError::Rolls { md_m, .. }) => no_equilibrium.at(*md_m),
            Self::Stiff(StiffError::ElementBuckles { md_m, compression_N, .. }) => {
                let check = Check::reported(CheckKind::ElementBuckles, Severity::Error);
                check.at(*md_m).value(*compression_N)
            }
            Self::Stiff(StiffError::ThroughWall { md_m, penetration_m, clearance_m }) => {
                let check = Check::reported(CheckKind::WallPenetration, Severity::Error);
                check.at(*md_m).value(*penetration_m).limit(*clearance_m)
            }
            Self::Stiff(StiffError::NotConverged { md_m, residual_N, .. }) => {
                no_equilibrium.at(*md_m).value(*residual_N).limit(0.0)
            }
            Self::Assembly(_) | Self::Soft(_) | Self::Stiff(StiffError::Soft(_)) => no_equilibrium,
        }
    }
}
