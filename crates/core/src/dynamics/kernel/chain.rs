//! The chain of nodes and elements as the time loop holds it: a structure of arrays.
//!
//! The chain is cut into as many pieces as there are lanes, and the pieces are stored side by side:
//! node `i` is in row `i mod rows`, lane `i / rows`. The next node along the string is thus in the
//! same lane of the next row, and one instruction works on all lanes without moving a number
//! between them; only where a piece ends does its last element use the first node of the next lane.
//! A whole string of thousands of metres fits in the second-level cache. Positions are
//! displacements from each node's own anchor on the hole's axis.

mod blocks;
mod numbers;
mod region;
mod rows;
pub mod upkeep;

pub use blocks::{ElementBlock, ImbalanceBlock, NO_WALL_M, NodeBlock, StateBlock};
pub(crate) use numbers::{element, node, number};
pub use region::RegionRows;
pub use rows::{Row, Rows};

use serde::{Deserialize, Serialize};

use self::rows::CopyLane;
use super::{
    layout::Layout,
    places::{Border, Places},
};
use crate::{
    damage::{Damaged, ensure},
    rod::element::{Pose, Stiffness},
    simd::{number::Real, vector::Vector},
};

/// The whole chain.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(bound = "")]
pub struct Chain<R: Real = f64> {
    nodes: usize,
    /// Number of nodes after which the string looks the same: from joint to joint.
    pattern: usize,
    places: Places,
    /// Rest length of each element, m: however the chain keeps its numbers, its chords are compared
    /// with these.
    lengths_m: Vec<f64>,
    /// Motion of the nodes, row by row; the row after the last of a region repeats its first one
    /// lane lower, for the elements where pieces end.
    pub states: Vec<StateBlock<R>>,
    /// Nodes, row by row.
    pub node_blocks: Vec<NodeBlock<R>>,
    /// Elements, as many rows as nodes have.
    pub element_blocks: Vec<ElementBlock<R>>,
    /// Imbalances of the nodes, row by row; none where none is eccentric.
    pub imbalance_blocks: Vec<ImbalanceBlock<R>>,
}

macro_rules! vector_access {
    ($($get:ident, $set:ident, $blocks:ident, $field:ident, $what:literal;)*) => {$(
        #[doc = $what]
        pub fn $get(&self, index: usize) -> Vector<f64> {
            let (row, lane) = self.place(index);
            let [x, y, z] = &self.$blocks[row].$field;
            Vector(x.0[lane].to_f64(), y.0[lane].to_f64(), z.0[lane].to_f64())
        }
        #[doc = concat!("Sets: ", $what)]
        pub fn $set(&mut self, index: usize, value: Vector<f64>) {
            let (row, lane) = self.place(index);
            let [x, y, z] = &mut self.$blocks[row].$field;
            x.0[lane] = R::from_f64(value.0);
            y.0[lane] = R::from_f64(value.1);
            z.0[lane] = R::from_f64(value.2);
        }
    )*};
}

impl Chain {
    /// A chain of `nodes` idle nodes.
    #[cfg(test)]
    pub fn new(nodes: usize) -> Self {
        Self::idle(nodes, 1)
    }

    /// A chain of `nodes` idle nodes for a string that looks the same after every `pattern` of
    /// them.
    pub fn patterned(nodes: usize, pattern: usize) -> Self {
        Self::idle(nodes, pattern)
    }
}

impl<R: Real> Chain<R> {
    fn idle(nodes: usize, pattern: usize) -> Self {
        Self::divided(nodes, pattern, None)
    }

    fn divided(nodes: usize, pattern: usize, border: Option<Border>) -> Self {
        Self::in_places(nodes, pattern, Places::new(nodes, R::LANES, pattern, border))
    }

    fn in_places(nodes: usize, pattern: usize, places: Places) -> Self {
        let rows = places.rows();
        let mut chain = Self {
            nodes,
            pattern,
            places,
            lengths_m: vec![1.0; nodes],
            states: vec![StateBlock::at_rest(); rows + 1],
            node_blocks: vec![NodeBlock::idle(); rows],
            element_blocks: vec![ElementBlock::idle(); rows],
            imbalance_blocks: Vec::new(),
        };
        chain.unbind_ghosts();
        chain
    }

