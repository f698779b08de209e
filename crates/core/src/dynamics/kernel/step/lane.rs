//! Reading and writing the lanes of a row, as many at once as a number holds.

use crate::{
    dynamics::kernel::chain::{Row, Rows},
    simd::{
        number::{Number, Real},
        vector::Vector,
    },
};

/// First lane of each register of a row.
#[inline(always)]
pub(super) fn lanes<N: Number>() -> impl Iterator<Item = usize> {
    (0..N::Real::LANES).step_by(N::WIDTH)
}

#[inline(always)]
pub(super) fn at<N: Number>(row: &Row<N::Real>, lane: usize) -> N {
    assert!(lane + N::WIDTH <= N::Real::LANES);
    // SAFETY: the row holds so many numbers.
    unsafe { N::load(row.0.as_ref().as_ptr().add(lane)) }
}

#[inline(always)]
pub(super) fn at3<N: Number>(rows: &Rows<N::Real>, lane: usize) -> Vector<N> {
    Vector(at(&rows[0], lane), at(&rows[1], lane), at(&rows[2], lane))
}

#[inline(always)]
pub(super) fn put<N: Number>(row: &mut Row<N::Real>, lane: usize, value: N) {
    assert!(lane + N::WIDTH <= N::Real::LANES);
    // SAFETY: the row holds so many numbers.
    unsafe { value.store(row.0.as_mut().as_mut_ptr().add(lane)) }
}

#[inline(always)]
pub(super) fn put3<N: Number>(rows: &mut Rows<N::Real>, lane: usize, v: Vector<N>) {
    let [x, y, z] = rows;
    put(x, lane, v.0);
    put(y, lane, v.1);
    put(z, lane, v.2);
}

#[inline(always)]
pub(super) fn add<N: Number>(row: &mut Row<N::Real>, lane: usize, value: N) {
    put(row, lane, at::<N>(row, lane) + value);
}
