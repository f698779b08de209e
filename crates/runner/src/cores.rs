//! Work on solid rock on several cores.

use std::{num::NonZeroUsize, sync::Arc, thread};

use rayon::{
    ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder,
    iter::{IntoParallelIterator, ParallelIterator},
};
use wholestring::{
    dynamics::BitLaw,
    rock::{Alone, Executor},
};
use wholestring_case::Case;

use crate::cancellation::CancellationToken;

/// Who may be given to a simulation.
pub(crate) type SharedExecutor = Arc<dyn Executor + Send + Sync>;

/// Threads that wait for work.
pub(crate) struct Cores(ThreadPool);

impl Cores {
    /// So many threads, of which the calling one is the first: it works where it would wait.
    pub(crate) fn new(threads: NonZeroUsize) -> Result<Self, ThreadPoolBuildError> {
        let builder = ThreadPoolBuilder::new().num_threads(threads.get());
        builder.use_current_thread().build().map(Self)
    }

    /// So many threads for the rock of a case, one per core where nothing is said; none where it
    /// has no rock, or is to be worked on alone.
    fn of_case(case: &Case, threads: Option<NonZeroUsize>) -> Option<Self> {
        let threads = threads.or_else(|| thread::available_parallelism().ok())?;
        if threads.get() == 1 || !matches!(case.dynamics.bit.law, BitLaw::Rock(_)) {
            return None;
        }
        // Without threads the rock is worked on alone, to the same bits.
        Self::new(threads).ok()
    }
}

/// Who works on the rock of a run: its own thread, and others where there are any. A cancellation
/// stops what has nothing to keep.
struct Workers {
    cores: Option<Cores>,
    cancellation: CancellationToken,
}

/// So many threads for the rock of a case, one per core where nothing is said.
pub(crate) fn for_rock(
    case: &Case,
    threads: Option<NonZeroUsize>,
    cancellation: &CancellationToken,
) -> SharedExecutor {
    Arc::new(Workers { cores: Cores::of_case(case, threads), cancellation: cancellation.clone() })
}

/// The thread that solves, alone.
pub(crate) fn alone(cancellation: &CancellationToken) -> SharedExecutor {
    Arc::new(Workers { cores: None, cancellation: cancellation.clone() })
}

impl Executor for Workers {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        match &self.cores {
            Some(cores) => cores.each(count, work),
            None => Alone.each(count, work),
        }
    }

    fn stopped(&self) -> bool {
        self.cancellation.is_cancelled()
    }
}

impl Executor for Cores {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        self.0.install(|| (0..count).into_par_iter().for_each(work));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    #[test]
    fn every_piece_is_done_once() {
        let cores = Cores::new(NonZeroUsize::new(3).expect("three")).expect("threads");
        let done: Vec<AtomicUsize> = (0..100).map(|_| AtomicUsize::new(0)).collect();
        for _ in 0..50 {
            cores.each(done.len(), &|index| {
                done[index].fetch_add(1, Ordering::Relaxed);
            });
        }
        assert!(done.iter().all(|done| done.load(Ordering::Relaxed) == 50));
    }
}
