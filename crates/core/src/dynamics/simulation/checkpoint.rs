//! A run written to a checkpoint and resumed, to the bit.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::{run::Run, state::State};
use crate::{
    damage::Damaged,
    dynamics::{
        assemble::{SetupError, basis::Basis},
        boundary::extension::AnotherExtension,
        kernel::chain::Chain,
        settings::DynamicsSettings,
    },
    model::Model,
    operation::Operation,
    simd::wide::Registers,
};

/// Everything of a run that changes in time, as plain data; everything that follows from the model,
/// the operation and the settings is computed anew.
///
/// [`Simulation::resume`](crate::dynamics::Simulation::resume) continues from it and ends with the
/// same bits as the run that was never written to a checkpoint, in double precision on any
/// processor, in single on one that [fuses](Self::is_fused) alike. One that has just been taken
/// borrows from the run; one that has been read back is its own.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Checkpoint<'a> {
    /// In double precision, which holds single precision to the bit.
    chain: Chain,
    state: Cow<'a, State>,
    time_s: f64,
    is_fused: bool,
}

/// Why a run cannot be resumed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ResumeError {
    /// The run could not have begun either.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The checkpoint is that of another string or another mesh.
    #[error("the checkpoint is that of {found} nodes, the string has {expected}")]
    AnotherString {
        /// Nodes of the checkpoint.
        found: usize,
        /// Nodes that the model and the settings require.
        expected: usize,
    },
    /// The checkpoint is that of a run in another precision.
    #[error("the checkpoint is that of a run in another precision")]
    AnotherPrecision,
    /// The checkpoint is that of a run with another law or controller of the caller's own.
    #[error(transparent)]
    AnotherExtension(#[from] AnotherExtension),
    /// The data of the checkpoint are inconsistent, or do not match the model.
    #[error("the checkpoint cannot be continued: {0}")]
    Damaged(#[from] Damaged),
}

impl Checkpoint<'_> {
    /// Time since the start of the run, s.
    pub fn time_s(&self) -> f64 {
        self.time_s
    }

    /// The same, of its own: the run may continue.
    pub fn into_owned(self) -> Checkpoint<'static> {
        Checkpoint {
            chain: self.chain,
            state: Cow::Owned(self.state.into_owned()),
            time_s: self.time_s,
            is_fused: self.is_fused,
        }
    }

    /// Whether the run was computed with fused multiply-add.
    pub fn is_fused(&self) -> bool {
        self.is_fused
    }
}

impl<R: Registers> Run<R> {
    /// The present state of the run, to be written to a checkpoint: between two calls of
    /// [`Self::advance`], at any time.
    pub fn checkpoint(&self) -> Checkpoint<'_> {
        Checkpoint {
            chain: self.chain.converted(),
            state: Cow::Borrowed(&self.state),
            time_s: self.time_s(),
            is_fused: self.is_fused(),
        }
    }

    /// Resumes a run where [`Self::checkpoint`] left it. Model, operation and settings are those
    /// that it began with: others would continue, but with an answer to neither case.
    ///
    /// # Errors
    /// A checkpoint of another string, or a run that could not have begun.
    pub fn resume(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        checkpoint: Checkpoint<'_>,
    ) -> Result<Self, ResumeError> {
        let basis = Basis::new(model, operation, settings)?;
        Self::continued(model, operation, settings, basis, checkpoint)
    }

    /// The same, from the data that follow from its input.
    pub(super) fn continued(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        mut basis: Basis<R>,
        checkpoint: Checkpoint<'_>,
    ) -> Result<Self, ResumeError> {
        let (found, expected) = (checkpoint.chain.nodes(), basis.mesh.nodes.len());
        if found != expected {
            return Err(ResumeError::AnotherString { found, expected });
        }
        let pattern = basis.mesh.nodes_per_joint();
        checkpoint.chain.check(expected, pattern, basis.border())?;
        let chain = checkpoint.chain.converted::<R>();
        if checkpoint.state.record.layout() != chain.layout() {
            return Err(ResumeError::AnotherPrecision);
        }
        let mut state = checkpoint.state.into_owned();
        state.attach(settings)?;
        state.check(model, settings, &basis.mesh, &chain)?;
        if let Some(friction) = &state.hole_friction
            && let Ok(hole) = friction.hole(&model.well.hole)
        {
            basis.borehole.resume_friction_of(hole);
        }
        Ok(Self::of(model, operation, settings, basis, chain, state))
    }
}
