//! Values at nodes, and in the elements below them, at a moment: the only place that reads the
//! chain for the record.

use super::{
    deflection::{Ends, parts},
    lane::{Above, at, at3, put},
    shapes::Shapes,
    strength::{Metal, Strength},
};
use crate::{
    dynamics::kernel::{chain::Rows, layout::Layout},
    simd::{
        dispatch::{for_each_instruction_set, with_fastest_instruction_set},
        lanes::DOUBLES,
        number::{Doubles, Real},
        vector::Vector,
    },
};

/// Sources of the samples.
#[derive(Debug)]
pub struct Source<'a, R: Real> {
    /// The ends of the elements.
    pub ends: Ends<'a, R>,
    /// High side of each node, block by block.
    pub high: &'a [Rows<f64>],
    /// The bodies that carry the stresses.
    pub strength: &'a Strength,
    /// Bending of the elements between their ends.
    pub shapes: &'a Shapes,
    /// Inverse of the number of steps of the uppermost region since the last sample.
    pub per_step: f64,
}

/// Position and motion of nodes in the hole.
#[derive(Debug, Clone, Copy)]
pub struct Place<N> {
    tangent: Vector<N>,
    across: Vector<N>,
    square: N,
    /// Distance from the hole's axis, m.
    pub offset: N,
    /// Penetration of the nodes into the wall, m; zero where no wall acts.
    pub penetration: N,
    /// Moment of the lateral velocity about the hole's axis, m²/s, clockwise looking down the hole.
    pub circling: N,
    /// Square of the lateral speed, m²/s².
    pub speed_square: N,
}

/// Direction of nodes from the hole's axis.
#[derive(Debug, Clone, Copy)]
pub struct Direction<N> {
    /// Cosine of the direction of the offset with the high side.
    pub up: N,
    /// Cosine of the direction of the offset with the right side, looking down the hole.
    pub right: N,
}

/// Loads of the string at nodes.
#[derive(Debug, Clone, Copy)]
pub struct Bearing<N> {
    /// Effective tension of the element below, N.
    pub tension: N,
    /// Torque of the element below, N·m, in the sign of the chain.
    pub torque: N,
    /// Twist of the element below, rad, in the sign of the chain.
    pub twist: N,
    /// Elongation of the element below by its tension, m.
    pub longer: N,
    /// Bending moment, N·m.
    pub bending: N,
    /// Bending moment half-way to the node below, N·m.
    pub between: N,
    /// Von Mises stress of the weakest body around by the larger of the two, Pa.
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

/// Numbers of a [`NodeSample`].
const SHOWN: usize = 8;

impl NodeSample {
    fn of(values: [f64; SHOWN]) -> Self {
        let [normal, axial, friction_torque, offset, up, right, bending, stress] = values;
        Self { normal, axial, friction_torque, offset, up, right, bending, stress }
    }
}

impl<R: Real> Source<'_, R> {
    /// A single node.
    pub fn node(&self, index: usize) -> NodeSample {
        let chain = self.ends.chain;
        let (row, lane) = chain.place(index);
        let block =
            |row: usize, lane: usize| (row * (R::LANES / DOUBLES) + lane / DOUBLES, lane % DOUBLES);
        let region = (0..chain.regions()).map(|region| chain.rows_of(region));
        let above = region.filter(|rows| rows.contains(&row)).find_map(|rows| {
            let above = if row > rows.start {
                (row - 1, lane)
            } else {
                (rows.end - 1, lane.checked_sub(1)?)
            };
            Some(block(above.0, above.1))
        });
        let above = above.map_or([0.0; 3], |(block, lane)| self.lower::<f64>(block, lane));
        let (block, lane) = block(row, lane);
        NodeSample::of(self.shown::<f64>(block, lane, above).0)
    }

    /// All nodes, from the top down, by the widest instructions that the processor has.
    pub fn nodes(&self) -> Vec<NodeSample> {
        with_fastest_instruction_set!(nodes(self))
    }

    #[inline(always)]
    fn nodes_in<N: Doubles>(&self) -> Vec<NodeSample> {
        let chain = self.ends.chain;
        let mut samples = vec![NodeSample::default(); chain.nodes()];
        let parts = R::LANES / DOUBLES;
        for region in 0..chain.regions() {
            let mut above = self.above::<N>(region);
            for (row, part) in
                chain.rows_of(region).flat_map(|row| (0..parts).map(move |part| (row, part)))
            {
                let mut lanes = [[0.0; DOUBLES]; SHOWN];
                for lane in (0..DOUBLES).step_by(N::WIDTH) {
                    let (values, lower) =
                        self.shown::<N>(row * parts + part, lane, above.at(part, lane));
                    above.put(part, lane, lower);
                    for (lanes, value) in lanes.iter_mut().zip(values) {
                        put(lanes, lane, value);
                    }
                }
                for lane in 0..DOUBLES {
                    let index = chain.index(row, part * DOUBLES + lane);
                    if let Some(sample) = samples.get_mut(index) {
                        *sample = NodeSample::of(lanes.map(|numbers| numbers[lane]));
                    }
                }
            }
        }
        samples
    }

