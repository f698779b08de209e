//! How the elements bend between their nodes, as it was when that was last looked at.

use serde::{Deserialize, Serialize};

use super::{
    above::Above,
    deflection::{Deflection, Ends},
    lane::{Lane, add, at, put},
};
use crate::{
    damage::{Damaged, ensure},
    dynamics::kernel::layout::Layout,
    model::Model,
    rod::{
        beam_column::{BeamColumn, Middle},
        mesh::Mesh,
    },
    simd::{
        apart::Apart,
        dispatch::{for_each_instruction_set, with_fastest_instruction_set},
        lanes::DOUBLES,
        number::{Doubles, Real},
        vector::Vector,
    },
};

/// Samples from one look at the elements' shapes to the next: what tension and wall make of a load
/// changes slowly, the load itself and the ends are those of every sample.
const SAMPLES: u64 = 32;

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
    column: Lane,
    /// `EI`, N·m².
    stiffness: Lane,
    /// Radius of the body, m.
    radius: Lane,
    /// Sum of the sag, m.
    sag: Lane,
    /// How often the body touched.
    touched: Lane,
}

const NONE: Lane = [0.0; DOUBLES];

impl ShapeBlock {
    const EMPTY: Self = Self {
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
    };

    /// What moments at the lower ends are made with.
    fn handed_on(&mut self) -> [&mut Lane; 8] {
        let Self { per_length, weight, at_ends, half_way, odd, column, stiffness, radius, .. } =
            self;
        [per_length, weight, at_ends, half_way, odd, column, stiffness, radius]
    }
}

/// What elements bear, N·m, towards the centre of curvature.
#[derive(Debug, Clone, Copy)]
pub struct Moments<N> {
    /// At their upper ends.
    pub upper: Vector<N>,
    /// At their lower ends.
    pub lower: Vector<N>,
    /// Half-way.
    pub half_way: Vector<N>,
}

/// The shapes of all elements.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Shapes {
    layout: Layout,
    blocks: Vec<ShapeBlock>,
    /// How many looks the sums hold.
    looks: u64,
    /// Samples since the last look.
    samples: u64,
}

impl Shapes {
    /// Of the elements of a string that nobody has looked at yet.
    pub fn new(model: &Model, mesh: &Mesh, layout: Layout) -> Self {
        let mut blocks = vec![ShapeBlock::EMPTY; layout.blocks()];
        for (index, element) in mesh.elements.iter().enumerate() {
            let (block, lane) = layout.place(index);
            let (of, section) = (&mut blocks[block], &element.section);
            let stiffness = section.bending_stiffness_N_m2;
            of.per_length[lane] = 1.0 / element.length_m;
            of.weight[lane] = section.buoyed_weight_N_per_m(model.mud.density_kg_per_m3);
            of.column[lane] = element.length_m.powi(2) / (64.0 * stiffness);
            of.stiffness[lane] = stiffness;
            of.radius[lane] = 0.5 * section.od_m;
        }
        let mut shapes = Self { layout, blocks, looks: 0, samples: 0 };
        shapes.share();
        shapes
    }

    /// Gives the lower region what the upper one knows of the element that both have.
    fn share(&mut self) {
        let Some((index, (block, lane))) = self.layout.shared() else {
            return;
        };
        let (from, from_lane) = self.layout.place(index);
        let mut element = self.blocks[from];
        for (to, of) in self.blocks[block].handed_on().into_iter().zip(element.handed_on()) {
            to[lane] = of[from_lane];
        }
    }

    /// Whether stored ones are in this layout.
    pub(super) fn check(&self, layout: Layout) -> Result<(), Damaged> {
        let fits = self.layout == layout && self.blocks.len() == layout.blocks();
        ensure(fits, "the shapes of the elements")
    }

    /// The sums begin anew, with the next sample.
    pub fn restart(&mut self) {
        for block in &mut self.blocks {
            (block.sag, block.touched) = (NONE, NONE);
        }
        (self.looks, self.samples) = (0, 0);
    }

