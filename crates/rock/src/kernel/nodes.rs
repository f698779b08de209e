//! A layer of nodes moves.

use super::fields::Fields;
use crate::grid::Grid;
use wholestring_numbers::simd::number::Number;

/// The nodes of a layer go where their velocities carry them.
///
/// # Safety
/// `fields` point to the state of a block of this grid, whose layer nothing else uses.
#[inline(always)]
pub unsafe fn drift<N: Number<Real = f64>>(fields: &Fields, grid: &Grid, dt: f64, layer: usize) {
    let dt = N::splat(dt);
    let from = layer * grid.node_layer();
    for (u, v) in fields.displacement.iter().zip(fields.velocity) {
        for at in (from..from + grid.node_layer()).step_by(N::WIDTH) {
            // SAFETY: the places of a layer are a multiple of the lanes.
            unsafe { N::load(v.add(at)).mul_add(dt, N::load(u.add(at))).store(u.add(at)) }
        }
    }
}

/// Applies the impulses of the elements below and above to the nodes of a layer.
///
/// # Safety
/// As for [`drift`]; each of `pulls` and `more` is as long as a layer.
#[inline(always)]
pub unsafe fn kick<N: Number<Real = f64>>(
    fields: &Fields,
    grid: &Grid,
    dt: f64,
    layer: usize,
    pulls: &[Vec<f64>; 3],
    more: Option<&[Vec<f64>; 3]>,
) {
    let dt = N::splat(dt);
    let from = layer * grid.node_layer();
    for (axis, v) in fields.velocity.iter().enumerate() {
        for at in (0..grid.node_layer()).step_by(N::WIDTH) {
            // SAFETY: the places of a layer are a multiple of the lanes.
            unsafe {
                let mut pull = N::load(pulls[axis].as_ptr().add(at));
                if let Some(more) = more {
                    pull = pull + N::load(more[axis].as_ptr().add(at));
                }
                let inverse = N::load(fields.inverse_mass.add(from + at));
                let v = v.add(from + at);
                (dt * inverse).neg_mul_add(pull, N::load(v)).store(v);
            }
        }
    }
}
