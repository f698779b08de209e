//! Work on solid rock on several cores.

use std::{num::NonZeroUsize, sync::Arc, thread};

use rayon::{ThreadPool, ThreadPoolBuilder};
use wholestring::{
    dynamics::BitLaw,
    rock::{Alone, Executor},
};
use wholestring_case::Case;

use crate::cancellation::CancellationToken;

/// Who may be given to a simulation.
pub(crate) type SharedExecutor = Arc<dyn Executor + Send + Sync>;

/// So many threads for the rock of a case, one per core where nothing is said; none where it has no
/// rock, or is to be worked on alone. Where the calling thread solves, it is the first: it works
/// where it would wait.
fn threads_of(case: &Case, threads: Option<NonZeroUsize>, solves: bool) -> Option<ThreadPool> {
    let threads = threads.or_else(|| thread::available_parallelism().ok())?;
    if threads.get() == 1 || !matches!(case.dynamics.bit.law, BitLaw::Rock(_)) {
        return None;
    }
    // Without threads the rock is worked on alone, to the same bits.
    let builder = ThreadPoolBuilder::new().num_threads(threads.get());
    if solves { builder.use_current_thread() } else { builder }.build().ok()
}

/// Who works on the rock of a run: its own thread, and others where there are any. A cancellation
/// stops what has nothing to keep.
struct Workers {
    threads: Option<ThreadPool>,
    cancellation: CancellationToken,
}

/// So many threads for the rock of a case that the calling thread solves, one per core where nothing
/// is said.
pub(crate) fn for_rock(
    case: &Case,
    threads: Option<NonZeroUsize>,
    cancellation: &CancellationToken,
) -> SharedExecutor {
    let threads = threads_of(case, threads, true);
    Arc::new(Workers { threads, cancellation: cancellation.clone() })
}

/// The same of a case that other threads solve.
pub(crate) fn for_rock_of_others(
    case: &Case,
    threads: Option<NonZeroUsize>,
    cancellation: &CancellationToken,
) -> SharedExecutor {
    let threads = threads_of(case, threads, false);
    Arc::new(Workers { threads, cancellation: cancellation.clone() })
}

/// The thread that solves, alone.
pub(crate) fn alone(cancellation: &CancellationToken) -> SharedExecutor {
    Arc::new(Workers { threads: None, cancellation: cancellation.clone() })
}

impl Executor for Workers {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        match &self.threads {
            Some(threads) => threads.each(count, work),
            None => Alone.each(count, work),
        }
    }

    fn stopped(&self) -> bool {
        self.cancellation.is_cancelled()
    }
}
