//! The regions of a chain that is divided, and the ghosts by which they are coupled.

use super::{Chain, ElementBlock, ImbalanceBlock, NodeBlock, StateBlock, rows::CopyLane};
use crate::{dynamics::kernel::places::Border, simd::number::Real};

/// The rows of a region.
pub struct RegionRows<'a, R: Real> {
    /// States of its nodes: one row more than the others, which [closes](Self::close) them.
    pub states: &'a mut [StateBlock<R>],
    /// Its nodes.
    pub node_blocks: &'a mut [NodeBlock<R>],
    /// Its elements.
    pub element_blocks: &'a mut [ElementBlock<R>],
    /// Imbalances of its nodes; none where none of the chain is eccentric.
    pub imbalance_blocks: &'a mut [ImbalanceBlock<R>],
}

impl<R: Real> RegionRows<'_, R> {
    /// Repeats the first row of states below the last, one lane lower. The last lane ends in
    /// itself.
    #[inline(always)]
    pub fn close(&mut self) {
        let rows = self.node_blocks.len();
        let (above, close) = self.states.split_at_mut(rows);
        close[0].lead_in_lanes(&above[0], &above[rows - 1]);
    }
}

impl<R: Real> Chain<R> {
    /// Border at which the chain is divided.
    pub fn border(&self) -> Option<Border> {
        self.places.border()
    }

    /// Number of regions.
    pub fn regions(&self) -> usize {
        self.places.regions()
    }

    /// The rows of a region: 0 is the upper one, or the whole.
    pub fn region(&mut self, region: usize) -> RegionRows<'_, R> {
        let rows = self.places.rows_of(region);
        let eccentric = if self.imbalance_blocks.is_empty() { 0..0 } else { rows.clone() };
        RegionRows {
            states: &mut self.states[rows.start..=rows.end],
            node_blocks: &mut self.node_blocks[rows.clone()],
            element_blocks: &mut self.element_blocks[rows],
            imbalance_blocks: &mut self.imbalance_blocks[eccentric],
        }
    }

    /// The rows of a region by their numbers.
    pub fn rows_of(&self, region: usize) -> std::ops::Range<usize> {
        self.places.rows_of(region)
    }

    /// The nodes of a region.
    pub fn nodes_of(&self, region: usize) -> std::ops::Range<usize> {
        self.places.nodes_of(region, self.nodes)
    }

    /// Places of a region's nodes among all of its places, lane by lane: the lower region begins
    /// with its ghost.
    pub(super) fn places_in_region(&self, region: usize) -> std::ops::Range<usize> {
        let nodes = self.nodes_of(region).len();
        if region == 0 { 0..nodes } else { 1..1 + nodes }
    }

    /// Steps of the lowest region in one of the uppermost.
    pub fn parts(&self) -> u32 {
        self.border().map_or(1, |border| border.parts)
    }

    /// Steps of the region of a row in one of the uppermost region.
    pub fn parts_at(&self, row: usize) -> f64 {
        f64::from(self.places.parts_at(row))
    }

    /// Step of a node and of the element below it, where that of the uppermost region is `dt`, s.
    pub fn step_s(&self, index: usize, dt: f64) -> f64 {
        dt / self.parts_at(self.place(index).0)
    }

    /// Repeats the first row of states of each region below its last, one lane lower, after the
    /// [ghosts](Self::set_ghosts) were set.
    pub fn close(&mut self) {
        self.set_ghosts();
        for region in 0..self.regions() {
            self.region(region).close();
        }
    }

    /// Row and lane of the ghosts of the upper and of the lower region.
    pub(in crate::dynamics::kernel) fn ghosts(&self) -> Option<[(usize, usize); 2]> {
        self.places.ghosts()
    }

    /// Copies to each ghost the position and velocity of the node that it represents.
    pub fn set_ghosts(&mut self) {
        let Some((border, ghosts)) = self.border().zip(self.ghosts()) else {
            return;
        };
        for ((row, lane), index) in ghosts.into_iter().zip([border.node + 1, border.node]) {
            let (from, from_lane) = self.place(index);
            // The ghost is in the other region.
            if let Ok([ghost, state]) = self.states.get_disjoint_mut([row, from]) {
                ghost.copy_lane(lane, state, from_lane);
            }
        }
    }

    /// Lets the ghosts move at their own velocity only, and lets nothing between the regions slide
    /// along a hole.
    pub(super) fn unbind_ghosts(&mut self) {
        let Some([upper, lower]) = self.ghosts() else {
            return;
        };
        let between = self.places.rows_of(0).end;
        for (row, lane) in (0..R::LANES).map(|lane| (between, lane)).chain([upper, lower]) {
            for axis in &mut self.node_blocks[row].tangent {
                axis.0[lane] = R::default();
            }
        }
    }

    /// Place of an element in the lower region, if it is shared; for other elements the same as
    /// [`Self::place`].
    pub(super) fn lower_place_of_element(&self, index: usize) -> (usize, usize) {
        match self.border().zip(self.ghosts()) {
            Some((border, [_, lower])) if index == border.node => lower,
            _ => self.place(index),
        }
    }

    /// Twist of an element as the lower region has it, if it has it, rad.
    pub(in crate::dynamics) fn lower_twist(&self, index: usize) -> f64 {
        let (row, lane) = self.lower_place_of_element(index);
        self.element_blocks[row].twist.0[lane].to_f64()
    }

    /// Copies to the lower region the upper one's data of an element, if they share it: all but its
    /// twist, which the lower one integrates itself.
    pub(super) fn share_element(&mut self, index: usize) {
        let (row, lane) = self.lower_place_of_element(index);
        let (from, from_lane) = self.place(index);
        if row == from {
            return;
        }
        let element = self.element_blocks[from];
        let twist = self.element_blocks[row].twist.0[lane];
        self.element_blocks[row].copy_lane(lane, &element, from_lane);
        self.element_blocks[row].twist.0[lane] = twist;
    }

    /// Values of `copy` for the rows of a region, lane by lane from `lane` on: in the order of the
    /// string; none for a region that does not exist.
    pub(super) fn along<'a>(
        &'a self,
        region: usize,
        lane: usize,
        copy: impl Fn(usize, usize) -> f64 + Copy + 'a,
    ) -> impl Iterator<Item = f64> + 'a {
        let rows = if region < self.regions() { self.places.rows_of(region) } else { 0..0 };
        (lane..R::LANES).flat_map(move |lane| rows.clone().map(move |row| copy(row, lane)))
    }
}
