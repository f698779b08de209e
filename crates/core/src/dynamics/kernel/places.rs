//! Places of the nodes of a chain, which may have two regions with different time steps.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::lane_layout::LaneLayout;

/// Border between two regions of a string with different time steps: the lower one takes several in
/// one of the upper one (multirate time stepping, subcycling).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Border {
    /// The lowest node of the upper region. The element below it, the border element, is in both.
    pub node: usize,
    /// Steps of the lower region in one of the upper one.
    pub parts: u32,
}

/// Rows and lanes of the nodes, and of the elements below them.
///
/// A chain with a [`Border`] has its upper region in its first rows, then an unused row, which lets
/// the states of every region close with one more row, and then the lower region in lanes of its
/// own. Either region has a ghost, a copy of the nearest node of the other: the upper one's is its
/// last, the lower one's its first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Places {
    upper: LaneLayout,
    lower: Option<(Border, LaneLayout)>,
}

impl Places {
    /// Of so many nodes in so many lanes; `pattern` as in [`LaneLayout::new`].
    ///
    /// # Panics
    /// Where one of the regions would have no node, or the lower one no step.
    pub fn new(nodes: usize, lanes: usize, pattern: usize, border: Option<Border>) -> Self {
        let Some(border) = border else {
            return Self::whole(LaneLayout::new(nodes, lanes, pattern));
        };
        assert!(border.node + 1 < nodes && border.parts > 0, "{border:?} of {nodes} nodes");
        // Both with a ghost.
        let upper = LaneLayout::new(border.node + 2, lanes, pattern);
        let lower = LaneLayout::new(nodes - border.node, lanes, 1);
        Self { upper, lower: Some((border, lower)) }
    }

    /// Of a chain without a border.
    pub fn whole(upper: LaneLayout) -> Self {
        Self { upper, lower: None }
    }

    /// Border at which the chain is divided.
    pub fn border(&self) -> Option<Border> {
        self.lower.map(|(border, _)| border)
    }

    /// Number of rows, that of nobody's included.
    pub fn rows(&self) -> usize {
        self.upper.rows() + self.lower.map_or(0, |(_, lower)| 1 + lower.rows())
    }

    /// Number of regions.
    pub fn regions(&self) -> usize {
        if self.lower.is_some() { 2 } else { 1 }
    }

    /// The rows of a region: 0 is the upper one, or the whole.
    pub fn rows_of(&self, region: usize) -> Range<usize> {
        if region == 0 { 0..self.upper.rows() } else { self.upper.rows() + 1..self.rows() }
    }

    /// The nodes of a region, ghosts left out.
    pub fn nodes_of(&self, region: usize, nodes: usize) -> Range<usize> {
        let upper = self.border().map_or(nodes, |border| border.node + 1);
        if region == 0 { 0..upper } else { upper..nodes }
    }

    /// Row and lane of a node, and of the element below it.
    #[inline]
    pub fn place(&self, index: usize) -> (usize, usize) {
        match &self.lower {
            Some((border, lower)) if index > border.node => {
                let (row, lane) = lower.place(index - border.node);
                (self.upper.rows() + 1 + row, lane)
            }
            _ => self.upper.place(index),
        }
    }

    /// The node at a row and a lane; none of the string's for a ghost, where the last lane of a
    /// region is not full, and in the row of nobody's.
    pub fn index(&self, row: usize, lane: usize) -> usize {
        const NONE: usize = usize::MAX;
        let Some((border, lower)) = &self.lower else {
            return self.upper.index((row, lane));
        };
        let above = self.upper.rows();
        if row < above {
            let index = self.upper.index((row, lane));
            if index <= border.node { index } else { NONE }
        } else if row == above {
            NONE
        } else {
            match lower.index((row - above - 1, lane)) {
                0 => NONE,
                below => border.node + below,
            }
        }
    }

    /// Row and lane of each node in turn, from the top down, where there are so many lanes: on into
    /// the lanes that no node fills.
    pub fn in_order(self, lanes: usize) -> impl Iterator<Item = (usize, usize)> {
        let region_places = move |region: usize| {
            let rows = if region < self.regions() { self.rows_of(region) } else { 0..0 };
            (0..lanes).flat_map(move |lane| rows.clone().map(move |row| (row, lane)))
        };
        let upper = self.nodes_of(0, usize::MAX).end;
        region_places(0).take(upper).chain(region_places(1).skip(1))
    }

    /// Row and lane of the ghosts of the upper and of the lower region. The border element has its
    /// place below the latter once more.
    pub fn ghosts(&self) -> Option<[(usize, usize); 2]> {
        let (border, _) = self.lower?;
        Some([self.upper.place(border.node + 1), (self.upper.rows() + 1, 0)])
    }

    /// Steps of the region of a row in one of the uppermost region.
    pub fn parts_at(&self, row: usize) -> u32 {
        match &self.lower {
            Some((border, _)) if row > self.upper.rows() => border.parts,
            _ => 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every node has a place that gives it back, in the rows of its region, and that of no other
    /// node or ghost.
    #[test]
    fn every_node_and_every_ghost_has_a_place_of_its_own() {
        for (nodes, node) in [(3, 1), (40, 2), (40, 37), (100, 60), (467, 400)] {
            for lanes in [8, 16] {
                let border = Border { node, parts: 3 };
                let places = Places::new(nodes, lanes, 1, Some(border));
                let mut taken: Vec<_> = places.ghosts().expect("a border").into();
                assert!(taken.iter().all(|(row, lane)| places.index(*row, *lane) >= nodes));
                let in_order: Vec<_> = places.in_order(lanes).take(nodes).collect();
                for region in 0..2 {
                    for index in places.nodes_of(region, nodes) {
                        let (row, lane) = places.place(index);
                        assert_eq!(places.index(row, lane), index);
                        assert_eq!(in_order[index], (row, lane));
                        assert!(places.rows_of(region).contains(&row) && lane < lanes);
                        assert_eq!(places.parts_at(row), if region == 0 { 1 } else { 3 });
                        taken.push((row, lane));
                    }
                }
                assert_eq!(taken.len(), nodes + 2);
                taken.sort_unstable();
                taken.dedup();
                assert_eq!(taken.len(), nodes + 2);
            }
        }
    }
}
