//! Who works on the rock under the bit, and with what.

use std::{fmt, sync::Arc};

use crate::rock::{Alone, Executor, Stepper};

/// An executor that a caller has lent.
#[derive(Clone)]
pub struct Lent(Arc<dyn Executor + Send + Sync>);

impl Lent {
    pub(in crate::dynamics) fn new(executor: Arc<dyn Executor + Send + Sync>) -> Self {
        Self(executor)
    }
}

impl Default for Lent {
    /// Nobody's: the thread that runs the simulation works alone.
    fn default() -> Self {
        Self(Arc::new(Alone))
    }
}

impl fmt::Debug for Lent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Lent")
    }
}

impl Executor for Lent {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        self.0.each(count, work);
    }

    fn stopped(&self) -> bool {
        self.0.stopped()
    }
}

/// Who works on the rock, with which instructions.
#[derive(Debug, Clone, Default)]
pub struct Crew {
    pub(in crate::dynamics) stepper: Stepper,
    pub(in crate::dynamics) lent: Lent,
}

impl Crew {
    /// An executor, with the best instructions that there are.
    pub fn of(executor: Arc<dyn Executor + Send + Sync>) -> Self {
        Self {
            lent: Lent::new(executor),
            ..Self::default()
        }
    }
}
