//! A number for each lane of a block.

use crate::simd::{
    lanes::{DOUBLES, SINGLES},
    number::{Doubles, Real},
    vector::Vector,
};

/// One number for each lane.
pub type Lane = [f64; DOUBLES];

/// Lanes from `lane` on, as many as `N` holds.
#[inline(always)]
pub fn at<N: Doubles, R: Real>(from: &[R; DOUBLES], lane: usize) -> N {
    assert!(lane + N::WIDTH <= DOUBLES);
    // SAFETY: there are so many numbers.
    unsafe { R::doubles(from.as_ptr().add(lane)) }
}

/// The same of a vector for each lane.
#[inline(always)]
pub fn at3<N: Doubles, R: Real>(from: [&[R; DOUBLES]; 3], lane: usize) -> Vector<N> {
    let [x, y, z] = from;
    Vector(at(x, lane), at(y, lane), at(z, lane))
}

/// Puts numbers into lanes from `lane` on.
#[inline(always)]
pub fn put<N: Doubles>(into: &mut Lane, lane: usize, value: N) {
    assert!(lane + N::WIDTH <= DOUBLES);
    // SAFETY: there is room for so many numbers.
    unsafe { value.store(into.as_mut_ptr().add(lane)) }
}

/// Adds numbers to lanes from `lane` on.
#[inline(always)]
pub fn add<N: Doubles>(into: &mut Lane, lane: usize, value: N) {
    put(into, lane, at::<N, f64>(into, lane) + value);
}

/// Keeps the larger of lanes from `lane` on and of numbers.
#[inline(always)]
pub fn keep_larger<N: Doubles>(into: &mut Lane, lane: usize, value: N) {
    put(into, lane, value.max(at::<N, f64>(into, lane)));
}

// Data that elements pass to the nodes below them while the rows are processed from the top down.
// For a row they come from the row above; for the first from the last, one lane higher.

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
