//! Reservoir sampling of every node, for its percentiles: as many as memory allows, spread evenly
//! over the window however long it gets.

use serde::{Deserialize, Serialize};

use crate::{
    damage::{Damaged, ensure},
    dynamics::output::statistic::percentile,
    simd::{lanes::DOUBLES, number::Doubles},
};

/// What is kept of every node.
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

/// Numbers kept of one quantity: 3 MB.
const MAX_NUMBERS: usize = 3 << 18;

/// Samples kept at least, and at most.
const ROWS: [usize; 2] = [64, 4096];

/// Kept samples.
///
/// Of every `stride` samples one is kept, at a place in them that a fixed sequence of random
/// numbers chooses, so that nothing periodic hides between. The stride is such that what a window
/// is expected to take fits. When memory is full nevertheless, one of each pair of kept samples
/// stays and the stride doubles.
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
            let kept = &mut row[from..from + N::WIDTH];
            // SAFETY: there is room for so many numbers.
            unsafe { values.narrow(kept.as_mut_ptr()) };
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

    /// 5th, 50th and 95th percentile of a quantity at a node's place; zeros where nothing was kept.
    pub fn percentiles(&self, quantity: Quantity, (block, lane): (usize, usize)) -> [f64; 3] {
        let (of, magnitude) = match quantity {
            Quantity::Contact => (Quantity::Side, true),
            other => (other, false),
        };
        let values = &self.values[of as usize];
        let mut reservoir: Vec<f32> = (0..self.rows)
            .map(|row| values[row * self.width + block * DOUBLES + lane])
            .map(|value| if magnitude { value.abs() } else { value })
            .collect();
        if reservoir.is_empty() {
            return [0.0; 3];
        }
        [0.05, 0.5, 0.95].map(|part| percentile(&mut reservoir, part))
    }
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
