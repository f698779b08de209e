//! A row of elements.

use super::fields::{Fields, RowBook, lanes};
use wholestring_numbers::simd::number::Number;

use crate::{
    constants::{Constants, MAX_SQUEEZED},
    element::{Modes, Motion, pulls, spread, square, turned},
    grid::{GROUP, Grid},
};

/// Forces of a row of elements on its nodes, N.
#[derive(Debug, Clone)]
pub struct Pulls {
    /// One after the other: near and far corners in x of the four edges along x, by component. A
    /// group of zeros precedes and follows each.
    forces_N: Vec<f64>,
    length: usize,
}

/// Edges along x of an element, near and far ends of them, components.
const STREAMS: usize = 4 * 2 * 3;

impl Pulls {
    pub fn new(grid: &Grid) -> Self {
        let length = grid.element_row() + 2 * GROUP;
        Self { forces_N: vec![0.0; STREAMS * length], length }
    }

    /// Index of the forces of an element: corner and component.
    #[inline(always)]
    fn place(&self, corner: usize, axis: usize, element: usize) -> usize {
        (3 * corner + axis) * self.length + GROUP + element
    }

    /// Adds the forces of the elements to their nodes: the two rows of nodes above the elements or
    /// those below.
    ///
    /// # Safety
    /// `layer` is a layer of nodes of this grid.
    #[inline(always)]
    pub unsafe fn hand_on<N: Number<Real = f64>>(
        &self,
        grid: &Grid,
        j: usize,
        below: usize,
        layer: &mut [Vec<f64>; 3],
    ) {
        for side in 0..2 {
            let from = (j + side) * grid.node_row();
            let edge = 2 * side + 4 * below;
            for (axis, pulls) in layer.iter_mut().enumerate() {
                // Node i meets the near corner of element i and the far corner of element i − 1.
                let (near, far) = (self.place(edge, axis, 0), self.place(edge + 1, axis, 0) - 1);
                let pulls = pulls[from..from + grid.node_row()].as_mut_ptr();
                for at in (0..grid.node_row()).step_by(N::WIDTH) {
                    // SAFETY: a row of nodes is a group longer than one of elements, as are the
                    // pulls.
                    unsafe {
                        let sum =
                            N::load(pulls.add(at)) + N::load(self.forces_N.as_ptr().add(near + at));
                        (sum + N::load(self.forces_N.as_ptr().add(far + at))).store(pulls.add(at));
                    }
                }
            }
        }
    }
}

/// Sums of a row, lane by lane.
#[derive(Clone, Copy)]
struct Books<N> {
    plastic: N,
    viscous: N,
    least: N,
}

/// A row of elements answers. Whether there is an element left in it.
///
/// # Safety
/// `fields` point to the state of a block of this grid, whose elements in this row and their book
/// nothing else uses.
#[inline(always)]
pub unsafe fn work<N: Number<Real = f64>>(
    fields: &Fields,
    grid: &Grid,
    constants: &Constants,
    [j, k]: [usize; 2],
    out: &mut Pulls,
) -> bool {
    let groups = grid.element_row() / GROUP;
    let row = grid.element([0, j, k]);
    // SAFETY: the groups of a row.
    let left = unsafe { std::slice::from_raw_parts(fields.left.add(row / GROUP), groups) };
    if left.iter().all(|&left| left == 0) {
        return false;
    }
    let empty = Books { plastic: N::zero(), viscous: N::zero(), least: N::splat(1.0) };
    // By the register's place in a group: sums are then the same, however wide it is.
    let mut books = [empty; GROUP];
    let nodes = grid.node([0, j, k]);
    for (group, &left) in left.iter().enumerate() {
        for lane in lanes::<N>() {
            let at = group * GROUP + lane;
            // SAFETY: the caller's.
            unsafe {
                if left > 0 {
                    elements::<N>(
                        fields,
                        grid,
                        constants,
                        nodes + at,
                        row + at,
                        at,
                        out,
                        &mut books[lane / N::WIDTH],
                    );
                } else {
                    for corner in 0..8 {
                        for axis in 0..3 {
                            N::zero()
                                .store(out.forces_N.as_mut_ptr().add(out.place(corner, axis, at)));
                        }
                    }
                }
            }
        }
    }
    let of_all = |part: fn(&Books<N>) -> N| in_lanes(books.each_ref().map(part));
    let (plastic, viscous, least) =
        (of_all(|sums| sums.plastic), of_all(|sums| sums.viscous), of_all(|sums| sums.least));
    // SAFETY: the book of this row.
    let book: &mut RowBook = unsafe { &mut *fields.books.add(k * grid.element_rows() + j) };
    book.plastic_J += constants.volume_m3 * plastic.iter().sum::<f64>();
    book.viscous_J += viscous.iter().sum::<f64>();
    book.min_intact = least.into_iter().fold(1.0, f64::min);
    true
}