    /// The same chain in another kind of number.
    pub fn converted<S: Real>(&self) -> Chain<S> {
        self.divided_at(self.border())
    }

    /// The same chain in another kind of number and divided elsewhere, or not at all.
    pub fn divided_at<S: Real>(&self, border: Option<Border>) -> Chain<S> {
        self.moved_into(Chain::divided(self.nodes, self.pattern, border))
    }

    /// The same chain in pieces of so many rows.
    #[cfg(test)]
    pub fn in_rows(&self, rows: usize) -> Self {
        let places = Places::whole(super::lane_layout::LaneLayout::of(rows));
        self.moved_into(Self::in_places(self.nodes, self.pattern, places))
    }

    fn moved_into<S: Real>(&self, mut chain: Chain<S>) -> Chain<S> {
        chain.lengths_m.clone_from(&self.lengths_m);
        if !self.imbalance_blocks.is_empty() {
            chain.imbalance_blocks = vec![ImbalanceBlock::none(); chain.node_blocks.len()];
        }
        for index in 0..self.nodes {
            let ((row, lane), (from, from_lane)) = (chain.place(index), self.place(index));
            chain.states[row].copy_lane(lane, &self.states[from], from_lane);
            chain.node_blocks[row].copy_lane(lane, &self.node_blocks[from], from_lane);
            chain.element_blocks[row].copy_lane(lane, &self.element_blocks[from], from_lane);
            if let Some(imbalances) = self.imbalance_blocks.get(from) {
                chain.imbalance_blocks[row].copy_lane(lane, imbalances, from_lane);
            }
        }
        if let Some((border, [_, (row, lane)])) = chain.border().zip(chain.ghosts()) {
            let (from, from_lane) = self.lower_place_of_element(border.node);
            chain.element_blocks[row].copy_lane(lane, &self.element_blocks[from], from_lane);
        }
        chain
    }

    /// Whether a stored chain is one of so many nodes with this pattern, divided here.
    pub(crate) fn check(
        &self,
        nodes: usize,
        pattern: usize,
        border: Option<Border>,
    ) -> Result<(), Damaged> {
        let places = Places::new(nodes, R::LANES, pattern, border);
        let rows = places.rows();
        let fits = (self.nodes, self.pattern, self.places) == (nodes, pattern, places)
            && self.lengths_m.len() == nodes
            && self.states.len() == rows + 1
            && self.node_blocks.len() == rows
            && self.element_blocks.len() == rows
            && [0, rows].contains(&self.imbalance_blocks.len());
        ensure(fits, "the string")
    }

    /// Layout of the data of its nodes that are kept in double precision.
    pub fn layout(&self) -> Layout {
        Layout::beside::<R>(self.places)
    }

    /// Row and lane of a node, and of the element below it.
    #[inline]
    pub fn place(&self, index: usize) -> (usize, usize) {
        self.places.place(index)
    }

    /// The node at a row and a lane; none of the string's where the last lane is not full.
    pub fn index(&self, row: usize, lane: usize) -> usize {
        self.places.index(row, lane)
    }

    /// Motion of the lower ends of a row of elements, if the states were closed since: after a step
    /// the row that [closes](Self::close) them is that of the step's beginning.
    pub fn ends(&self, row: usize) -> &StateBlock<R> {
        &self.states[row + 1]
    }

    /// Effective tension of each element at the last step, from the first of a piece down, N, and
    /// its index.
    pub fn tensions_N(&self, lane: usize) -> impl Iterator<Item = (usize, f64)> {
        let to_f64 = |row: usize, lane: usize| self.element_blocks[row].tension.0[lane].to_f64();
        let upper = self.places.nodes_of(0, self.elements()).end;
        let first = (lane * self.places.rows_of(0).len()).min(upper);
        let above = (first..upper).zip(self.along(0, lane, to_f64));
        above.chain((upper..self.elements()).zip(self.along(1, 0, to_f64).skip(1)))
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.nodes - 1
    }

