//! Bending of the elements between their nodes, from the last update of their shapes.

use serde::{Deserialize, Serialize};

use super::{
    deflection::Ends,
    lane::Above,
    shape_block::{Moments, NONE, ShapeBlock},
    string_end::StringEnd,
};
use crate::{
    damage::{Damaged, ensure},
    dynamics::kernel::layout::Layout,
    model::Model,
    rod::{in_fluid, mesh::Mesh},
    simd::{
        dispatch::{for_each_instruction_set, with_fastest_instruction_set},
        lanes::DOUBLES,
        number::{Doubles, Real},
    },
};

/// Number of samples between updates of the elements' shapes: the effect of tension and wall on a
/// load changes slowly, while the load itself and the ends are evaluated at every sample.
const SAMPLES: u64 = 32;

/// The shapes of all elements.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Shapes {
    layout: Layout,
    blocks: Vec<ShapeBlock>,
    ends_of_string: Vec<StringEnd>,
    /// Blocks with elements that carry moments over from the string's ends.
    carry: Vec<bool>,
    /// Number of updates in the sums.
    looks: u64,
    /// Samples since the last look.
    samples: u64,
}

impl Shapes {
    /// Of the elements of a string that nobody has looked at yet.
    pub fn new(model: &Model, mesh: &Mesh, layout: Layout) -> Self {
        let mut blocks = vec![ShapeBlock::EMPTY; layout.blocks()];
        let in_fluid = in_fluid::along(model, mesh);
        for (index, element) in mesh.elements.iter().enumerate() {
            let (block, lane) = layout.place(index);
            let (shape, section) = (&mut blocks[block], &element.section);
            let stiffness = section.bending_stiffness_N_m2;
            shape.per_length[lane] = 1.0 / element.length_m;
            shape.weight[lane] = in_fluid[index].weight_N_per_m;
            shape.column[lane] = element.length_m.powi(2) / (64.0 * stiffness);
            shape.stiffness[lane] = stiffness;
            shape.radius[lane] = 0.5 * section.od_m;
        }
        let ends_of_string = StringEnd::both(layout, mesh.elements.len());
        let mut carry = vec![false; layout.blocks()];
        for carry_over in ends_of_string.iter().flat_map(StringEnd::carry_overs) {
            carry[carry_over.block()] = true;
        }
        let mut shapes = Self { layout, blocks, ends_of_string, carry, looks: 0, samples: 0 };
        shapes.share();
        shapes
    }

    /// Copies to the lower region the upper one's data of the shared element.
    fn share(&mut self) {
        let Some((index, (block, lane))) = self.layout.shared() else {
            return;
        };
        let (from, from_lane) = self.layout.place(index);
        let mut element = self.blocks[from];
        for (to, source) in self.blocks[block].handed_on().into_iter().zip(element.handed_on()) {
            to[lane] = source[from_lane];
        }
    }

    /// Whether stored ones are in this layout.
    pub(super) fn check(&self, layout: Layout) -> Result<(), Damaged> {
        let fits = self.layout == layout
            && self.blocks.len() == layout.blocks()
            && self.carry.len() == layout.blocks()
            && self.ends_of_string.iter().all(|end| end.is_of(layout));
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
        self.carry_on(ends);
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

    /// The largest compression of the element below a node since the start of the run over its own
    /// buckling load, averaged over some looks: a second or two.
    pub fn most_compressed(&self, index: usize) -> f64 {
        let (block, lane) = self.layout.place(index);
        self.blocks[block].most_compressed[lane]
    }

    /// Fraction of samples in which the middle of the element below a node touched the wall, from 0
    /// to 1.
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
            // The data from above for the nodes of the first row are computed first, and again with
            // their own row.
            let mut above = Above::<1>::NONE;
            for (row, counts) in
                [(rows.end - 1, false)].into_iter().chain(rows.map(|row| (row, true)))
            {
                for part in 0..parts {
                    for lane in (0..DOUBLES).step_by(N::WIDTH) {
                        let [held] = above.at::<N>(part, lane);
                        let block = row * parts + part;
                        let place = (block, lane);
                        let stiffness = self.blocks[block].look::<N, R>(ends, place, counts);
                        let mut holds = [stiffness.held(); 2];
                        if self.carry[block] {
                            for end in &mut self.ends_of_string {
                                end.look(ends, place, &stiffness, &mut holds);
                            }
                        }
                        let [upper, lower] = holds;
                        let tilts = ends.tilts::<N>(block, lane);
                        self.blocks[block].distribute(lane, [held, upper], tilts);
                        above.put(part, lane, [lower]);
                    }
                }
                if !counts {
                    above.close(parts);
                }
            }
        }
    }
}

impl Shapes {
    /// Moments in the elements at lanes of a block, with the shapes of the last update.
    #[inline(always)]
    pub fn moments<N: Doubles, R: Real>(
        &self,
        ends: &Ends<'_, R>,
        block: usize,
        lane: usize,
    ) -> Moments<N> {
        let mut moments = self.blocks[block].moments::<N, R>(ends, block, lane);
        if self.carry[block] {
            let all = self.ends_of_string.iter().flat_map(StringEnd::carry_overs);
            for carry_over in all.filter(|carry_over| carry_over.is_at::<N>(block, lane)) {
                carry_over.act(&mut moments, lane);
            }
        }
        moments
    }

    /// Where the top is free to tilt, the difference between the first and the second element at
    /// the node between them is carried over to the far end of the second, as a fraction of the
    /// second's moment at the node, so that it turns with it; at the bit likewise.
    fn carry_on(&mut self, ends: &Ends<'_, impl Real>) {
        let mut ends_of_string = std::mem::take(&mut self.ends_of_string);
        for end in &mut ends_of_string {
            let (Some(own), Some(next)) = (end.own.first(), end.next.first()) else { continue };
            if !end.is_free(ends) {
                continue;
            }
            let mut beside = self.blocks[own.block()].moments(ends, own.block(), own.lane());
            own.act(&mut beside, own.lane());
            let (block, lane) = (next.block(), next.lane());
            let moments = self.blocks[block].moments::<f64, _>(ends, block, lane);
            let stiffness = self.blocks[block].end_stiffness::<f64, _>(ends, block, lane);
            // Part of the difference that the inner element takes.
            let (has, differs, takes) = if end.is_upper {
                let has = moments.upper;
                (has, beside.lower - has, 1.0 - self.blocks[block].below[lane])
            } else {
                let has = moments.lower;
                (has, beside.upper - has, self.blocks[own.block()].below[own.lane()])
            };
            let square = has.dot(has).max(f64::MIN_POSITIVE);
            let part = (differs.dot(has) / square).clamp(-1.0, 1.0);
            let carried = -stiffness.carry_over() * takes * part;
            for next in &mut end.next {
                next.carry_on(carried);
            }
        }
        self.ends_of_string = ends_of_string;
    }
}

macro_rules! compiled_for {
    ($set:ident, $number:ident $(, $features:literal)?) => {
        mod $set {
            use super::*;

            $(#[target_feature(enable = $features)])?
            pub(super) fn look<R: Real>(shapes: &mut Shapes, ends: &Ends<'_, R>) {
                shapes.look_in::<crate::simd::dispatch::$number<f64>, R>(ends);
            }
        }
    };
}
for_each_instruction_set!(compiled_for);
