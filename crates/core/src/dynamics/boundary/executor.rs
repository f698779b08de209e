//! The executor of the rock under the bit: threads of the caller, or one.

use std::{fmt, sync::Arc};

use crate::rock::{Alone, Executor, Stepper};

/// An executor that a caller has set.
#[derive(Clone)]
pub struct SharedExecutor(Arc<dyn Executor + Send + Sync>);

impl SharedExecutor {
    pub(in crate::dynamics) fn new(executor: Arc<dyn Executor + Send + Sync>) -> Self {
        Self(executor)
    }
}

impl Default for SharedExecutor {
    /// Nobody's: the thread that runs the simulation works alone.
    fn default() -> Self {
        Self(Arc::new(Alone))
    }
}

impl fmt::Debug for SharedExecutor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("SharedExecutor")
    }
}

impl Executor for SharedExecutor {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        self.0.each(count, work);
    }

    fn stopped(&self) -> bool {
        self.0.stopped()
    }
}

/// Who works on the rock, with which instructions.
#[derive(Debug, Clone, Default)]
pub struct RockExecutor {
    pub(in crate::dynamics) stepper: Stepper,
    pub(in crate::dynamics) shared: SharedExecutor,
}

impl RockExecutor {
    /// An executor, with the best instructions that there are.
    pub fn of(executor: Arc<dyn Executor + Send + Sync>) -> Self {
        Self { shared: SharedExecutor::new(executor), ..Self::default() }
    }
}
