//! The imbalance of a single node.

use super::{blocks::ImbalanceBlock, rows::Rows};
use crate::simd::{number::Real, vector::Vector};

/// An eccentric mass at a node.
#[derive(Debug, Clone, Copy)]
pub struct NodeImbalance {
    /// `U`, kg·m.
    pub moment_kg_m: f64,
    /// `U g`, N·m.
    pub weight_moment_N_m: f64,
    /// Its direction at the present position.
    pub toward: Vector<f64>,
    /// Its direction half a step before: where the velocities are.
    pub half: Vector<f64>,
}

impl<R: Real> ImbalanceBlock<R> {
    /// Gives the node of a lane an imbalance.
    pub(super) fn set(&mut self, lane: usize, imbalance: &NodeImbalance) {
        let set = |rows: &mut Rows<R>, v: Vector<f64>| {
            for (row, v) in rows.iter_mut().zip([v.0, v.1, v.2]) {
                row.0[lane] = R::from_f64(v);
            }
        };
        self.moment.0[lane] = R::from_f64(imbalance.moment_kg_m);
        self.weight_moment.0[lane] = R::from_f64(imbalance.weight_moment_N_m);
        set(&mut self.toward, imbalance.toward);
        set(&mut self.half, imbalance.half);
        set(&mut self.rest, Vector::zero());
    }

    /// The imbalance of the node of a lane, if it has one.
    pub(super) fn get(&self, lane: usize) -> Option<NodeImbalance> {
        let vector = |[x, y, z]: &Rows<R>| {
            Vector(x.0[lane].to_f64(), y.0[lane].to_f64(), z.0[lane].to_f64())
        };
        let moment_kg_m = self.moment.0[lane].to_f64();
        (moment_kg_m > 0.0).then(|| NodeImbalance {
            moment_kg_m,
            weight_moment_N_m: self.weight_moment.0[lane].to_f64(),
            toward: vector(&self.toward) + vector(&self.rest),
            half: vector(&self.half),
        })
    }
}
