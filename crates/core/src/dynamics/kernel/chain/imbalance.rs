//! The imbalances of single nodes.

use super::{Chain, ImbalanceBlock, Rows};
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

impl<R: Real> Chain<R> {
    pub(super) fn make_room_for_imbalances(&mut self) {
        self.imbalance_blocks = vec![ImbalanceBlock::none(); self.node_blocks.len()];
    }

    /// Gives a node an imbalance.
    pub fn set_imbalance(&mut self, index: usize, imbalance: &NodeImbalance) {
        if self.imbalance_blocks.is_empty() {
            self.make_room_for_imbalances();
        }
        let (row, lane) = self.place(index);
        let block = &mut self.imbalance_blocks[row];
        block.moment.0[lane] = R::from_f64(imbalance.moment_kg_m);
        block.weight_moment.0[lane] = R::from_f64(imbalance.weight_moment_N_m);
        let mut set = |rows: fn(&mut ImbalanceBlock<R>) -> &mut Rows<R>, v: Vector<f64>| {
            for (row, v) in rows(block).iter_mut().zip([v.0, v.1, v.2]) {
                row.0[lane] = R::from_f64(v);
            }
        };
        set(|block| &mut block.toward, imbalance.toward);
        set(|block| &mut block.half, imbalance.half);
        set(|block| &mut block.rest, Vector::zero());
    }

    /// The imbalance of a node, if it has one.
    pub fn imbalance(&self, index: usize) -> Option<NodeImbalance> {
        let (row, lane) = self.place(index);
        let block = self.imbalance_blocks.get(row)?;
        let moment_kg_m = block.moment.0[lane].to_f64();
        let of = |[x, y, z]: &Rows<R>| {
            Vector(x.0[lane].to_f64(), y.0[lane].to_f64(), z.0[lane].to_f64())
        };
        (moment_kg_m > 0.0).then(|| NodeImbalance {
            moment_kg_m,
            weight_moment_N_m: block.weight_moment.0[lane].to_f64(),
            toward: of(&block.toward) + of(&block.rest),
            half: of(&block.half),
        })
    }

    /// Those of all nodes that have one, from the top down.
    pub fn imbalances(&self) -> impl Iterator<Item = (usize, NodeImbalance)> {
        let nodes = if self.imbalance_blocks.is_empty() { 0 } else { self.nodes() };
        (0..nodes).filter_map(|index| Some((index, self.imbalance(index)?)))
    }
}
