//! What a block of nodes, and the elements below them, show at a moment: the one place that reads
//! the chain for the record.

use super::{
    lane::Lane,
    strength::{Metal, Strength},
};
use crate::{
    dynamics::{
        body::Body,
        kernel::{
            chain::{Chain, Rows},
            layout::Layout,
        },
    },
    simd::{lanes::DOUBLES, number::Real, vector::Vector},
};

const NONE: Lane = [0.0; DOUBLES];

/// A block of nodes as they are; contact quantities are averages over the steps since the last
/// sample.
#[derive(Debug, Clone, Copy)]
pub struct BlockSample {
    /// Effective tension of the element below, N.
    pub tension: Lane,
    /// Torque of the element below, N·m, in the sign of the chain.
    pub torque: Lane,
    /// Twist of the element below, rad, in the sign of the chain.
    pub twist: Lane,
    /// What its tension lengthens the element below, m.
    pub longer: Lane,
    /// Bending moment, N·m.
    pub bending: Lane,
    /// Von Mises stress of the weakest body around, Pa.
    pub stress: Lane,
    /// Contact force, N.
    pub normal: Lane,
    /// Axial friction on the wall, N, along the hole.
    pub axial: Lane,
    /// Friction torque, N·m.
    pub friction_torque: Lane,
    /// Distance from the hole's axis, m.
    pub offset: Lane,
    /// Cosine of the direction of the offset with the high side.
    pub up: Lane,
    /// Cosine of the direction of the offset with the right side, looking down the hole.
    pub right: Lane,
    /// How deep the node is in the wall, m; zero where no wall acts.
    pub penetration: Lane,
    /// Moment of the lateral velocity about the hole's axis, m²/s, clockwise looking down the hole.
    pub circling: Lane,
    /// Square of the lateral speed, m²/s².
    pub speed_square: Lane,
}

