//! Reading and writing one of eight neighbours.

use crate::{
    dynamics::chain::{Field, Row, Rows},
    rod::{lanes::LANES, number::Number, vector::Vector},
};

/// Which eight neighbours: their block in the chain, and its place in the tile.
#[derive(Clone, Copy)]
pub(super) struct Eight {
    pub(super) block: usize,
    pub(super) place: usize,
}

#[inline(always)]
pub(super) fn at<N: Number>(row: &Row, lane: usize) -> N {
    N::splat(row.0[lane])
}

#[inline(always)]
pub(super) fn at3<N: Number>(rows: &Rows, lane: usize) -> Vector<N> {
    Vector(at(&rows[0], lane), at(&rows[1], lane), at(&rows[2], lane))
}

#[inline(always)]
pub(super) fn put<N: Number>(arrays: &mut [[f64; LANES]; 3], lane: usize, v: Vector<N>) {
    arrays[0][lane] = v.0.get();
    arrays[1][lane] = v.1.get();
    arrays[2][lane] = v.2.get();
}

/// The nine vectors that the elements of a block see.
#[inline(always)]
pub(super) fn nine(fields: &[Field; 3], block: usize) -> [&[f64; LANES + 1]; 3] {
    [
        fields[0].nine(block),
        fields[1].nine(block),
        fields[2].nine(block),
    ]
}

#[inline(always)]
pub(super) fn from<N: Number, const L: usize>(arrays: &[&[f64; L]; 3], lane: usize) -> Vector<N> {
    Vector(
        N::splat(arrays[0][lane]),
        N::splat(arrays[1][lane]),
        N::splat(arrays[2][lane]),
    )
}

#[inline(always)]
pub(super) fn held<N: Number>(arrays: &[[f64; LANES]; 3], lane: usize) -> Vector<N> {
    Vector(
        N::splat(arrays[0][lane]),
        N::splat(arrays[1][lane]),
        N::splat(arrays[2][lane]),
    )
}

#[inline(always)]
pub(super) fn add(sum: &mut [f64; LANES], values: &[f64; LANES]) {
    for (sum, value) in sum.iter_mut().zip(values) {
        *sum += value;
    }
}
