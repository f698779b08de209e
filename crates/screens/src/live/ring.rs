//! The samples of the last minutes.

use std::collections::VecDeque;

use super::channels::SAMPLE_COLUMNS;

/// The samples of the last minutes, of which the oldest are dropped. Sample `n` is that of the time
/// `(n + 1)` sample intervals from the beginning: after a rewind its numbers are used again, in
/// another epoch.
#[derive(Debug)]
pub struct Ring {
    most: usize,
    values: VecDeque<f32>,
    /// The number of the next sample.
    next: u64,
    epoch: u32,
}

/// Consecutive samples of a ring.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    pub epoch: u32,
    /// The number of the first.
    pub first: u64,
    /// The rows, one after the other.
    pub values: Vec<f32>,
}

impl Samples {
    /// The number of the sample after the last.
    pub fn end(&self) -> u64 {
        self.first + (self.values.len() / SAMPLE_COLUMNS) as u64
    }
}

impl Ring {
    /// A ring for this many samples, the next of which has this number.
    pub(super) fn new(most: usize, next: u64) -> Self {
        Self { most, values: VecDeque::new(), next, epoch: 0 }
    }

    /// Adds rows.
    pub(super) fn extend(&mut self, rows: &[f32]) {
        self.next += (rows.len() / SAMPLE_COLUMNS) as u64;
        let most = self.most * SAMPLE_COLUMNS;
        let new = &rows[rows.len().saturating_sub(most)..];
        let over = (self.values.len() + new.len()).saturating_sub(most);
        self.values.drain(..over);
        self.values.extend(new);
    }

    /// Drops later samples: the next sample has this number again.
    pub(super) fn rewind(&mut self, next: u64) {
        let gone = self.next.saturating_sub(next) as usize * SAMPLE_COLUMNS;
        self.values.truncate(self.values.len().saturating_sub(gone));
        self.next = next;
        self.epoch += 1;
    }

    fn first(&self) -> u64 {
        self.next - (self.values.len() / SAMPLE_COLUMNS) as u64
    }

    /// The samples from this number of an epoch on, or from the oldest one, at most `most`; none if
    /// there are no newer ones. For another epoch, all samples of the ring.
    pub fn since(&self, epoch: u32, number: u64, most: usize) -> Option<Samples> {
        let from = if epoch == self.epoch { number.max(self.first()) } else { self.first() };
        let has_news = from < self.next || epoch != self.epoch;
        let skip = from.saturating_sub(self.first()) as usize * SAMPLE_COLUMNS;
        let values = self.values.iter().skip(skip).take(most * SAMPLE_COLUMNS).copied();
        has_news.then(|| Samples { epoch: self.epoch, first: from, values: values.collect() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(number: f32) -> Vec<f32> {
        vec![number; SAMPLE_COLUMNS]
    }

    #[test]
    fn the_oldest_go_and_numbers_stay() {
        let mut ring = Ring::new(3, 0);
        assert_eq!(ring.since(0, 0, 10), None);
        for number in 0..5 {
            ring.extend(&row(number as f32));
        }
        let all = ring.since(0, 0, 10).expect("samples");
        assert_eq!((all.first, all.end(), all.values[0]), (2, 5, 2.0));
        let some = ring.since(0, 3, 1).expect("samples");
        assert_eq!((some.first, some.end(), some.values[0]), (3, 4, 3.0));
        assert_eq!(ring.since(0, 5, 10), None);
        let many: Vec<f32> = (5..12).flat_map(|number| row(number as f32)).collect();
        ring.extend(&many);
        let all = ring.since(0, 0, 10).expect("samples");
        assert_eq!((all.first, all.end(), all.values[0]), (9, 12, 9.0));
    }

    #[test]
    fn after_a_rewind_everything_is_told_anew() {
        let mut ring = Ring::new(10, 0);
        (0..6).for_each(|number| ring.extend(&row(number as f32)));
        ring.rewind(4);
        let all = ring.since(0, 6, 10).expect("another epoch");
        assert_eq!((all.epoch, all.first, all.end()), (1, 0, 4));
        assert_eq!(ring.since(1, 4, 10), None);
        ring.extend(&row(9.0));
        assert_eq!(ring.since(1, 4, 10).expect("news").values[0], 9.0);
        // A rewind to before the oldest sample leaves none, which is reported.
        let mut short = Ring::new(2, 0);
        (0..6).for_each(|number| short.extend(&row(number as f32)));
        short.rewind(1);
        let none = short.since(0, 6, 10).expect("another epoch");
        assert_eq!((none.epoch, none.first, none.end()), (1, 1, 1));
    }
}
