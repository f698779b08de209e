//! A number for each lane of a block.

use crate::simd::{
    lanes::DOUBLES,
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
