//! What eight nodes, and the elements below them, show at a moment: the one place that reads the chain
//! for the record.

use super::strength::{Metal, Strength};
use crate::{
    dynamics::{
        body::Body,
        chain::{Chain, ElementBlock, Rows, StateBlock},
    },
    rod::{lanes::LANES, vector::Vector},
};

/// One number for each lane.
pub type Lane = [f64; LANES];

const NONE: Lane = [0.0; LANES];

/// A row of nodes as they are; contact quantities are averages over the steps since the last sample.
#[derive(Debug, Clone, Copy)]
pub struct Look {
    /// Effective tension of the element below, N.
    pub tension: Lane,
    /// Torque of the element below, N·m, in the sign of the chain.
    pub torque: Lane,
    /// Bending moment, N·m.
    pub bending: Lane,
    /// Von Mises stress of the weakest body around, Pa.
    pub stress: Lane,
    /// Contact force, N.
    pub normal: Lane,
    /// Axial friction on the wall, N, along the hole.
    pub axial: Lane,
    /// Friction torque, N·m.
    pub rub: Lane,
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

/// A row of elements: how their ends stand, what is in them, and the bodies at their upper ends.
struct Stretch<'a> {
    upper: &'a StateBlock<f64>,
    lower: &'a StateBlock<f64>,
    elements: &'a ElementBlock<f64>,
    metal: &'a Metal,
}

impl Look {
    const EMPTY: Self = Self {
        tension: NONE,
        torque: NONE,
        bending: NONE,
        stress: NONE,
        normal: NONE,
        axial: NONE,
        rub: NONE,
        offset: NONE,
        up: NONE,
        right: NONE,
        penetration: NONE,
        circling: NONE,
        speed_square: NONE,
    };

    /// Looks at a row. `high` holds the high sides, row by row, `per_step` the inverse of the number of
    /// steps since the last sample.
    #[inline(always)]
    pub fn at(
        chain: &Chain,
        high: &[Rows<f64>],
        body: &Body,
        strength: &Strength,
        row: usize,
        per_step: f64,
    ) -> Self {
        let mut look = Self::EMPTY;
        look.across_the_hole(chain, high, row, per_step);
        let stretch = Stretch {
            upper: &chain.states[row],
            lower: &chain.ends(row),
            elements: &chain.element_blocks[row],
            metal: strength.block(row),
        };
        for lane in 0..LANES {
            look.bear(&stretch, lane, of(&stretch.upper.d, lane));
        }
        // The element below a bend stands on another face of the body: what is bent without stress bears none.
        for bend in &body.bends {
            let (row_of_bend, lane) = chain.place(bend.index);
            if row_of_bend == row {
                look.bear(&stretch, lane, bend.pose(chain).d1);
            }
        }
        look
    }

    /// How the nodes lie and move in the hole, and what the wall does to them.
    #[inline(always)]
    fn across_the_hole(&mut self, chain: &Chain, high: &[Rows<f64>], row: usize, per_step: f64) {
        let nodes = &chain.node_blocks[row];
        let state = &chain.states[row];
        for lane in 0..LANES {
            let (u, v) = (of(&state.u, lane), of(&state.v, lane));
            let h = of(&high[row], lane);
            let tangent = of(&nodes.tangent, lane);
            let curvature = of(&nodes.curvature, lane);
            let z = u.dot(tangent);
            let across = u.minus(tangent, z).minus(curvature, 0.5 * z * z);
            let offset = across.dot(across).sqrt();
            let lateral = v.minus(tangent, v.dot(tangent));
            let touchable = nodes.stiffness.0[lane] > 0.0;
            let clearance = nodes.clearance.0[lane] + nodes.clearance_slope.0[lane] * z;
            let penetration = offset - clearance;
            let per_offset = 1.0 / offset.max(f64::MIN_POSITIVE);
            self.offset[lane] = offset;
            self.penetration[lane] = if touchable { penetration } else { 0.0 };
            self.up[lane] = across.dot(h) * per_offset;
            self.right[lane] = across.dot(tangent.cross(h)) * per_offset;
            self.circling[lane] = tangent.dot(across.cross(lateral));
            self.speed_square[lane] = lateral.dot(lateral);
            self.normal[lane] = nodes.sum_normal.0[lane] * per_step;
            self.axial[lane] = nodes.sum_axial.0[lane] * per_step;
            self.rub[lane] = nodes.sum_torque.0[lane] * per_step;
        }
    }

    /// What the string carries at a node whose element below sees the director `d1` there. The bending moment is
    /// the elastic one that this element has at its upper end; the bit, below which there is none, carries none.
    #[inline(always)]
    fn bear(&mut self, stretch: &Stretch<'_>, lane: usize, d1: Vector<f64>) {
        let Stretch {
            upper,
            lower,
            elements,
            metal,
        } = stretch;
        let (u1, u2) = (of(&upper.u, lane), of(&lower.u, lane));
        let d2 = of(&lower.d, lane);
        let chord = of(&elements.chord, lane) + (u2 - u1);
        // Newton's step from the rest length to the inverse of the chord's: a stretch of 1e-3 leaves
        // 1.5e-6, and no root is drawn.
        let rest = elements.inverse_length.0[lane];
        let t = chord.scaled(rest * (1.5 - 0.5 * chord.dot(chord) * rest * rest));
        let tension = elements.tension.0[lane];
        let torque = elements.torque.0[lane];
        // The gradient of the element's energy on its upper director: `rod::element`.
        let near = elements.bending_near.0[lane] + elements.bow_near.0[lane] * tension;
        let far = elements.bending_far.0[lane] - elements.bow_far.0[lane] * tension;
        let pull = near * t.dot(d1) + far * t.dot(d2);
        let moment = d2.scaled(far).minus(t, pull).cross(d1);
        let bending = moment.dot(moment).sqrt();
        self.tension[lane] = tension;
        self.torque[lane] = torque;
        self.bending[lane] = bending;
        self.stress[lane] = metal.stress_Pa(lane, tension, bending, torque);
    }
}

#[inline(always)]
fn of(rows: &Rows<f64>, lane: usize) -> Vector<f64> {
    Vector(rows[0].0[lane], rows[1].0[lane], rows[2].0[lane])
}