    /// The numbers of [`NodeSample`]s, and the moments of the elements below at their lower ends.
    #[inline(always)]
    fn shown<N: Doubles>(&self, block: usize, lane: usize, above: [N; 3]) -> ([N; SHOWN], [N; 3]) {
        let place = self.place(block, lane);
        let [axial, friction_torque] = self.friction(block, lane);
        let Direction { up, right } = self.direction(&place, block, lane);
        let (Bearing { bending, stress, .. }, lower) = self.bearing(block, lane, above);
        let normal = self.normal(block, lane);
        ([normal, axial, friction_torque, place.offset, up, right, bending, stress], lower)
    }

    /// Contact force, N, averaged over the steps since the last sample.
    #[inline(always)]
    pub fn normal<N: Doubles>(&self, block: usize, lane: usize) -> N {
        let (row, part) = Layout::row_of::<R>(block);
        at::<N, R>(self.ends.chain.node_blocks[row].sum_normal.part(part), lane)
            * N::splat(self.per_step / self.ends.chain.parts_at(row))
    }

    /// Axial friction on the wall, N, along the hole, and friction torque, N·m, averaged like the
    /// contact force. Where that is zero, they are.
    #[inline(always)]
    pub fn friction<N: Doubles>(&self, block: usize, lane: usize) -> [N; 2] {
        let (row, part) = Layout::row_of::<R>(block);
        let nodes = &self.ends.chain.node_blocks[row];
        let per_step = N::splat(self.per_step / self.ends.chain.parts_at(row));
        [
            at::<N, R>(nodes.sum_axial.part(part), lane) * per_step,
            at::<N, R>(nodes.sum_torque.part(part), lane) * per_step,
        ]
    }

    /// Position and motion of nodes in the hole.
    #[inline(always)]
    pub fn place<N: Doubles>(&self, block: usize, lane: usize) -> Place<N> {
        let (row, part) = Layout::row_of::<R>(block);
        let (nodes, state) = (&self.ends.chain.node_blocks[row], &self.ends.chain.states[row]);
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

    /// Direction from the hole's axis of nodes at a place.
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

    /// Loads of the string at nodes, and the moment of the elements below at their lower ends;
    /// `above` is that of the elements above. The bit, with no element below, has no moment unless
    /// it is clamped.
    #[inline(always)]
    pub fn bearing<N: Doubles>(
        &self,
        block: usize,
        lane: usize,
        [x, y, z]: [N; 3],
    ) -> (Bearing<N>, [N; 3]) {
        let (row, part) = Layout::row_of::<R>(block);
        let elements = &self.ends.chain.element_blocks[row];
        let metal: &Metal = self.strength.block(block);
        let shape = self.shapes.block(block);
        let moments = self.shapes.moments::<N, R>(&self.ends, block, lane);
        // The node balances the difference between the two sides by turning: each side receives a
        // part in proportion to its rotational stiffness.
        let above = Vector(x, y, z);
        let moment = above + (moments.upper - above).scaled(at(&shape.below, lane));
        let bending = moment.dot(moment).sqrt();
        let between = moments.half_way.dot(moments.half_way).sqrt();
        let tension = at::<N, R>(elements.tension.part(part), lane);
        let torque = at::<N, R>(elements.torque.part(part), lane);
        // Below the bit there is no element, whatever its rows hold.
        let compliance = at::<N, f64>(&metal.compliance, lane);
        let twist = at::<N, R>(elements.twist.part(part), lane);
        let bearing = Bearing {
            tension,
            torque,
            twist: compliance.if_positive(twist, N::zero()),
            longer: tension * compliance,
            bending,
            between,
            stress: metal.stress_Pa(lane, tension, bending.max(between), torque),
        };
        let Vector(x, y, z) = moments.lower;
        (bearing, [x, y, z])
    }

    /// The moments that a region's elements of the last row hand down to the nodes of the first.
    #[inline(always)]
    pub fn above<N: Doubles>(&self, region: usize) -> Above<3> {
        let parts = R::LANES / DOUBLES;
        let mut above = Above::NONE;
        let Some(row) = self.ends.chain.rows_of(region).last() else {
            return above;
        };
        for part in 0..parts {
            for lane in (0..DOUBLES).step_by(N::WIDTH) {
                above.put(part, lane, self.lower::<N>(row * parts + part, lane));
            }
        }
        above.close(parts);
        above
    }

    /// The moments of elements at their lower ends.
    #[inline(always)]
    fn lower<N: Doubles>(&self, block: usize, lane: usize) -> [N; 3] {
        let moments = self.shapes.moments::<N, R>(&self.ends, block, lane);
        let Vector(x, y, z) = moments.lower;
        [x, y, z]
    }
}

macro_rules! compiled_for {
    ($set:ident, $number:ident $(, $features:literal)?) => {
        mod $set {
            use super::*;

            $(#[target_feature(enable = $features)])?
            pub(super) fn nodes<R: Real>(source: &Source<'_, R>) -> Vec<NodeSample> {
                source.nodes_in::<crate::simd::dispatch::$number<f64>>()
            }
        }
    };
}
for_each_instruction_set!(compiled_for);