/// A block of elements: how their ends stand, what is in them, and the metal at their upper ends.
struct ElementSample<'a, R> {
    u1: [&'a [R; DOUBLES]; 3],
    u2: [&'a [R; DOUBLES]; 3],
    d2: [&'a [R; DOUBLES]; 3],
    chord: [&'a [R; DOUBLES]; 3],
    tension: &'a [R; DOUBLES],
    torque: &'a [R; DOUBLES],
    twist: &'a [R; DOUBLES],
    bending_far: &'a [R; DOUBLES],
    half_bow_near: &'a [R; DOUBLES],
    bow_far: &'a [R; DOUBLES],
    bending: &'a [R; DOUBLES],
    metal: &'a Metal,
}

impl BlockSample {
    const EMPTY: Self = Self {
        tension: NONE,
        torque: NONE,
        twist: NONE,
        longer: NONE,
        bending: NONE,
        stress: NONE,
        normal: NONE,
        axial: NONE,
        friction_torque: NONE,
        offset: NONE,
        up: NONE,
        right: NONE,
        penetration: NONE,
        circling: NONE,
        speed_square: NONE,
    };

    /// Looks at a block. `high` holds the high sides, block by block, `per_step` the inverse of the
    /// number of steps since the last sample.
    #[inline(always)]
    pub fn at<R: Real>(
        chain: &Chain<R>,
        high: &[Rows<f64>],
        body: &Body,
        strength: &Strength,
        block: usize,
        per_step: f64,
    ) -> Self {
        let mut sample = Self::EMPTY;
        sample.across_the_hole(chain, high, block, per_step);
        sample.along_the_string(chain, body, strength, block);
        sample
    }

    /// How the nodes lie and move in the hole, and what the wall does to them.
    #[inline(always)]
    fn across_the_hole<R: Real>(
        &mut self,
        chain: &Chain<R>,
        high: &[Rows<f64>],
        block: usize,
        per_step: f64,
    ) {
        let (row, part) = Layout::row_of::<R>(block);
        let (nodes, state) = (&chain.node_blocks[row], &chain.states[row]);
        let per_step = per_step / chain.parts_at(row);
        let high = parts(&high[block], 0);
        let (u, v) = (parts(&state.u, part), parts(&state.v, part));
        let tangents = parts(&nodes.tangent, part);
        let curvatures = parts(&nodes.curvature, part);
        let stiffness = nodes.stiffness.part(part);
        let clearances = nodes.clearance.part(part);
        let slopes = nodes.clearance_slope.part(part);
        let sum_normal = nodes.sum_normal.part(part);
        let sum_axial = nodes.sum_axial.part(part);
        let sum_torque = nodes.sum_torque.part(part);
        for lane in 0..DOUBLES {
            let (u, v, h) = (of(u, lane), of(v, lane), of(high, lane));
            let (tangent, curvature) = (of(tangents, lane), of(curvatures, lane));
            let z = u.dot(tangent);
            let across = u.minus(tangent, z).minus(curvature, 0.5 * z * z);
            // The root and the division do not wait for one another.
            let square = across.dot(across);
            let offset = square.sqrt();
            let per_offset = offset * (1.0 / square.max(f64::MIN_POSITIVE));
            let lateral = v.minus(tangent, v.dot(tangent));
            let touchable = stiffness[lane].to_f64() > 0.0;
            let clearance = clearances[lane].to_f64() + slopes[lane].to_f64() * z;
            let penetration = offset - clearance;
            self.offset[lane] = offset;
            self.penetration[lane] = if touchable { penetration } else { 0.0 };
            self.up[lane] = across.dot(h) * per_offset;
            self.right[lane] = across.dot(tangent.cross(h)) * per_offset;
            self.circling[lane] = tangent.dot(across.cross(lateral));
            self.speed_square[lane] = lateral.dot(lateral);
            self.normal[lane] = sum_normal[lane].to_f64() * per_step;
            self.axial[lane] = sum_axial[lane].to_f64() * per_step;
            self.friction_torque[lane] = sum_torque[lane].to_f64() * per_step;
        }
    }

    /// What the string carries at the nodes.
    #[inline(always)]
    fn along_the_string<R: Real>(
        &mut self,
        chain: &Chain<R>,
        body: &Body,
        strength: &Strength,
        block: usize,
    ) {
        let (row, part) = Layout::row_of::<R>(block);
        let (elements, state) = (&chain.element_blocks[row], &chain.states[row]);
        let ends = chain.ends(row);
        let element = ElementSample {
            u1: parts(&state.u, part),
            u2: parts(&ends.u, part),
            d2: parts(&ends.d, part),
            chord: parts(&elements.chord, part),
            tension: elements.tension.part(part),
            torque: elements.torque.part(part),
            twist: elements.twist.part(part),
            bending_far: elements.bending_far.part(part),
            half_bow_near: elements.half_bow_near.part(part),
            bow_far: elements.bow_far.part(part),
            bending: elements.bending.part(part),
            metal: strength.block(block),
        };
        let d1 = parts(&state.d, part);
        for lane in 0..DOUBLES {
            self.bear(&element, lane, of(d1, lane));
        }
        // The element below a bend stands on another face of the body: what is bent without stress
        // bears none.
        for bend in &body.bends {
            let (block_of_bend, lane) = chain.layout().place(bend.index);
            if block_of_bend == block {
                self.bear(&element, lane, bend.pose(chain).d1);
            }
        }
    }

    /// What the string carries at a node whose element below sees the director `d1` there. The
    /// bending moment is the elastic one that this element has at its upper end; the bit, below
    /// which there is none, carries none.
    #[inline(always)]
    fn bear<R: Real>(&mut self, element: &ElementSample<'_, R>, lane: usize, d1: Vector<f64>) {
        let number = |of: &[R; DOUBLES]| of[lane].to_f64();
        let (u1, u2) = (of(element.u1, lane), of(element.u2, lane));
        let d2 = of(element.d2, lane);
        let chord = of(element.chord, lane) + (u2 - u1);
        // Newton's step from the rest length to the inverse of the chord's: a stretch of 1e-3
        // leaves 1.5e-6, and no root is drawn.
        let rest = element.metal.per_length[lane];
        let t = chord.scaled(rest * (1.5 - 0.5 * chord.dot(chord) * rest * rest));
        let (tension, torque) = (number(element.tension), number(element.torque));
        // The gradient of the element's energy on its upper director: `rod::element`.
        let bending_far = number(element.bending_far);
        let bending_near = bending_far + 2.0 * number(element.bending);
        let near = bending_near + 2.0 * number(element.half_bow_near) * tension;
        let far = bending_far - number(element.bow_far) * tension;
        let pull = near * t.dot(d1) + far * t.dot(d2);
        let moment = d2.scaled(far).minus(t, pull).cross(d1);
        let bending = moment.dot(moment).sqrt();
        self.tension[lane] = tension;
        self.torque[lane] = torque;
        // Below the bit there is no element, whatever its rows hold.
        let compliance = element.metal.compliance[lane];
        self.twist[lane] = if compliance > 0.0 { number(element.twist) } else { 0.0 };
        self.longer[lane] = tension * compliance;
        self.bending[lane] = bending;
        self.stress[lane] = element.metal.stress_Pa(lane, tension, bending, torque);
    }
}

/// The part of rows that stands beside a block.
#[inline(always)]
fn parts<R: Real>(rows: &Rows<R>, part: usize) -> [&[R; DOUBLES]; 3] {
    rows.each_ref().map(|row| row.part(part))
}

#[inline(always)]
fn of<R: Real>(rows: [&[R; DOUBLES]; 3], lane: usize) -> Vector<f64> {
    let [x, y, z] = rows.map(|row| row[lane].to_f64());
    Vector(x, y, z)
}
