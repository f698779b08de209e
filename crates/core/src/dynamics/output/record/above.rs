//! Data that elements pass to the nodes below them while the rows are processed from the top down.
//! For a row they come from the row above; for the first from the last, one lane higher.

use super::lane::{Lane, at, put};
use crate::simd::{
    lanes::{DOUBLES, SINGLES},
    number::Doubles,
};

/// Maximum number of blocks next to a row of the chain.
const PARTS: usize = SINGLES / DOUBLES;

/// So many numbers of each element above a row of nodes.
#[derive(Debug, Clone, Copy)]
pub struct Above<const K: usize>([[Lane; K]; PARTS]);

impl<const K: usize> Above<K> {
    /// Nothing yet.
    pub const NONE: Self = Self([[[0.0; DOUBLES]; K]; PARTS]);

    /// The numbers at lanes of a part of the row.
    #[inline(always)]
    pub fn at<N: Doubles>(&self, part: usize, lane: usize) -> [N; K] {
        std::array::from_fn(|k| at(&self.0[part][k], lane))
    }

    /// Hands numbers down.
    #[inline(always)]
    pub fn put<N: Doubles>(&mut self, part: usize, lane: usize, numbers: [N; K]) {
        for (lanes, numbers) in self.0[part].iter_mut().zip(numbers) {
            put(lanes, lane, numbers);
        }
    }

    /// From the last row of a region, which has so many parts, to its first: a lane on. Above the
    /// first lane there is nothing.
    pub fn close(&mut self, parts: usize) {
        for part in (0..parts).rev() {
            for k in 0..K {
                let from_part_above = match part.checked_sub(1) {
                    Some(above) => self.0[above][k][DOUBLES - 1],
                    None => 0.0,
                };
                let lanes = &mut self.0[part][k];
                lanes.copy_within(..DOUBLES - 1, 1);
                lanes[0] = from_part_above;
            }
        }
    }
}
