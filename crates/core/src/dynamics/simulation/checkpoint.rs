//! A run laid aside and taken up again, to the bit.

use serde::{Deserialize, Serialize};

use super::{Ledger, Record, Run, SinceSample};
use crate::{
    dynamics::{
        assembly::Anchor,
        bit::Bit,
        body::Body,
        chain::{Chain, Rows},
        hoist::Hoist,
        layout::Layout,
        schedule::SetPoints,
        settings::DynamicsSettings,
        setup::{Basis, SetupError},
        top_drive::TopDrive,
        viscous::Viscous,
        wear::Wear,
    },
    model::Model,
    operation::Operation,
    rod::number::Real,
};

/// Everything of a run that changes while it goes on, as plain data; what the model, the operation and
/// the settings determine is found anew.
///
/// [`Simulation::resume`](crate::dynamics::Simulation::resume) goes on from it and ends, on a processor with the same instructions, with
/// the same bits as the run that was never laid aside.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Checkpoint {
    /// In double precision, which holds single precision to the bit.
    chain: Chain,
    anchors: Vec<Anchor>,
    set_points: SetPoints,
    top_drive: TopDrive,
    hoist: Hoist,
    bit: Bit,
    flow_m3_per_s: f64,
    rigid_velocity_m_per_s: f64,
    fading_s: f64,
    steps: u64,
    since_sample: SinceSample,
    record: Record,
    high: Vec<Rows<f64>>,
    ledger: Ledger,
    wear: Wear,
    body: Body,
    viscous: Option<Viscous>,
    window_open: bool,
    time_s: f64,
    instructions: String,
}

/// Why a run cannot be taken up again.
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
        /// Nodes that the model and the settings ask for.
        expected: usize,
    },
    /// The checkpoint is that of a run in another precision.
    #[error("the checkpoint is that of a run in another precision")]
    AnotherPrecision,
}

impl Checkpoint {
    /// Time since the start of the run, s.
    pub fn time_s(&self) -> f64 {
        self.time_s
    }

    /// Instruction set that the run was computed with; another one rounds products otherwise.
    pub fn instructions(&self) -> &str {
        &self.instructions
    }
}

impl<R: Real> Run<R> {
    /// The run as it stands, to be laid aside: between two calls of [`Self::advance`], at any time.
    pub fn checkpoint(&self) -> Checkpoint {
        // Every field is named: a new one is either found anew or kept.
        let Self {
            model: _,
            mud: _,
            operation: _,
            settings: _,
            mesh: _,
            plan: _,
            surroundings: _,
            abilities: _,
            steps_per_sample: _,
            stepper,
            chain,
            anchors,
            set_points,
            top_drive,
            hoist,
            bit,
            flow_m3_per_s,
            rigid_velocity_m_per_s,
            fading_s,
            steps,
            since_sample,
            record,
            high,
            ledger,
            wear,
            body,
            viscous,
            window_open,
        } = self;
        Checkpoint {
            chain: chain.converted(),
            anchors: anchors.clone(),
            set_points: set_points.clone(),
            top_drive: top_drive.clone(),
            hoist: hoist.clone(),
            bit: bit.clone(),
            flow_m3_per_s: *flow_m3_per_s,
            rigid_velocity_m_per_s: *rigid_velocity_m_per_s,
            fading_s: *fading_s,
            steps: *steps,
            since_sample: *since_sample,
            record: record.clone(),
            high: high.clone(),
            ledger: *ledger,
            wear: wear.clone(),
            body: body.clone(),
            viscous: viscous.clone(),
            window_open: *window_open,
            time_s: self.time_s(),
            instructions: stepper.instructions.to_owned(),
        }
    }

    /// Takes up a run where [`Self::checkpoint`] left it. Model, operation and settings are those
    /// that it began with: others would go on, but with an answer to neither case.
    ///
    /// # Errors
    /// A checkpoint of another string, or a run that could not have begun.
    pub fn resume(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        checkpoint: Checkpoint,
    ) -> Result<Self, ResumeError> {
        let basis = Basis::<R>::new(model, operation, settings)?;
        let (found, expected) = (checkpoint.chain.nodes(), basis.mesh.nodes.len());
        if found != expected {
            return Err(ResumeError::AnotherString { found, expected });
        }
        if checkpoint.record.layout() != Layout::beside::<R>(found) {
            return Err(ResumeError::AnotherPrecision);
        }
        Ok(Self {
            model: model.clone(),
            mud: model.mud_column(),
            operation: *operation,
            settings: settings.clone(),
            mesh: basis.mesh,
            plan: basis.plan,
            surroundings: basis.surroundings,
            abilities: basis.abilities,
            stepper: basis.stepper,
            steps_per_sample: basis.steps_per_sample,
            chain: checkpoint.chain.converted(),
            anchors: checkpoint.anchors,
            set_points: checkpoint.set_points,
            top_drive: checkpoint.top_drive,
            hoist: checkpoint.hoist,
            bit: checkpoint.bit,
            flow_m3_per_s: checkpoint.flow_m3_per_s,
            rigid_velocity_m_per_s: checkpoint.rigid_velocity_m_per_s,
            fading_s: checkpoint.fading_s,
            steps: checkpoint.steps,
            since_sample: checkpoint.since_sample,
            record: checkpoint.record,
            high: checkpoint.high,
            ledger: checkpoint.ledger,
            wear: checkpoint.wear,
            body: checkpoint.body,
            viscous: checkpoint.viscous,
            window_open: checkpoint.window_open,
        })
    }
}
