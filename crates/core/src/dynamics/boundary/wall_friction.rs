//! The nodes' coefficients of friction by a law of the caller's own.

use serde::{Deserialize, Serialize};

use super::{
    anchor::Anchor,
    extension::{AnotherExtension, Extension},
    friction_coefficient::{CustomFriction, FrictionCoefficient, SlidingContact},
    hole::Borehole,
};
use crate::{
    damage::{Damaged, ensure},
    dynamics::kernel::{
        chain::{Chain, NodeBlock, Rows, StateBlock},
        layout::Layout,
    },
    rod::mesh::Mesh,
    simd::{lanes::DOUBLES, number::Real, vector::Vector},
};

/// The law in a run.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct WallFriction {
    /// Its state: that of every node, from the top down.
    law: Extension<dyn FrictionCoefficient>,
    /// Sum of the contact forces of the sample before the last step, N, row by row of the chain.
    summed_N: Vec<f64>,
    /// The first coefficient that no wall has, and its node.
    fault: Option<(usize, f64)>,
}

/// Positions of the nodes of a chain.
#[derive(Debug, Clone, Copy)]
pub struct Placement<'a> {
    /// The hole.
    pub borehole: &'a Borehole,
    /// Anchors of the nodes in the hole.
    pub anchors: &'a [Anchor],
    /// Positions of the nodes on the string.
    pub mesh: &'a Mesh,
}

impl WallFriction {
    /// The law for the nodes of a chain that has summed up nothing yet.
    pub fn new(custom: &CustomFriction, chain: &Chain<impl Real>) -> Self {
        let law = &custom.law;
        Self {
            law: Extension::new(law, law.name(), law.initial_state().repeat(chain.nodes())),
            summed_N: vec![0.0; places(chain.layout())],
            fault: None,
        }
    }

    /// Gives a law that has been read back its own.
    pub(in crate::dynamics) fn attach(
        &mut self,
        custom: &CustomFriction,
        nodes: usize,
    ) -> Result<(), AnotherExtension> {
        let law = &custom.law;
        let numbers = law.initial_state().len() * nodes;
        self.law.attach("the coefficient of friction", law, law.name(), numbers)
    }

    /// Whether a stored law is one for a chain of this layout.
    pub(in crate::dynamics) fn check(&self, nodes: usize, layout: Layout) -> Result<(), Damaged> {
        let fits = self.law.is_attached()
            && self.summed_N.len() == places(layout)
            && self.fault.is_none_or(|(node, _)| node < nodes);
        ensure(fits, "the coefficient of friction")
    }

    /// The first coefficient that no wall has, and its node.
    pub fn fault(&self) -> Option<(usize, f64)> {
        self.fault
    }

    /// To be called before the sums of the chain are cleared.
    pub fn sums_are_cleared<R: Real>(&mut self, chain: &Chain<R>) {
        for (summed, n) in self.summed_N.chunks_exact_mut(R::LANES).zip(&chain.node_blocks) {
            for (summed, sum) in summed.iter_mut().zip(n.sum_normal.0.as_ref()) {
                *summed -= sum.to_f64();
            }
        }
    }

    /// Gives the nodes on the wall their coefficients for a step `dt_s` of their region.
    pub fn set_coefficients<R: Real>(
        &mut self,
        chain: &mut Chain<R>,
        region: usize,
        around: Placement<'_>,
        dt_s: f64,
    ) {
        let Some((law, state)) = self.law.get_mut() else {
            return;
        };
        let numbers = state.len() / chain.nodes();
        let rows = chain.rows_of(region);
        let summed_N = self.summed_N.chunks_exact_mut(R::LANES).enumerate();
        for (row, summed) in summed_N.take(rows.end).skip(rows.start) {
            for (lane, summed) in summed.iter_mut().enumerate() {
                let sum = chain.node_blocks[row].sum_normal.0[lane].to_f64();
                let normal_force_N = sum - *summed;
                *summed = sum;
                let sliding = Sliding::of(&chain.node_blocks[row], &chain.states[row], lane, dt_s);
                let Some(sliding) = sliding else {
                    continue;
                };
                let index = chain.index(row, lane);
                let anchor = &around.anchors[index];
                let contact = SlidingContact {
                    dt_s,
                    md_m: anchor.md_m + sliding.from_anchor_m,
                    from_bit_m: around.mesh.nodes[index].from_bit_m,
                    normal_force_N,
                    axial_velocity_m_per_s: sliding.axial_m_per_s,
                    circumferential_velocity_m_per_s: sliding.circumferential_m_per_s,
                    // As `Borehole::place` has it.
                    friction: around.borehole.friction(anchor.md_m),
                };
                let state = &mut state[index * numbers..][..numbers];
                let coefficient = law.coefficient(state, &contact);
                if coefficient >= 0.0 && coefficient.is_finite() {
                    let n = &mut chain.node_blocks[row];
                    n.friction.0[lane] = R::from_f64(coefficient);
                    n.friction_rise.0[lane] = R::from_f64(0.0);
                } else if self.fault.is_none() {
                    self.fault = Some((index, coefficient));
                }
            }
        }
    }
}

/// Numbers in the rows of a chain, of the lanes that no node fills, too.
fn places(layout: Layout) -> usize {
    layout.blocks() * DOUBLES
}

/// Sliding of a node on the wall.
struct Sliding {
    /// Distance of the node along the hole from its anchor, m.
    from_anchor_m: f64,
    axial_m_per_s: f64,
    circumferential_m_per_s: f64,
}

impl Sliding {
    /// None for a node that stays off the wall in the coming step at unchanged velocity. A node
    /// that is pressed on the wall is slightly inside it.
    fn of<R: Real>(
        n: &NodeBlock<R>,
        state: &StateBlock<R>,
        lane: usize,
        dt_s: f64,
    ) -> Option<Self> {
        let at = |rows: &Rows<R>| {
            let [x, y, z] = rows;
            Vector(x.0[lane].to_f64(), y.0[lane].to_f64(), z.0[lane].to_f64())
        };
        let (tangent, v, u0) = (at(&n.tangent), at(&state.v), at(&state.u));
        let u = u0.plus(v, dt_s);
        let along = tangent.dot(u);
        // From the curved axis, as in the step itself.
        let offset = u.minus(tangent, along).minus(at(&n.curvature), 0.5 * along * along);
        let slope = n.clearance_slope.0[lane].to_f64();
        let clearance = n.clearance.0[lane].to_f64() + slope * along;
        let distance2 = offset.dot(offset);
        if distance2.is_nan() || distance2 <= clearance * clearance {
            return None;
        }
        let around = tangent.cross(offset.scaled(1.0 / distance2.sqrt()));
        let spin = n.radius.0[lane].to_f64() * state.spin.0[lane].to_f64();
        Some(Self {
            from_anchor_m: tangent.dot(u0),
            axial_m_per_s: tangent.dot(v),
            circumferential_m_per_s: spin + v.dot(around),
        })
    }
}
