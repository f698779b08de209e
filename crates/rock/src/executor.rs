//! Who works on the slabs of a block.

use std::sync::{Mutex, PoisonError};

/// Executes pieces of work, in parallel if it can. The rock's results are the same to the last bit
/// for any executor and any order.
pub trait Executor: Sync {
    /// Calls `work` once with each number below `count`, and returns when all is done.
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync));

    /// Whether a stop has been requested. Work of many steps checks this between them: the run-in
    /// of a bit and the settling of a string, both before the first step of a run, which leave
    /// nothing behind, and a run on solid rock, which can continue. Never by default.
    fn stopped(&self) -> bool {
        false
    }
}

/// The calling thread alone.
#[derive(Debug, Clone, Copy, Default)]
pub struct Alone;

impl Executor for Alone {
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        (0..count).for_each(work);
    }
}

/// Has each of `pieces` worked on, once.
///
/// # Panics
/// If the executor leaves one out.
pub(super) fn share<T: Send>(
    executor: &impl Executor,
    pieces: &mut [T],
    work: impl Fn(&mut T) + Sync,
) {
    let waiting: Vec<_> = pieces.iter_mut().map(|piece| Mutex::new(Some(piece))).collect();
    let take = |index: usize| {
        let mut place = waiting[index].lock().unwrap_or_else(PoisonError::into_inner);
        place.take()
    };
    executor.each(waiting.len(), &|index| {
        if let Some(piece) = take(index) {
            work(piece);
        }
    });
    assert!((0..waiting.len()).all(|index| take(index).is_none()), "the executor left work undone");
}