    vector_access! {
        displacement, set_displacement, states, u, "Displacement of a node from its anchor, m.";
        velocity, set_velocity, states, v, "Velocity of a node, m/s.";
        director, set_director, states, d, "Director of a node.";
        turning, set_turning, states, w, "Angular velocity of a node across its director, rad/s.";
        tangent, set_tangent, node_blocks, tangent, "Tangent of the hole at a node's anchor.";
        curvature, set_curvature, node_blocks, curvature, "Curvature of the hole at a node's \
                                                           anchor, 1/m.";
        weight, set_weight, node_blocks, weight, "Buoyed weight of a node, N.";
        chord, set_chord, element_blocks, chord, "Chord between the anchors of an element, m.";
    }

    /// Gives a node an imbalance.
    pub fn set_imbalance(&mut self, index: usize, imbalance: &NodeImbalance) {
        if self.imbalance_blocks.is_empty() {
            self.imbalance_blocks = vec![ImbalanceBlock::none(); self.node_blocks.len()];
        }
        let (row, lane) = self.place(index);
        self.imbalance_blocks[row].set(lane, imbalance);
    }

    /// The imbalance of a node, if it has one.
    pub fn imbalance(&self, index: usize) -> Option<NodeImbalance> {
        let (row, lane) = self.place(index);
        self.imbalance_blocks.get(row)?.get(lane)
    }

    /// Those of all nodes that have one, from the top down.
    pub fn imbalances(&self) -> impl Iterator<Item = (usize, NodeImbalance)> {
        let nodes = if self.imbalance_blocks.is_empty() { 0 } else { self.nodes };
        (0..nodes).filter_map(|index| Some((index, self.imbalance(index)?)))
    }

    /// Gives an element its stiffness.
    pub fn set_stiffness(&mut self, index: usize, k: &Stiffness<f64>) {
        self.lengths_m[index] = k.length;
        element!(self, index, length = k.length);
        element!(self, index, axial = k.axial);
        element!(self, index, bending_far = k.bending_far);
        element!(self, index, half_bow_near = k.half_bow_near);
        element!(self, index, bow_far = k.bow_far);
        element!(self, index, torsion = k.twist);
        element!(self, index, bending = k.bending);
        self.share_element(index);
    }

    /// The stiffness of an element.
    pub fn stiffness(&self, index: usize) -> Stiffness<f64> {
        Stiffness {
            length: element!(self, index, length),
            axial: element!(self, index, axial),
            bending_far: element!(self, index, bending_far),
            half_bow_near: element!(self, index, half_bow_near),
            bow_far: element!(self, index, bow_far),
            twist: element!(self, index, torsion),
            bending: element!(self, index, bending),
        }
    }

    /// Pose and velocities of an element.
    pub fn pose(&self, index: usize) -> Pose<f64> {
        let (one, two) = (index, index + 1);
        Pose {
            anchor_chord: self.chord(index),
            anchor_excess: element!(self, index, excess),
            displacement: self.displacement(two) - self.displacement(one),
            velocity: self.velocity(two) - self.velocity(one),
            d1: self.director(one),
            d2: self.director(two),
            w1: self.turning(one),
            w2: self.turning(two),
            spin: node!(self, two, spin) - node!(self, one, spin),
            twist: element!(self, index, twist),
        }
    }

    /// Sets the chord between the anchors of an element, and the values derived from it.
    pub fn set_anchor_chord(&mut self, index: usize, chord: Vector<f64>) {
        let length = self.lengths_m[index];
        self.set_chord(index, chord);
        // |a|² − L² = (|a| − L)(|a| + L), exact to the last digits of the chord.
        let a = chord.dot(chord).sqrt();
        element!(self, index, excess = (a - length) * (a + length));
        self.share_element(index);
    }
}

// The imbalance of a single node.

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
    fn set(&mut self, lane: usize, imbalance: &NodeImbalance) {
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
    fn get(&self, lane: usize) -> Option<NodeImbalance> {
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
