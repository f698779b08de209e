//! Memory layout of a node's numbers.

use serde::{Deserialize, Serialize};

use super::places::Places;
use crate::simd::{lanes::DOUBLES, number::Real};

/// Layout of the node data that are kept in double precision, whatever the precision of the chain
/// itself: each row of the chain has, part by part, its blocks of doubles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Layout {
    places: Places,
    parts: usize,
}

impl Layout {
    /// Layout next to a chain in numbers of kind `R` whose nodes have such places.
    pub fn beside<R: Real>(places: Places) -> Self {
        Self { places, parts: R::LANES / DOUBLES }
    }

    /// Row of the chain that a block belongs to, and its part of that row.
    #[inline(always)]
    pub fn row_of<R: Real>(block: usize) -> (usize, usize) {
        let parts = R::LANES / DOUBLES;
        (block / parts, block % parts)
    }

    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.places.rows() * self.parts
    }

    /// Block and lane of each node in turn, from the top down.
    pub fn places(self) -> impl Iterator<Item = (usize, usize)> {
        let block =
            move |(row, lane): (usize, usize)| (row * self.parts + lane / DOUBLES, lane % DOUBLES);
        self.places.in_order(self.parts * DOUBLES).map(block)
    }

    /// The element that two regions share, and its block and lane in the lower one.
    pub fn shared(&self) -> Option<(usize, (usize, usize))> {
        let (border, [_, (row, lane)]) = self.places.border().zip(self.places.ghosts())?;
        Some((border.node, (row * self.parts + lane / DOUBLES, lane % DOUBLES)))
    }

    /// Block and lane of a node, and of the element below it.
    #[inline]
    pub fn place(&self, index: usize) -> (usize, usize) {
        let (row, lane) = self.places.place(index);
        (row * self.parts + lane / DOUBLES, lane % DOUBLES)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::kernel::chain::Chain;

    /// A block's lanes are those of its part of the chain's row, and no node is without.
    fn assert_blocks_stand_beside_rows<R: Real>() {
        for nodes in [1, 15, 16, 17, 31, 32, 33, 100] {
            let chain = Chain::new(nodes).converted::<R>();
            let layout = chain.layout();
            for index in 0..nodes {
                let (block, lane) = layout.place(index);
                assert!(block < layout.blocks());
                let (row, part) = Layout::row_of::<R>(block);
                assert_eq!(chain.place(index), (row, part * DOUBLES + lane));
                assert_eq!(layout.places().nth(index), Some((block, lane)));
            }
        }
    }

    #[test]
    fn blocks_stand_beside_the_rows_of_either_kind_of_number() {
        assert_blocks_stand_beside_rows::<f64>();
        assert_blocks_stand_beside_rows::<f32>();
    }
}
