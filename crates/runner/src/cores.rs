//! Parallel work on solid rock.

use std::{num::NonZeroUsize, sync::Arc, thread};

use rayon::{ThreadPool, ThreadPoolBuilder};
use wholestring::{
    dynamics::BitLaw,
    rock::{Alone, Executor},
};
use wholestring_case::Case;

use crate::cancellation::CancellationToken;

/// Executor that can be passed to a simulation.
pub(crate) type SharedExecutor = Arc<dyn Executor + Send + Sync>;

/// Threads for the rock of a case, one per core by default; `None` if the case has no rock or only
/// one thread is to be used. If the calling thread solves, it counts as the first, because it works
/// while it would wait.
fn threads_of(case: &Case, threads: Option<NonZeroUsize>, solves: bool) -> Option<ThreadPool> {
    let threads = threads.or_else(|| thread::available_parallelism().ok())?;
    if threads.get() == 1 || !matches!(case.dynamics.bit.law, BitLaw::Rock(_)) {
        return None;
    }
    // Without threads the rock is solved by one thread, with bitwise equal results.
    let builder = ThreadPoolBuilder::new().num_threads(threads.get());
    if solves { builder.use_current_thread() } else { builder }.build().ok()
}

/// Executor for the rock of a run: its own thread, and others if there are any. A cancellation
/// stops it between two steps.
struct Workers {
    threads: RockThreads,
    cancellation: CancellationToken,
}

/// Threads that solve the rock of a run.
#[derive(Clone, Default)]
pub(crate) struct RockThreads(Option<Arc<ThreadPool>>);

impl RockThreads {
    /// Threads for the rock of a case that other threads solve, one per core by default.
    pub(crate) fn of_others(case: &Case, threads: Option<NonZeroUsize>) -> Self {
        Self(threads_of(case, threads, false).map(Arc::new))
    }

    /// The threads as an executor that a cancellation stops.
    pub(crate) fn executor(&self, cancellation: &CancellationToken) -> SharedExecutor {
        Arc::new(Workers { threads: self.clone(), cancellation: cancellation.clone() })
    }
}

/// Threads for the rock of a case that the calling thread solves; by default one per core.
pub(crate) fn for_rock(
    case: &Case,
    threads: Option<NonZeroUsize>,
    cancellation: &CancellationToken,
) -> SharedExecutor {
    RockThreads(threads_of(case, threads, true).map(Arc::new)).executor(cancellation)
}

/// An executor with the solving thread alone.
pub(crate) fn alone(cancellation: &CancellationToken) -> SharedExecutor {
    RockThreads::default().executor(cancellation)
}

impl Executor for Workers {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        match &self.threads.0 {
            Some(threads) => threads.each(count, work),
            None => Alone.each(count, work),
        }
    }

    fn stopped(&self) -> bool {
        self.cancellation.is_cancelled()
    }
}
