//! Reservoir sampling of every node, for its percentiles: as many as memory allows, spread evenly
//! over the window however long it gets.

use serde::{Deserialize, Serialize};

use crate::{
    damage::{Damaged, ensure},
    simd::{lanes::DOUBLES, number::Doubles},
};

/// Quantities recorded for every node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Tension of the element below.
    Tension,
    /// Torque of the element below, in the sign of the chain.
    Torque,
    /// Contact force, positive on the high side.
    Side,
    /// Bending moment.
    Bending,
    /// Contact force, whatever its side: nothing of its own is kept of it.
    Contact,
}

const QUANTITIES: usize = 4;

/// Percentiles that are reported for each.
const PARTS: [f64; 3] = [0.05, 0.5, 0.95];

/// Numbers kept of one quantity: 3 MB.
const MAX_NUMBERS: usize = 3 << 18;

/// Samples kept at least, and at most: more of them, a few milliseconds apart, would add little
/// information.
const ROWS: [usize; 2] = [64, 640];

/// Kept samples.
///
/// Of every `stride` samples one is kept, at a random position from a fixed sequence, so that no
/// periodic motion is missed. The stride is chosen so that the expected samples of a window fit.
/// When memory is full nevertheless, one of each pair of kept samples stays and the stride doubles.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Reservoir {
    /// Numbers in a row: the lanes of all blocks.
    width: usize,
    max_rows: usize,
    /// Samples that the window is expected to take.
    expected: u64,
    rows: usize,
    stride: u64,
    /// Samples since the last one that began a stride.
    place: u64,
    /// Which of them is kept.
    chosen: u64,
    random: u64,
    values: [Vec<f32>; QUANTITIES],
}

/// A row that waits for its values, one slice a quantity.
pub struct ReservoirRow<'a>([&'a mut [f32]; QUANTITIES]);

impl ReservoirRow<'_> {
    /// Puts the values of a block's lanes from `lane` on, one number a quantity.
    #[inline(always)]
    pub fn put<N: Doubles>(&mut self, block: usize, lane: usize, values: [N; QUANTITIES]) {
        let from = block * DOUBLES + lane;
        for (row, values) in self.0.iter_mut().zip(values) {
            let slots = &mut row[from..from + N::WIDTH];
            // SAFETY: there is room for so many numbers.
            unsafe { values.narrow(slots.as_mut_ptr()) };
        }
    }
}

impl Reservoir {
    /// Whether stored samples are those of a chain of so many blocks.
    pub(super) fn check(&self, blocks: usize) -> Result<(), Damaged> {
        let fresh = Self::new(blocks, self.expected);
        let fits = (self.width, self.max_rows) == (fresh.width, fresh.max_rows)
            && self.rows <= self.max_rows
            && self.stride > 0
            && self.place < self.stride
            && self.values.iter().all(|all| all.len() == self.rows * self.width);
        ensure(fits, "the samples that are kept")
    }

    /// None yet of a chain of so many blocks, of which so many samples are expected.
    pub fn new(blocks: usize, expected: u64) -> Self {
        let width = blocks * DOUBLES;
        let max_rows = (MAX_NUMBERS / width).clamp(ROWS[0], ROWS[1]) / 2 * 2;
        Self {
            width,
            max_rows,
            expected,
            rows: 0,
            stride: first_stride(expected, max_rows),
            place: 0,
            chosen: 0,
            random: 0,
            // Memory that is not used yet costs nothing.
            values: std::array::from_fn(|_| Vec::with_capacity(max_rows * width)),
        }
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.rows = 0;
        self.stride = first_stride(self.expected, self.max_rows);
        self.place = 0;
        self.chosen = 0;
        self.values.iter_mut().for_each(Vec::clear);
    }

