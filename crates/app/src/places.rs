//! Places for connections. A connection without an admitted request gives its place up to a new
//! one.
//!
//! Anyone on this machine can open connections and send nothing. Were they to keep their places
//! until their time is up, a few hundred would keep the user's browser out for half a minute.

use std::{
    collections::BTreeMap,
    sync::{
        Arc, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    time::{Duration, Instant},
};

use tokio::{sync::Notify, time::timeout};

/// The places for connections.
#[derive(Debug, Clone)]
pub(crate) struct Places(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    count: usize,
    /// Time in which a new connection is not replaced: its request may be under way.
    patience: Duration,
    state: Mutex<State>,
    /// Signals that a place is free.
    freed: Notify,
}

#[derive(Debug, Default)]
struct State {
    taken: usize,
    next: u64,
    /// Connections without an admitted request, the oldest first.
    silent: BTreeMap<u64, (Instant, Arc<Notify>)>,
}

/// The place of a connection, free again when it is dropped.
#[derive(Debug)]
pub(crate) struct Place {
    places: Places,
    number: u64,
    is_admitted: AtomicBool,
    replaced: Arc<Notify>,
}

impl Places {
    pub(crate) fn new(count: usize, patience: Duration) -> Self {
        let (state, freed) = (Mutex::default(), Notify::new());
        Self(Arc::new(Shared { count, patience, state, freed }))
    }

    /// Returns a place as soon as one is free. If all are taken, the oldest silent connection is
    /// asked to end; if none is silent, it waits.
    pub(crate) async fn take(&self) -> Place {
        loop {
            if let Some(place) = self.free_place() {
                return place;
            }
            self.replace_oldest();
            // After the time another connection is silent long enough, or has been replaced.
            let _ = timeout(self.0.patience, self.0.freed.notified()).await;
        }
    }

    fn free_place(&self) -> Option<Place> {
        let mut state = self.lock();
        if state.taken >= self.0.count {
            return None;
        }
        state.taken += 1;
        let (number, replaced) = (state.next, Arc::new(Notify::new()));
        state.next += 1;
        state.silent.insert(number, (Instant::now(), replaced.clone()));
        Some(Place { places: self.clone(), number, is_admitted: AtomicBool::new(false), replaced })
    }

    fn replace_oldest(&self) {
        let mut state = self.lock();
        if let Some(oldest) = state.silent.first_entry()
            && oldest.get().0.elapsed() >= self.0.patience
        {
            let (_, replaced) = oldest.remove();
            replaced.notify_one();
        }
    }

    /// Waits until all places are free.
    pub(crate) async fn all_free(&self) {
        while self.lock().taken > 0 {
            self.0.freed.notified().await;
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        // Every change is one step: a panic leaves none half done.
        self.0.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Place {
    /// Keeps the place from now on: the connection has sent an admitted request.
    pub(crate) fn admit(&self) {
        if !self.is_admitted.swap(true, Ordering::Relaxed) {
            self.places.lock().silent.remove(&self.number);
        }
    }

    /// Waits until the place is needed for another connection.
    pub(crate) async fn replaced(&self) {
        loop {
            self.replaced.notified().await;
            // The request may have arrived in the meantime.
            if !self.is_admitted.load(Ordering::Relaxed) {
                return;
            }
        }
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let mut state = self.places.lock();
        state.taken -= 1;
        state.silent.remove(&self.number);
        drop(state);
        self.places.0.freed.notify_one();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn silent_connections_are_replaced_and_others_are_not() {
        let places = Places::new(2, Duration::from_millis(1));
        let (first, second) = (places.take().await, places.take().await);
        first.admit();
        let third = async {
            second.replaced().await;
            drop(second);
        };
        let (third, ()) = tokio::join!(places.take(), third);
        third.admit();
        // Both are in use: nothing is replaced, and a new one waits.
        let wait = Duration::from_millis(50);
        assert!(timeout(wait, places.take()).await.is_err());
        assert!(timeout(wait, first.replaced()).await.is_err());
        drop(first);
        assert!(timeout(wait, places.take()).await.is_ok());
        drop(third);
        assert!(timeout(wait, places.all_free()).await.is_ok());
    }
}
