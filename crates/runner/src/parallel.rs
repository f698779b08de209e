//! Work on all cores.

use std::{
    num::NonZeroUsize,
    panic::resume_unwind,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

/// Number of parallel jobs: as requested, by default one per core.
pub(crate) fn jobs(requested: Option<NonZeroUsize>) -> usize {
    requested.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get)
}

/// Calls `work` for every item of `order` on at most `jobs` threads; each takes the next item left.
/// If the system refuses a thread, the existing threads do all of the work.
pub(crate) fn in_parallel(jobs: usize, order: &[usize], work: impl Fn(usize) + Sync) {
    in_parallel_on(&thread::Builder::new, jobs, order, work);
}

fn in_parallel_on(
    builder: &dyn Fn() -> thread::Builder,
    jobs: usize,
    order: &[usize],
    work: impl Fn(usize) + Sync,
) {
    let next = AtomicUsize::new(0);
    let busy = || {
        while let Some(item) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            work(*item);
        }
    };
    thread::scope(|scope| {
        for _ in 1..jobs.min(order.len()) {
            if builder().spawn_scoped(scope, busy).is_err() {
                break;
            }
        }
        busy();
    });
}

/// Runs `other` on its own thread while this one runs `own`; if the system refuses the thread, one
/// after the other.
pub(crate) fn beside<O: Send, T>(
    other: impl FnOnce() -> O + Send,
    own: impl FnOnce() -> T,
) -> (O, T) {
    beside_on(thread::Builder::new(), other, own)
}

fn beside_on<O: Send, T>(
    builder: thread::Builder,
    other: impl FnOnce() -> O + Send,
    own: impl FnOnce() -> T,
) -> (O, T) {
    // A refused thread does not return its closure, so it is taken from here.
    let other = Mutex::new(Some(other));
    thread::scope(|scope| {
        let take = || lock(&other).take();
        let thread = builder.spawn_scoped(scope, move || take().map(|other| other()));
        let own = own();
        let done = match thread {
            Ok(thread) => thread.join().unwrap_or_else(|panic| resume_unwind(panic)),
            Err(_) => None,
        };
        let done = done.or_else(|| take().map(|other| other()));
        (done.expect("the work is done once, here or there"), own)
    })
}

pub(crate) fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Threads whose stack exceeds any memory, so that the system refuses each.
    fn refused() -> thread::Builder {
        thread::Builder::new().stack_size(1 << 60)
    }

    #[test]
    fn refused_threads_leave_no_work_undone() {
        assert!(thread::scope(|scope| refused().spawn_scoped(scope, || ()).is_err()));
        for builder in [&refused as &dyn Fn() -> thread::Builder, &thread::Builder::new] {
            let done = Mutex::new(BTreeSet::new());
            let order: Vec<usize> = (0..40).collect();
            in_parallel_on(builder, 4, &order, |item| {
                lock(&done).insert(item);
            });
            assert_eq!(lock(&done).len(), 40);
            assert_eq!(beside_on(builder(), || 3, || "own"), (3, "own"));
        }
    }
}
