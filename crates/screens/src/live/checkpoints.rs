//! Moments to rewind to, in bounded memory.

use std::sync::Arc;

use serde::Serialize;
use utoipa::ToSchema;

/// A moment to rewind to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
pub struct CheckpointEntry {
    /// Identifier in requests.
    pub number: u64,
    /// Its time, s.
    pub time_s: f64,
}

#[derive(Debug)]
struct Kept {
    entry: CheckpointEntry,
    bytes: Arc<Vec<u8>>,
}

/// Checkpoints within a limit of bytes: beyond it they are thinned out, the more so the older they
/// are; the first and the last stay.
#[derive(Debug)]
pub(super) struct Checkpoints {
    most_bytes: usize,
    next: u64,
    kept: Vec<Kept>,
}

impl Checkpoints {
    pub(super) fn new(most_bytes: usize) -> Self {
        Self { most_bytes, next: 1, kept: Vec::new() }
    }

    /// Adds the latest, and returns its number.
    pub(super) fn put(&mut self, time_s: f64, bytes: Vec<u8>) -> u64 {
        let number = self.next;
        self.next += 1;
        let entry = CheckpointEntry { number, time_s };
        self.kept.push(Kept { entry, bytes: Arc::new(bytes) });
        while self.bytes() > self.most_bytes && self.kept.len() > 2 {
            self.thin();
        }
        number
    }

    /// Their size, bytes.
    pub(super) fn bytes(&self) -> usize {
        self.kept.iter().map(|checkpoint| checkpoint.bytes.len()).sum()
    }

    /// Removes the one whose neighbours are closest to each other relative to their age.
    fn thin(&mut self) {
        let time_s = |place: usize| self.kept[place].entry.time_s;
        let now_s = time_s(self.kept.len() - 1);
        let gap = |place: usize| {
            (time_s(place + 1) - time_s(place - 1)) / (now_s - time_s(place - 1)).max(1e-9)
        };
        let inner = 1..self.kept.len() - 1;
        let nearest = inner.min_by(|one, other| gap(*one).total_cmp(&gap(*other)));
        if let Some(place) = nearest {
            self.kept.remove(place);
        }
    }

    /// All checkpoints, the oldest first.
    pub(super) fn entries(&self) -> Vec<CheckpointEntry> {
        self.kept.iter().map(|checkpoint| checkpoint.entry).collect()
    }

    /// The checkpoint with this number.
    pub(super) fn get(&self, number: u64) -> Option<(CheckpointEntry, Arc<Vec<u8>>)> {
        let found = self.kept.iter().find(|checkpoint| checkpoint.entry.number == number)?;
        Some((found.entry, found.bytes.clone()))
    }

    /// Drops those after this one.
    pub(super) fn rewind(&mut self, number: u64) {
        self.kept.retain(|checkpoint| checkpoint.entry.number <= number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_stay_within_their_memory_and_become_rarer() {
        let mut all = Checkpoints::new(800);
        for place in 0..100 {
            all.put(10.0 * f64::from(place), vec![0; 100]);
        }
        let times: Vec<f64> = all.entries().iter().map(|entry| entry.time_s).collect();
        assert_eq!(times.len(), 8);
        assert_eq!((times[0], times[7]), (0.0, 990.0));
        // Recent ones are closer together than those in the middle.
        assert!(times[7] - times[6] < times[3] - times[2], "{times:?}");
        let number = all.entries()[3].number;
        all.rewind(number);
        assert_eq!(all.entries().len(), 4);
        assert!(all.get(number).is_some() && all.get(100).is_none());
    }

    #[test]
    fn one_that_is_too_large_is_kept_with_the_first_alone() {
        let mut all = Checkpoints::new(10);
        for index in 0..5 {
            all.put(f64::from(index), vec![0; 100]);
        }
        assert_eq!(all.entries().len(), 2);
    }
}
