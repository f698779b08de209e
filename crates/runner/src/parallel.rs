//! Work on all cores.

use std::{
    num::NonZeroUsize,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

/// How much is done side by side: as much as is asked for, else one task per core.
pub(crate) fn jobs(asked: Option<NonZeroUsize>) -> usize {
    asked.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get)
}

/// Does `work` on every item of `order`, on so many threads; each takes the next item that is left.
pub(crate) fn in_parallel(jobs: usize, order: &[usize], work: impl Fn(usize) + Sync) {
    let next = AtomicUsize::new(0);
    let busy = || {
        while let Some(item) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            work(*item);
        }
    };
    thread::scope(|scope| {
        for _ in 1..jobs.min(order.len()) {
            scope.spawn(busy);
        }
        busy();
    });
}

pub(crate) fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
