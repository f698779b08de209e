//! What nodes, and the elements below them, show at a moment: the one place that reads the chain
//! for the record.

use super::{
    lane::{Lane, at, at3, put},
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
    simd::{
        apart::Apart,
        dispatch::{for_each_instruction_set, with_fastest_instruction_set},
        lanes::DOUBLES,
        number::{Doubles, Real},
        vector::Vector,
    },
};

/// What samples are read from.
#[derive(Debug)]
pub struct Source<'a, R: Real> {
    /// The chain, closed.
    pub chain: &'a Chain<R>,
    /// High side of each node, block by block.
    pub high: &'a [Rows<f64>],
    /// The bodies that carry the stresses.
    pub strength: &'a Strength,
    /// Nodes with bends.
    pub bent: &'a [BentNode],
    /// Inverse of the number of steps of the uppermost region since the last sample.
    pub per_step: f64,
}

/// A node with a bend. The element below stands on another face of the body: what is bent without
/// stress bears none.
#[derive(Debug, Clone, Copy)]
pub struct BentNode {
    block: usize,
    lane: usize,
    /// The director that the element below sees there.
    director: [f64; 3],
}

impl BentNode {
    /// All of them.
    pub fn all(body: &Body, chain: &Chain<impl Real>) -> Vec<Self> {
        let bent = body.bends.iter().map(|bend| {
            let (block, lane) = chain.layout().place(bend.index);
            let Vector(x, y, z) = bend.pose(chain).d1;
            Self { block, lane, director: [x, y, z] }
        });
        bent.collect()
    }
}

/// How nodes lie and move in the hole.
#[derive(Debug, Clone, Copy)]
pub struct Place<N> {
    tangent: Vector<N>,
    across: Vector<N>,
    square: N,
    /// Distance from the hole's axis, m.
    pub offset: N,
    /// How deep they are in the wall, m; zero where no wall acts.
    pub penetration: N,
    /// Moment of the lateral velocity about the hole's axis, m²/s, clockwise looking down the hole.
    pub circling: N,
    /// Square of the lateral speed, m²/s².
    pub speed_square: N,
}

/// Where nodes lie around the hole's axis.
#[derive(Debug, Clone, Copy)]
pub struct Direction<N> {
    /// Cosine of the direction of the offset with the high side.
    pub up: N,
    /// Cosine of the direction of the offset with the right side, looking down the hole.
    pub right: N,
}

/// What the string carries at nodes.
#[derive(Debug, Clone, Copy)]
pub struct Bearing<N> {
    /// Effective tension of the element below, N.
    pub tension: N,
    /// Torque of the element below, N·m, in the sign of the chain.
    pub torque: N,
    /// Twist of the element below, rad, in the sign of the chain.
    pub twist: N,
    /// What its tension lengthens the element below, m.
    pub longer: N,
    /// Bending moment, N·m.
    pub bending: N,
    /// Von Mises stress of the weakest body around, Pa.
    pub stress: N,
}

/// A single node, and the element below it.
#[derive(Debug, Clone, Copy, Default)]
pub struct NodeSample {
    /// Contact force, N.
    pub normal: f64,
    /// Axial friction on the wall, N, along the hole.
    pub axial: f64,
    /// Friction torque, N·m.
    pub friction_torque: f64,
    /// Distance from the hole's axis, m.
    pub offset: f64,
    /// Cosine of the direction of the offset with the high side.
    pub up: f64,
    /// Cosine of the direction of the offset with the right side, looking down the hole.
    pub right: f64,
    /// Bending moment, N·m.
    pub bending: f64,
    /// Von Mises stress of the weakest body around, Pa.
    pub stress: f64,
}

