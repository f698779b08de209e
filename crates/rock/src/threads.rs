//! Threads of rayon as an executor.

use rayon::{
    ThreadPool,
    iter::{IntoParallelIterator, ParallelIterator},
};

use super::executor::Executor;

/// The threads of the pool, side by side.
impl Executor for ThreadPool {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        self.install(|| (0..count).into_par_iter().for_each(work));
    }
}
