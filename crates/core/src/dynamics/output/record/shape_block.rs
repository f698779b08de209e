//! Bending between the nodes of the elements below a block of nodes.

use serde::{Deserialize, Serialize};

use super::{
    deflection::{Deflection, Ends},
    end_stiffness::EndStiffness,
    lane::{Lane, add, at, put},
};
use crate::{
    dynamics::kernel::layout::Layout,
    rod::beam_column::{BeamColumn, EULER, Middle},
    simd::{
        lanes::DOUBLES,
        number::{Doubles, Real},
        vector::Vector,
    },
};

/// The elements below a block of nodes.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[repr(C, align(64))]
pub struct ShapeBlock {
    /// Inverse of the rest length, 1/m.
    pub per_length: Lane,
    /// Buoyed weight, N/m.
    pub weight: Lane,
    /// Moment at the ends over the load, m².
    pub at_ends: Lane,
    /// Moment half-way over the load, m².
    pub half_way: Lane,
    /// Moment at the ends over the sum of the angles by which both are turned, N·m.
    pub odd: Lane,
    /// Part of the node's moment that is that of the element below; of the element above the rest.
    pub below: Lane,
    /// `L²/64EI`, 1/N.
    pub column: Lane,
    /// `EI`, N·m².
    pub stiffness: Lane,
    /// Radius of the body, m.
    pub radius: Lane,
    /// Sum of the sag, m.
    pub sag: Lane,
    /// Number of samples in which the body touched.
    pub touched: Lane,
    /// Compression over the element's own buckling load, averaged over the last looks.
    pub compressed: Lane,
    /// The largest of these averages since the start of the run.
    pub most_compressed: Lane,
}

/// Weight of the last look at an element in the average of its compression: of a compression that
/// stays the average reaches nine tenths after eight looks.
const LAST_LOOK: f64 = 0.25;

/// Nothing yet.
pub const NONE: Lane = [0.0; DOUBLES];

impl ShapeBlock {
    /// Of elements that nobody has looked at yet.
    pub const EMPTY: Self = Self {
        per_length: NONE,
        weight: NONE,
        at_ends: NONE,
        half_way: NONE,
        odd: NONE,
        below: NONE,
        column: NONE,
        stiffness: NONE,
        radius: NONE,
        sag: NONE,
        touched: NONE,
        compressed: NONE,
        most_compressed: NONE,
    };

    /// Coefficients from which the moments at the lower ends are computed.
    pub fn handed_on(&mut self) -> [&mut Lane; 8] {
        let Self { per_length, weight, at_ends, half_way, odd, column, stiffness, radius, .. } =
            self;
        [per_length, weight, at_ends, half_way, odd, column, stiffness, radius]
    }
}

/// Moments in elements, N·m, towards the centre of curvature.
#[derive(Debug, Clone, Copy)]
pub struct Moments<N> {
    /// At their upper ends.
    pub upper: Vector<N>,
    /// At their lower ends.
    pub lower: Vector<N>,
    /// Half-way.
    pub half_way: Vector<N>,
}

impl ShapeBlock {
    /// The same as if no end of the string were free.
    #[inline(always)]
    pub fn moments<N: Doubles, R: Real>(
        &self,
        ends: &Ends<'_, R>,
        block: usize,
        lane: usize,
    ) -> Moments<N> {
        let deflection = self.deflection::<N, R>(ends, block, lane);
        let even = deflection.by(at(&self.at_ends, lane));
        let odd = deflection.odd.scaled(at(&self.odd, lane));
        let half_way = deflection.by(at(&self.half_way, lane));
        Moments { upper: even - odd, lower: even + odd, half_way }
    }

    #[inline(always)]
    fn deflection<N: Doubles, R: Real>(
        &self,
        ends: &Ends<'_, R>,
        block: usize,
        lane: usize,
    ) -> Deflection<N> {
        ends.deflection(block, lane, [at(&self.per_length, lane), at(&self.weight, lane)])
    }

    /// Looks at the elements at lanes of a block. How they resist being turned by their ends.
    #[inline(always)]
    pub fn look<N: Doubles, R: Real>(
        &mut self,
        ends: &Ends<'_, R>,
        (block, lane): (usize, usize),
        counts: bool,
    ) -> EndStiffness<N> {
        let deflection = self.deflection::<N, R>(ends, block, lane);
        let around = ends.around(block, lane, at(&self.per_length, lane));
        let (row, part) = Layout::row_of::<R>(block);
        let elements = &ends.chain.element_blocks[row];
        let [length, far] =
            [&elements.length, &elements.bending_far].map(|row| at::<N, R>(row.part(part), lane));
        let tension = deflection.pull * length;
        let column = BeamColumn::of(tension * at(&self.column, lane));
        let middle = Middle {
            load: deflection.load(),
            // The parabola's middle, off the chord's.
            offset: around.offset.minus(deflection.even, N::splat(0.125) * length),
            clearance: around.radius - at(&self.radius, lane),
        };
        let shape = column.bent(length, at(&self.stiffness, lane), &middle);
        // `EI/L`, of which shear takes its part.
        let odd = N::splat(1.0 / 3.0) * (far + deflection.bending) * column.odd();
        put(&mut self.at_ends, lane, shape.at_ends);
        put(&mut self.half_way, lane, shape.half_way);
        put(&mut self.odd, lane, odd);
        if counts {
            add(&mut self.sag, lane, shape.sag);
            add(&mut self.touched, lane, shape.touches);
            let share = tension * at(&self.column, lane) * N::splat(-1.0 / EULER);
            let before: N = at(&self.compressed, lane);
            let compressed = before + N::splat(LAST_LOOK) * (share - before);
            put(&mut self.compressed, lane, compressed);
            let most = compressed.max(at(&self.most_compressed, lane));
            put(&mut self.most_compressed, lane, most);
        }
        EndStiffness::of(&deflection, [shape.at_ends, shape.half_way], odd)
    }

    /// Rotational end stiffness of elements at lanes of a block, from the last update of their
    /// shapes.
    pub fn end_stiffness<N: Doubles, R: Real>(
        &self,
        ends: &Ends<'_, R>,
        block: usize,
        lane: usize,
    ) -> EndStiffness<N> {
        let deflection = self.deflection::<N, R>(ends, block, lane);
        let parts = [&self.at_ends, &self.half_way].map(|part| at::<N, f64>(part, lane));
        EndStiffness::of(&deflection, parts, at(&self.odd, lane))
    }

    /// Distributes a node's unbalanced moment, N·m, to the elements above and below it, in
    /// proportion to their stiffness.
    #[inline(always)]
    pub fn distribute<N: Doubles>(&mut self, lane: usize, [above, below]: [N; 2], tilts: N) {
        let part = above / (above + below).max(N::splat(N::TINY));
        // A node that may not tilt hands nothing on from the one side to the other: the top has the
        // element below it, a clamped bit, below which there is none, that above.
        let clamped = below.if_positive(N::splat(1.0), N::zero());
        put(&mut self.below, lane, tilts.if_positive(part, clamped));
    }
}
