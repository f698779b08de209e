//! A run with threads of its own.

use std::{num::NonZeroUsize, sync::Arc};

use rayon::{ThreadPoolBuildError, ThreadPoolBuilder};

use super::Simulation;
use crate::{
    dynamics::{assemble::SetupError, settings::DynamicsSettings},
    model::Model,
    operation::Operation,
};

/// Why a run with threads of its own cannot begin.
#[derive(Debug, thiserror::Error)]
pub enum ThreadsError {
    /// The run itself cannot.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The threads cannot be started.
    #[error("the threads for the rock cannot be started: {0}")]
    Threads(#[from] ThreadPoolBuildError),
}

impl Simulation {
    /// [`Simulation::new`] with so many threads for the solid rock under the bit, which live as
    /// long as the simulation and its copies; without solid rock they have nothing to do. The
    /// answer does not depend on them. A `rayon::ThreadPool` of the caller's is an
    /// [executor](Simulation::with_executor), too.
    ///
    /// # Errors
    /// Those of [`Simulation::new`], and threads that the system does not give.
    pub fn with_threads(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        threads: NonZeroUsize,
    ) -> Result<Self, ThreadsError> {
        let pool = ThreadPoolBuilder::new().num_threads(threads.get()).build()?;
        Ok(Self::with_executor(model, operation, settings, Arc::new(pool))?)
    }
}
