//! Rows: the same number of as many nodes or elements as there are lanes.

use serde::{Deserialize, Serialize};

use crate::simd::{lanes::DOUBLES, number::Real};

/// One number for each lane.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[repr(C, align(64))]
#[serde(bound = "")]
pub struct Row<R: Real>(pub R::Lanes);

impl<R: Real> Row<R> {
    /// The same number in every lane.
    pub fn filled(value: f64) -> Self {
        Self(R::from_f64(value).in_every_lane())
    }

    /// Takes every number of another row one lane higher; zero comes in.
    #[inline(always)]
    pub fn follow_in_lanes(&mut self, other: &Self) {
        self.0.as_mut()[1..].copy_from_slice(&other.0.as_ref()[..R::LANES - 1]);
        self.0[0] = R::default();
    }

    /// Takes every number of another row one lane lower; the last lane is that of `last`.
    #[inline(always)]
    pub fn lead_in_lanes(&mut self, other: &Self, last: &Self) {
        let end = R::LANES - 1;
        self.0.as_mut()[..end].copy_from_slice(&other.0.as_ref()[1..]);
        self.0[end] = last.0[end];
    }

    /// The part of the row next to a block of doubles: [`Layout`].
    #[inline(always)]
    pub fn part(&self, part: usize) -> &[R; DOUBLES] {
        &self.0.as_ref().as_chunks().0[part]
    }
}

/// A vector for each lane.
pub type Rows<R> = [Row<R>; 3];

/// Copies the numbers of a lane from rows of another kind of number.
pub(super) trait CopyLane<Rows> {
    fn copy_lane(&mut self, lane: usize, from: &Rows, from_lane: usize);
}

impl<R: Real, S: Real> CopyLane<Row<S>> for Row<R> {
    fn copy_lane(&mut self, lane: usize, from: &Row<S>, from_lane: usize) {
        self.0[lane] = R::from_f64(from.0[from_lane].to_f64());
    }
}

impl<R: Real, S: Real> CopyLane<Rows<S>> for Rows<R> {
    fn copy_lane(&mut self, lane: usize, from: &Rows<S>, from_lane: usize) {
        for (row, from) in self.iter_mut().zip(from) {
            row.copy_lane(lane, from, from_lane);
        }
    }
}