/// The lanes of a group's registers.
#[inline(always)]
fn in_lanes<N: Number<Real = f64>>(registers: [N; GROUP]) -> [f64; GROUP] {
    let mut all = [0.0; GROUP];
    for (lane, register) in lanes::<N>().zip(registers) {
        // SAFETY: a group is a multiple of the register's lanes.
        unsafe { register.store(all.as_mut_ptr().add(lane)) };
    }
    all
}

/// A field at the corners of elements.
///
/// # Safety
/// `fields` are over the nodes of this grid, `node` the first corner of the first of the elements.
#[inline(always)]
unsafe fn corners<N: Number<Real = f64>>(
    grid: &Grid,
    fields: [*mut f64; 3],
    node: usize,
) -> [[N; 8]; 3] {
    let mut out = [[N::zero(); 8]; 3];
    for (axis, field) in fields.into_iter().enumerate() {
        for edge in 0..4 {
            let at = node + (edge & 1) * grid.node_row() + (edge >> 1) * grid.node_layer();
            // SAFETY: a row of nodes is a group longer than one of elements.
            unsafe {
                out[axis][2 * edge] = N::load(field.add(at));
                out[axis][2 * edge + 1] = N::load(field.add(at + 1));
            }
        }
    }
    out
}

/// As many elements as a register holds.
///
/// # Safety
/// As for [`work`].
#[inline(always)]
// Indices say which components are combined.
#[allow(clippy::too_many_arguments, clippy::needless_range_loop)]
unsafe fn elements<N: Number<Real = f64>>(
    fields: &Fields,
    grid: &Grid,
    constants: &Constants,
    node: usize,
    element: usize,
    at: usize,
    out: &mut Pulls,
    books: &mut Books<N>,
) {
    let zero = N::zero();
    let dt = N::splat(constants.dt_s);
    // SAFETY: the caller's.
    let (displacement, velocity) = unsafe {
        (
            Modes::of(corners(grid, fields.displacement, node), constants),
            Modes::of(corners(grid, fields.velocity, node), constants),
        )
    };
    // ΔF, the change of the deformation gradient in the step.
    let mut change = velocity.gradient;
    for i in 0..3 {
        for j in 0..3 {
            change[i][j] = change[i][j] * dt;
        }
    }
    let motion = Motion::of(displacement.gradient, change);

    let mut stress = [zero; 6];
    // SAFETY: the elements of this row.
    let intact = unsafe {
        for i in 0..6 {
            stress[i] = N::load(fields.stress[i].add(element));
        }
        N::load(fields.intact.add(element))
    };
    // Jaumann's rate: the stress turns with the element, then takes the strain of the step.
    let update = constants.law.return_map(turned(motion.turn, stress), motion.strain, intact);
    // An element compressed beyond the stability limit of the step fails; a removed one (negative)
    // is unchanged.
    let fit = N::splat(MAX_SQUEEZED) - square(motion.inverse);
    let new_intact = intact.if_positive(fit.if_positive(update.intact, zero), intact);
    // SAFETY: as above.
    unsafe {
        for i in 0..6 {
            stress[i] = intact.if_positive(update.stress[i], zero);
            stress[i].store(fields.stress[i].add(element));
        }
        new_intact.store(fields.intact.add(element));
    }
    books.plastic = books.plastic + intact.if_positive(update.plastic, zero);
    books.least = books.least.min(intact.if_positive(new_intact, N::splat(1.0)));

    // Bulk viscosity, and the pressure of the hole: elements pull by τ + p J, so p acts on free
    // faces.
    let swelling = motion.strain[0] + motion.strain[1] + motion.strain[2];
    let viscous = N::splat(constants.viscosity) * swelling;
    let held = motion.volume.mul_add(N::splat(constants.pressure_Pa), viscous);
    let [xx, yy, zz, xy, yz, zx] = stress;
    // V₀ (τ + p J) F⁻ᵀ, as coefficients of the gradients.
    let gradients = pulls([xx + held, yy + held, zz + held, xy, yz, zx], motion.inverse, constants);
    let (stiff, damping) = (N::splat(constants.hourglass), N::splat(constants.hourglass_damping));
    // Hourglasses are held by a spring and a dashpot; one point of integration does not feel them.
    let mut damped = zero;
    for axis in 0..3 {
        let mut hourglass = displacement.hourglass[axis];
        for mode in 0..4 {
            let rate = velocity.hourglass[axis][mode];
            hourglass[mode] = rate.mul_add(damping, hourglass[mode] * stiff);
            damped = rate.mul_add(rate, damped);
        }
        let pull = spread(gradients[axis], hourglass);
        for corner in 0..8 {
            // An element that is gone pulls at nothing.
            let pull = intact.if_positive(pull[corner], zero);
            // SAFETY: the pulls are as long as a row of elements.
            unsafe { pull.store(out.forces_N.as_mut_ptr().add(out.place(corner, axis, at))) };
        }
    }
    // Work of the bulk viscosity and of the hourglass dashpots in the step.
    let lost = (viscous * swelling).mul_add(N::splat(constants.volume_m3), damped * (damping * dt));
    books.viscous = books.viscous + intact.if_positive(lost, zero);
}