    /// Counts a sample; whether the shapes are to be looked at.
    pub fn are_due(&mut self) -> bool {
        let due = self.samples == 0;
        self.samples = (self.samples + 1) % SAMPLES;
        due
    }

    /// Looks at the shapes.
    pub fn look(&mut self, ends: &Ends<'_, impl Real>) {
        with_fastest_instruction_set!(look(self, ends));
        self.share();
        self.looks += 1;
    }

    /// A block of elements.
    #[inline(always)]
    pub fn block(&self, block: usize) -> &ShapeBlock {
        &self.blocks[block]
    }

    /// Mean sag of the element below a node, m, beyond the arc that its ends' directions have.
    pub fn sag_m(&self, index: usize) -> f64 {
        let (block, lane) = self.layout.place(index);
        self.blocks[block].sag[lane] / self.looks.max(1) as f64
    }

    /// How often the middle of the element below a node touched the wall, from 0 to 1.
    pub fn touched(&self, index: usize) -> f64 {
        let (block, lane) = self.layout.place(index);
        self.blocks[block].touched[lane] / self.looks.max(1) as f64
    }

    #[inline(always)]
    fn look_in<N: Doubles, R: Real>(&mut self, ends: &Ends<'_, R>) {
        let chain = ends.chain;
        let parts = R::LANES / DOUBLES;
        for region in 0..chain.regions() {
            let rows = chain.rows_of(region);
            // What holds the nodes of the first row from above is found first, and once more as its
            // own row comes.
            let mut above = Above::<1>::NONE;
            for (row, counts) in
                [(rows.end - 1, false)].into_iter().chain(rows.map(|row| (row, true)))
            {
                for part in 0..parts {
                    for lane in (0..DOUBLES).step_by(N::WIDTH) {
                        let [held] = above.at::<N>(part, lane);
                        let block = row * parts + part;
                        let holds =
                            self.blocks[block].look::<N, R>(ends, (block, lane), held, counts);
                        above.put(part, lane, [holds]);
                    }
                }
                if !counts {
                    above.close(parts);
                }
            }
        }
    }
}

impl ShapeBlock {
    /// What the elements at lanes of a block bear, in the shape that they had when last looked at.
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

    /// Looks at the elements at lanes of a block; `held` is what the elements above hold the nodes
    /// with. What these ones hold their ends with, N·m.
    #[inline(always)]
    fn look<N: Doubles, R: Real>(
        &mut self,
        ends: &Ends<'_, R>,
        (block, lane): (usize, usize),
        held: N,
        counts: bool,
    ) -> N {
        let deflection = self.deflection::<N, R>(ends, block, lane);
        let around = ends.around(block, lane, at(&self.per_length, lane));
        let (row, part) = Layout::row_of::<R>(block);
        let elements = &ends.chain.element_blocks[row];
        let [length, far] =
            [&elements.length, &elements.bending_far].map(|of| at::<N, R>(of.part(part), lane));
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
        let holds = deflection.bending + deflection.pull * shape.at_ends + odd;
        let below = held / (held + holds).max(N::splat(N::TINY));
        // A node that may not tilt hands nothing on from the one side to the other: the top has the
        // element below it, a clamped bit, below which there is none, that above.
        let clamped = holds.if_positive(N::splat(1.0), N::zero());
        let below = ends.tilts::<N>(block, lane).if_positive(below, clamped);
        put(&mut self.at_ends, lane, shape.at_ends);
        put(&mut self.half_way, lane, shape.half_way);
        put(&mut self.odd, lane, odd);
        put(&mut self.below, lane, below);
        if counts {
            add(&mut self.sag, lane, shape.sag);
            add(&mut self.touched, lane, shape.touches);
        }
        holds
    }
}

macro_rules! compiled_for {
    ($set:ident, $number:ident, $fused:expr $(, $features:literal)?) => {
        mod $set {
            use super::*;

            $(#[target_feature(enable = $features)])?
            pub(super) fn look<R: Real>(shapes: &mut Shapes, ends: &Ends<'_, R>) {
                shapes.look_in::<Apart<crate::simd::dispatch::$number<f64>>, R>(ends);
            }
        }
    };
}
for_each_instruction_set!(compiled_for);