    /// Counts a sample; the row for it if it is kept.
    pub fn next(&mut self) -> Option<ReservoirRow<'_>> {
        if self.place == 0 {
            if self.rows == self.max_rows {
                self.halve();
            }
            self.chosen = self.draw() % self.stride;
        }
        let keeps = self.place == self.chosen;
        self.place = (self.place + 1) % self.stride;
        if !keeps {
            return None;
        }
        let from = self.rows * self.width;
        self.rows += 1;
        let to = self.rows * self.width;
        Some(ReservoirRow(self.values.each_mut().map(|values| {
            values.resize(to, 0.0);
            &mut values[from..to]
        })))
    }

    fn halve(&mut self) {
        for pair in 0..self.rows / 2 {
            let from = (2 * pair + (self.draw() % 2) as usize) * self.width;
            for values in &mut self.values {
                values.copy_within(from..from + self.width, pair * self.width);
            }
        }
        self.rows /= 2;
        self.stride *= 2;
        let length = self.rows * self.width;
        self.values.iter_mut().for_each(|values| values.truncate(length));
    }

    /// Knuth's linear congruential generator (MMIX), its upper half.
    fn draw(&mut self) -> u64 {
        self.random = self
            .random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        self.random >> 33
    }

    /// 5th, 50th and 95th percentile of a quantity at every place, block by block; zeros where
    /// nothing was kept.
    pub fn percentiles(&self, quantity: Quantity) -> Vec<[[f64; 3]; DOUBLES]> {
        let (stored, magnitude) = match quantity {
            Quantity::Contact => (Quantity::Side, true),
            other => (other, false),
        };
        let values = &self.values[stored as usize];
        let mut places = vec![[[0.0; 3]; DOUBLES]; self.width / DOUBLES];
        if self.rows == 0 {
            return places;
        }
        // The samples of a place are far apart in memory: those of a block are read together, as
        // many rows at a time as fill a line of the cache.
        let mut samples = vec![0; DOUBLES * self.rows];
        for (block, places) in places.iter_mut().enumerate() {
            for (first, rows) in (0..).step_by(DOUBLES).zip(values.chunks(DOUBLES * self.width)) {
                for (lane, samples) in samples.chunks_exact_mut(self.rows).enumerate() {
                    let rows = rows.chunks_exact(self.width).map(|row| row[block * DOUBLES + lane]);
                    for (sample, value) in samples[first..].iter_mut().zip(rows) {
                        *sample = ordinal(if magnitude { value.abs() } else { value });
                    }
                }
            }
            for (place, samples) in places.iter_mut().zip(samples.chunks_exact_mut(self.rows)) {
                *place = percentiles(samples);
            }
        }
        places
    }
}

/// A number whose order among others is [`f32::total_cmp`]'s, and which is compared faster.
fn ordinal(value: f32) -> i32 {
    let bits = value.to_bits() as i32;
    bits ^ (((bits >> 31) as u32) >> 1) as i32
}

/// The value that an ordinal is of.
fn value_of(ordinal: i32) -> f64 {
    let bits = ordinal ^ (((ordinal >> 31) as u32) >> 1) as i32;
    f64::from(f32::from_bits(bits as u32))
}

/// Fewer samples are sorted.
const FEW: usize = 64;

/// 5th, 50th and 95th percentile of samples, at least one, by their ordinals, as
/// [`percentile`](crate::dynamics::output::statistic::percentile) has them.
fn percentiles(samples: &mut [i32]) -> [f64; 3] {
    let last = samples.len() - 1;
    let places = PARTS.map(|part| part * last as f64);
    let [low, middle, high] = places.map(|place| place.floor() as usize);
    let first = samples[0];
    if samples.iter().fold(true, |same, sample| same & (*sample == first)) {
        // A negative zero becomes a positive one, as it does between two.
        return [value_of(first) + 0.0; 3];
    }
    let between = if samples.len() < FEW {
        samples.sort_unstable();
        [low, middle, high].map(|at| [samples[at], samples[(at + 1).min(last)]])
    } else {
        // The others are on either side of the median.
        let (below, median, above) = samples.select_nth_unstable(middle);
        let next = least(above, *median);
        let middle_pair = [*median, next];
        let (_, at, beyond) = below.select_nth_unstable(low);
        let low_pair = [*at, least(beyond, *median)];
        let (_, at, beyond) = above.select_nth_unstable(high - middle - 1);
        [low_pair, middle_pair, [*at, least(beyond, *at)]]
    };
    std::array::from_fn(|k| {
        let [at, next] = between[k].map(value_of);
        at + (places[k] - places[k].floor()) * (next - at)
    })
}

/// The least of some samples, or another where there are none.
fn least(samples: &[i32], otherwise: i32) -> i32 {
    samples.iter().copied().min().unwrap_or(otherwise)
}

/// The smallest power of two of which so many samples fill no more rows than there are.
fn first_stride(expected: u64, max_rows: usize) -> u64 {
    expected.div_ceil(max_rows as u64).max(1).next_power_of_two()
}

#[cfg(test)]
impl ReservoirRow<'_> {
    /// The same value for every quantity and node.
    pub fn fill(&mut self, value: f32) {
        self.0.iter_mut().for_each(|row| row.fill(value));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{dynamics::output::statistic::percentile, random::Random};

    /// However many samples there are, few or many, alike or not: as found one by one.
    #[test]
    fn percentiles_of_a_place_are_those_of_its_samples() {
        let mut random = Random::new(7);
        for count in 1..300 {
            for values in [1.0, 3.0, 1e6] {
                let samples: Vec<f32> =
                    (0..count).map(|_| (values * random.signed()).round() as f32).collect();
                let mut ordinals: Vec<i32> = samples.iter().copied().map(ordinal).collect();
                let mut samples = samples;
                let expected = PARTS.map(|part| percentile(&mut samples, part));
                let found = percentiles(&mut ordinals);
                assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "{count}");
            }
        }
    }
}