impl<R: Real> Source<'_, R> {
    /// A single node.
    pub fn node(&self, index: usize) -> NodeSample {
        let (block, lane) = self.chain.layout().place(index);
        let [normal, axial, friction_torque, offset, up, right, bending, stress] =
            self.shown::<f64>(block, lane);
        NodeSample { normal, axial, friction_torque, offset, up, right, bending, stress }
    }

    /// All nodes, from the top down, by the widest instructions that the processor has.
    pub fn nodes(&self) -> Vec<NodeSample> {
        with_fastest_instruction_set!(nodes(self))
    }

    #[inline(always)]
    fn nodes_in<N: Doubles>(&self) -> Vec<NodeSample> {
        let mut samples = vec![NodeSample::default(); self.chain.nodes()];
        for block in 0..self.chain.layout().blocks() {
            let (row, part) = Layout::row_of::<R>(block);
            let mut lanes = [[0.0; DOUBLES]; 8];
            for lane in (0..DOUBLES).step_by(N::WIDTH) {
                for (lanes, shown) in lanes.iter_mut().zip(self.shown::<N>(block, lane)) {
                    put(lanes, lane, shown);
                }
            }
            for lane in 0..DOUBLES {
                let index = self.chain.index(row, part * DOUBLES + lane);
                if let Some(sample) = samples.get_mut(index) {
                    let [normal, axial, friction_torque, offset, up, right, bending, stress] =
                        lanes.map(|numbers| numbers[lane]);
                    *sample = NodeSample {
                        normal,
                        axial,
                        friction_torque,
                        offset,
                        up,
                        right,
                        bending,
                        stress,
                    };
                }
            }
        }
        samples
    }

    /// The numbers of [`NodeSample`]s.
    #[inline(always)]
    fn shown<N: Doubles>(&self, block: usize, lane: usize) -> [N; 8] {
        let place = self.place(block, lane);
        let [axial, friction_torque] = self.friction(block, lane);
        let Direction { up, right } = self.direction(&place, block, lane);
        let Bearing { bending, stress, .. } = self.bearing(block, lane);
        let normal = self.normal(block, lane);
        [normal, axial, friction_torque, place.offset, up, right, bending, stress]
    }

    /// Contact force, N, averaged over the steps since the last sample.
    #[inline(always)]
    pub fn normal<N: Doubles>(&self, block: usize, lane: usize) -> N {
        let (row, part) = Layout::row_of::<R>(block);
        at::<N, R>(self.chain.node_blocks[row].sum_normal.part(part), lane)
            * N::splat(self.per_step / self.chain.parts_at(row))
    }

    /// Axial friction on the wall, N, along the hole, and friction torque, N·m, averaged like the
    /// contact force. Where that is zero, they are.
    #[inline(always)]
    pub fn friction<N: Doubles>(&self, block: usize, lane: usize) -> [N; 2] {
        let (row, part) = Layout::row_of::<R>(block);
        let nodes = &self.chain.node_blocks[row];
        let per_step = N::splat(self.per_step / self.chain.parts_at(row));
        [
            at::<N, R>(nodes.sum_axial.part(part), lane) * per_step,
            at::<N, R>(nodes.sum_torque.part(part), lane) * per_step,
        ]
    }

    /// How nodes lie and move in the hole.
    #[inline(always)]
    pub fn place<N: Doubles>(&self, block: usize, lane: usize) -> Place<N> {
        let (row, part) = Layout::row_of::<R>(block);
        let (nodes, state) = (&self.chain.node_blocks[row], &self.chain.states[row]);
        let u = at3::<N, R>(parts(&state.u, part), lane);
        let v = at3::<N, R>(parts(&state.v, part), lane);
        let tangent = at3(parts(&nodes.tangent, part), lane);
        let curvature = at3(parts(&nodes.curvature, part), lane);
        let z = u.dot(tangent);
        let across = u.minus(tangent, z).minus(curvature, N::splat(0.5) * z * z);
        let square = across.dot(across);
        let offset = square.sqrt();
        let lateral = v.minus(tangent, v.dot(tangent));
        let stiffness = at::<N, R>(nodes.stiffness.part(part), lane);
        let slope = at::<N, R>(nodes.clearance_slope.part(part), lane);
        let clearance = at::<N, R>(nodes.clearance.part(part), lane) + slope * z;
        Place {
            tangent,
            across,
            square,
            offset,
            penetration: stiffness.if_positive(offset - clearance, N::zero()),
            circling: tangent.dot(across.cross(lateral)),
            speed_square: lateral.dot(lateral),
        }
    }

    /// Where nodes at a place lie around the hole's axis.
    #[inline(always)]
    pub fn direction<N: Doubles>(
        &self,
        place: &Place<N>,
        block: usize,
        lane: usize,
    ) -> Direction<N> {
        let high = at3::<N, f64>(parts(&self.high[block], 0), lane);
        // The root and the division do not wait for one another.
        let inverse = N::splat(1.0) / place.square.max(N::splat(f64::MIN_POSITIVE));
        let per_offset = place.offset * inverse;
        Direction {
            up: place.across.dot(high) * per_offset,
            right: place.across.dot(place.tangent.cross(high)) * per_offset,
        }
    }

    /// What the string carries at nodes. The bending moment is the elastic one that the element
    /// below has at its upper end; the bit, below which there is none, carries none.
    #[inline(always)]
    pub fn bearing<N: Doubles>(&self, block: usize, lane: usize) -> Bearing<N> {
        let (row, part) = Layout::row_of::<R>(block);
        let (elements, state) = (&self.chain.element_blocks[row], &self.chain.states[row]);
        let ends = self.chain.ends(row);
        let metal: &Metal = self.strength.block(block);
        let [half, two] = [0.5, 2.0].map(N::splat);
        let (u1, u2) = (at3::<N, R>(parts(&state.u, part), lane), at3(parts(&ends.u, part), lane));
        let (d1, d2) = (self.director(block, lane), at3(parts(&ends.d, part), lane));
        let chord = at3(parts(&elements.chord, part), lane) + (u2 - u1);
        // Newton's step from the rest length to the inverse of the chord's: a stretch of 1e-3
        // leaves 1.5e-6, and no root is drawn.
        let rest = at::<N, f64>(&metal.per_length, lane);
        let t = chord.scaled(rest * (N::splat(1.5) - half * chord.dot(chord) * rest * rest));
        let tension = at::<N, R>(elements.tension.part(part), lane);
        let torque = at::<N, R>(elements.torque.part(part), lane);
        // The gradient of the element's energy on its upper director: `rod::element`.
        let bending_far = at::<N, R>(elements.bending_far.part(part), lane);
        let bending_near = bending_far + two * at::<N, R>(elements.bending.part(part), lane);
        let near =
            bending_near + two * at::<N, R>(elements.half_bow_near.part(part), lane) * tension;
        let far = bending_far - at::<N, R>(elements.bow_far.part(part), lane) * tension;
        let pull = near * t.dot(d1) + far * t.dot(d2);
        let moment = d2.scaled(far).minus(t, pull).cross(d1);
        let bending = moment.dot(moment).sqrt();
        // Below the bit there is no element, whatever its rows hold.
        let compliance = at::<N, f64>(&metal.compliance, lane);
        let twist = at::<N, R>(elements.twist.part(part), lane);
        Bearing {
            tension,
            torque,
            twist: compliance.if_positive(twist, N::zero()),
            longer: tension * compliance,
            bending,
            stress: metal.stress_Pa(lane, tension, bending, torque),
        }
    }

    /// The directors that the elements below see.
    #[inline(always)]
    fn director<N: Doubles>(&self, block: usize, lane: usize) -> Vector<N> {
        let (row, part) = Layout::row_of::<R>(block);
        let mut directors = at3(parts(&self.chain.states[row].d, part), lane);
        for bent in self.bent {
            if bent.block == block && (lane..lane + N::WIDTH).contains(&bent.lane) {
                directors = replaced(directors, bent.lane - lane, bent.director);
            }
        }
        directors
    }
}

macro_rules! compiled_for {
    ($set:ident, $number:ident, $fused:expr $(, $features:literal)?) => {
        mod $set {
            use super::*;

            $(#[target_feature(enable = $features)])?
            pub(super) fn nodes<R: Real>(source: &Source<'_, R>) -> Vec<NodeSample> {
                source.nodes_in::<Apart<crate::simd::dispatch::$number<f64>>>()
            }
        }
    };
}
for_each_instruction_set!(compiled_for);

/// Vectors of which one is another.
#[cold]
#[inline(always)]
fn replaced<N: Doubles>(vectors: Vector<N>, index: usize, other: [f64; 3]) -> Vector<N> {
    let Vector(x, y, z) = vectors;
    let [x, y, z] = [(x, other[0]), (y, other[1]), (z, other[2])].map(|(numbers, number)| {
        let mut lanes: Lane = [0.0; DOUBLES];
        put(&mut lanes, 0, numbers);
        lanes[index] = number;
        at(&lanes, 0)
    });
    Vector(x, y, z)
}

/// The part of rows that stands beside a block.
#[inline(always)]
fn parts<R: Real>(rows: &Rows<R>, part: usize) -> [&[R; DOUBLES]; 3] {
    rows.each_ref().map(|row| row.part(part))
}
