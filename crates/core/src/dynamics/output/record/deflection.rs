//! Bending and position of elements, read from the chain.

use super::lane::{Lane, at, at3, put};
use crate::{
    dynamics::{
        body::Body,
        kernel::{
            chain::{Chain, Rows},
            layout::Layout,
        },
    },
    simd::{
        lanes::DOUBLES,
        number::{Doubles, Real},
        vector::Vector,
    },
};

/// The ends of the elements.
#[derive(Debug, Clone, Copy)]
pub struct Ends<'a, R: Real> {
    /// The chain, closed.
    pub chain: &'a Chain<R>,
    /// Nodes with bends.
    pub bent: &'a [BentNode],
}

/// A node with a bend. The element below is attached to another face of the body: a body that is
/// bent without stress has none.
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

/// Bending of an element by its ends, and its load across its chord.
#[derive(Debug, Clone, Copy)]
pub struct Deflection<N> {
    /// Sum of the angles of its ends with the chord.
    pub odd: Vector<N>,
    /// The angle of the lower end less that of the upper one.
    pub even: Vector<N>,
    /// Effective tension over the length, N/m.
    pub pull: N,
    /// `EI/L`, N·m.
    pub bending: N,
    /// Buoyed weight across the chord, N/m.
    pub weight: Vector<N>,
}

impl<N: Doubles> Deflection<N> {
    /// `EI β` and so much of the load `T β + q`, m².
    #[inline(always)]
    pub fn by(&self, part: N) -> Vector<N> {
        self.even.scaled(self.bending + part * self.pull) + self.weight.scaled(part)
    }

    /// The load `T β + q`, N/m.
    #[inline(always)]
    pub fn load(&self) -> Vector<N> {
        self.even.scaled(self.pull) + self.weight
    }
}

/// Position of the middle of an element in its hole.
#[derive(Debug, Clone, Copy)]
pub struct Around<N> {
    /// From the hole's axis to the middle of the chord, m.
    pub offset: Vector<N>,
    /// Radius of the hole, m; of an element below a node that no wall is near, far more.
    pub radius: N,
}

impl<R: Real> Ends<'_, R> {
    /// Bending of elements, from the inverse of their rest length, 1/m, and buoyed weight, N/m.
    #[inline(always)]
    pub fn deflection<N: Doubles>(
        &self,
        block: usize,
        lane: usize,
        [rest, weight]: [N; 2],
    ) -> Deflection<N> {
        let (row, part) = Layout::row_of::<R>(block);
        let (elements, state) = (&self.chain.element_blocks[row], &self.chain.states[row]);
        let ends = self.chain.ends(row);
        let (u1, u2) = (at3::<N, R>(parts(&state.u, part), lane), at3(parts(&ends.u, part), lane));
        let (d1, d2) = (self.director(block, lane), at3(parts(&ends.d, part), lane));
        let chord = at3(parts(&elements.chord, part), lane) + (u2 - u1);
        // Newton's step from the rest length to the inverse of the chord's: a stretch of 1e-3
        // leaves 1.5e-6, and no root is drawn.
        let [half, three_halves] = [0.5, 1.5].map(N::splat);
        let t = chord.scaled(rest * (three_halves - half * chord.dot(chord) * rest * rest));
        let (sum, apart) = (d1 + d2, d2 - d1);
        let Vector(x, y, z) = t;
        let along = weight * z;
        Deflection {
            odd: sum.minus(t, t.dot(sum)),
            even: apart.minus(t, t.dot(apart)),
            pull: at::<N, R>(elements.tension.part(part), lane) * rest,
            bending: at::<N, R>(elements.bending.part(part), lane),
            weight: Vector(-(x * along), -(y * along), weight - z * along),
        }
    }

    /// Positions of the middles of the elements' chords. Between its anchors the hole is the
    /// parabola that has its tangent at the upper one. `rest` is the inverse of their rest lengths,
    /// 1/m.
    #[inline(always)]
    pub fn around<N: Doubles>(&self, block: usize, lane: usize, rest: N) -> Around<N> {
        let (row, part) = Layout::row_of::<R>(block);
        let (nodes, state) = (&self.chain.node_blocks[row], &self.chain.states[row]);
        let (u1, u2) = (
            at3::<N, R>(parts(&state.u, part), lane),
            at3(parts(&self.chain.ends(row).u, part), lane),
        );
        let chord: Vector<N> = at3(parts(&self.chain.element_blocks[row].chord, part), lane);
        let tangent = at3(parts(&nodes.tangent, part), lane);
        let curvature = at3(parts(&nodes.curvature, part), lane);
        let [half, quarter] = [0.5, 0.25].map(N::splat);
        let moved = (u1 + u2).scaled(half);
        let along = chord.scaled(rest);
        let z = moved.dot(along);
        // The deviation of the hole from its chord half-way is a quarter of its deviation from the
        // tangent.
        let bowed = chord.minus(tangent, chord.dot(tangent)).scaled(quarter);
        let offset = moved.minus(along, z).minus(curvature, half * z * z) + bowed;
        let slope = at::<N, R>(nodes.clearance_slope.part(part), lane);
        let clearance = at::<N, R>(nodes.clearance.part(part), lane) + slope * z;
        Around { offset, radius: clearance + at::<N, R>(nodes.radius.part(part), lane) }
    }

    /// Positive for nodes that are free to tilt.
    #[inline(always)]
    pub fn tilts<N: Doubles>(&self, block: usize, lane: usize) -> N {
        let (row, part) = Layout::row_of::<R>(block);
        at::<N, R>(self.chain.node_blocks[row].inv_rotary.part(part), lane)
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

/// The part of rows next to a block.
#[inline(always)]
pub fn parts<R: Real>(rows: &Rows<R>, part: usize) -> [&[R; DOUBLES]; 3] {
    rows.each_ref().map(|row| row.part(part))
}
