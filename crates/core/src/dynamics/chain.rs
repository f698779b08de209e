//! The chain of nodes and elements as the time loop holds it.
//!
//! The chain is cut into as many strands as there are lanes, and the strands lie side by side: node `i` is in row
//! `i mod rows`, lane `i / rows`. What is next along the string so stands in the same lane of the next row, and
//! one instruction works on all lanes without moving a number between them; only where a strand ends does its
//! last element reach for the first node of the next lane. A whole string of thousands of metres fits in the
//! second-level cache. Positions are displacements from each node's own anchor on the hole's axis.

use serde::{Deserialize, Serialize};

use super::layout::{Layout, Strands};
use crate::rod::{
    element::{Pose, Stiffness},
    lanes::DOUBLES,
    number::Real,
    vector::Vector,
};

/// One number for each lane.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[repr(C, align(64))]
#[serde(bound = "")]
pub struct Row<R: Real>(pub R::Lanes);

impl<R: Real> Row<R> {
    /// The same number in every lane.
    pub fn filled(value: f64) -> Self {
        Self(R::from_f64(value).in_every_lane())
    }

    /// Moves every number one lane up; zero comes in.
    pub fn go_on(&mut self) {
        self.0.as_mut().copy_within(..R::LANES - 1, 1);
        self.0[0] = R::default();
    }

    /// The part of the row that stands beside a block of doubles: [`Layout`].
    #[inline(always)]
    pub fn part(&self, part: usize) -> &[R; DOUBLES] {
        &self.0.as_ref().as_chunks().0[part]
    }
}

/// A vector for each lane.
pub type Rows<R> = [Row<R>; 3];

/// What takes over the numbers of a lane from rows of another kind of number.
trait CopyLane<Rows> {
    fn copy_lane(&mut self, lane: usize, from: &Rows, from_lane: usize);
}

impl<R: Real, S: Real> CopyLane<Row<S>> for Row<R> {
    fn copy_lane(&mut self, lane: usize, from: &Row<S>, from_lane: usize) {
        self.0[lane] = R::from_f64(from.0[from_lane].to_f64());
    }
}

impl<R: Real, S: Real> CopyLane<Rows<S>> for Rows<R> {
    fn copy_lane(&mut self, lane: usize, from: &Rows<S>, from_lane: usize) {
        for (row, from) in self.iter_mut().zip(from) {
            row.copy_lane(lane, from, from_lane);
        }
    }
}

/// A block of rows.
macro_rules! block {
    (
        $(#[$meta:meta])*
        pub struct $name:ident<R> {
            $($(#[$doc:meta])* pub $field:ident: $rows:ty,)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, Serialize, Deserialize)]
        #[repr(C, align(64))]
        #[serde(bound = "")]
        pub struct $name<R: Real> {
            $($(#[$doc])* pub $field: $rows,)*
        }

        impl<R: Real, S: Real> CopyLane<$name<S>> for $name<R> {
            fn copy_lane(&mut self, lane: usize, from: &$name<S>, from_lane: usize) {
                $(self.$field.copy_lane(lane, &from.$field, from_lane);)*
            }
        }
    };
}

/// Clearance of a node that no wall is near, m.
pub const NO_WALL_M: f64 = 1e3;

block! {
    /// A row of nodes: how they move.
    pub struct StateBlock<R> {
        /// Displacement from the anchor, m.
        pub u: Rows<R>,
        /// Velocity, m/s, half a step behind the displacement.
        pub v: Rows<R>,
        /// Director.
        pub d: Rows<R>,
        /// Angular velocity across the director, rad/s.
        pub w: Rows<R>,
        /// Spin about the director, rad/s.
        pub spin: Row<R>,
    }
}

impl<R: Real> StateBlock<R> {
    fn at_rest() -> Self {
        let (zero, one) = (Row::filled(0.0), Row::filled(1.0));
        Self {
            u: [zero; 3],
            v: [zero; 3],
            d: [zero, zero, one],
            w: [zero; 3],
            spin: zero,
        }
    }

    fn rows(&self) -> impl Iterator<Item = &Row<R>> {
        let Self { u, v, d, w, spin } = self;
        u.iter()
            .chain(v)
            .chain(d)
            .chain(w)
            .chain(std::iter::once(spin))
    }

    fn rows_mut(&mut self) -> impl Iterator<Item = &mut Row<R>> {
        let Self { u, v, d, w, spin } = self;
        u.iter_mut()
            .chain(v)
            .chain(d)
            .chain(w)
            .chain(std::iter::once(spin))
    }
}

block! {
    /// A row of nodes: what they are, what is summed up between samples, and last what a plain step does not ask for.
    pub struct NodeBlock<R> {
        /// Tangent of the hole's axis at the anchor.
        pub tangent: Rows<R>,
        /// Curvature vector of the hole's axis at the anchor, 1/m.
        pub curvature: Rows<R>,
        /// Buoyed weight, N.
        pub weight: Rows<R>,
        /// Inertia across the hole, kg: steel, mud inside and mud carried along outside.
        pub mass_lateral: Row<R>,
        /// Inverse of `mass_axial`; zero where the motion is prescribed.
        pub inv_mass_axial: Row<R>,
        /// Inverse of `mass_lateral`; zero where the motion is prescribed.
        pub inv_mass_lateral: Row<R>,
        /// Inverse of `polar`; zero where the spin is prescribed.
        pub inv_polar: Row<R>,
        /// Inverse of the moment of inertia across the director; zero where it may not turn.
        pub inv_rotary: Row<R>,
        /// `polar` over the moment of inertia across the director.
        pub gyroscopic: Row<R>,
        /// Clearance `R − r` between pipe and hole at the anchor, m.
        pub clearance: Row<R>,
        /// Contact radius `r`, m.
        pub radius: Row<R>,
        /// Kinetic friction coefficient.
        pub friction: Row<R>,
        /// Contact stiffness, N/m or N/m^1.5.
        pub stiffness: Row<R>,
        /// Linear lateral drag, N·s/m.
        pub drag_linear: Row<R>,
        /// Quadratic lateral drag, N·s²/m².
        pub drag_quadratic: Row<R>,
        /// Sum over steps of the contact force, N.
        pub sum_normal: Row<R>,
        /// Sum over steps of the axial friction on the wall, N, along the hole.
        pub sum_axial: Row<R>,
        /// Sum over steps of the friction torque, N·m.
        pub sum_torque: Row<R>,
        /// Work that friction has done, J: force times sliding distance.
        pub sum_wear: Row<R>,
        /// Inertia along the hole, kg: steel.
        pub mass_axial: Row<R>,
        /// Moment of inertia about the director, kg·m².
        pub polar: Row<R>,
        /// What the clearance gains per metre below the anchor.
        pub clearance_slope: Row<R>,
        /// What the friction coefficient gains at rest.
        pub friction_rise: Row<R>,
        /// Friction around the hole over friction along it.
        pub friction_around: Row<R>,
        /// Viscous drag of the mud along the hole, N·s/m.
        pub mud_axial: Row<R>,
        /// Viscous drag of the mud about the axis, N·m·s.
        pub mud_spin: Row<R>,
        /// Contact damping of the linear law, N·s/m.
        pub damping: Row<R>,
    }
}

block! {
    /// A row of elements; element `i` lies between nodes `i` and `i + 1`.
    pub struct ElementBlock<R> {
        /// Twist, rad.
        pub twist: Row<R>,
        /// Chord between the anchors of the two ends, m.
        pub chord: Rows<R>,
        /// Square of that chord less the square of the rest length, m².
        pub excess: Row<R>,
        /// Stiffness, in the order of [`Stiffness`].
        pub length: Row<R>,
        /// `EA/L`.
        pub axial: Row<R>,
        /// `B₀ EI/L`.
        pub bending_far: Row<R>,
        /// `a L/2`.
        pub half_bow_near: Row<R>,
        /// `b L`.
        pub bow_far: Row<R>,
        /// `GJ/L`.
        pub torsion: Row<R>,
        /// `EI/L`.
        pub bending: Row<R>,
        /// Effective tension at the last step, N.
        pub tension: Row<R>,
        /// Torque `M` at the last step, N·m: negative while the top leads the bit.
        pub torque: Row<R>,
    }
}

impl<R: Real> NodeBlock<R> {
    /// Clears what is summed up between samples.
    pub fn clear_sums(&mut self) {
        let zero = Row::filled(0.0);
        (self.sum_normal, self.sum_axial) = (zero, zero);
        (self.sum_torque, self.sum_wear) = (zero, zero);
    }

    /// Nodes that fill the last lane: no force moves them, they move nothing and have no energy. Real nodes begin as
    /// these.
    fn idle() -> Self {
        let row = Row::filled;
        let (zero, one) = (row(0.0), row(1.0));
        Self {
            tangent: [zero, zero, one],
            curvature: [zero; 3],
            weight: [zero; 3],
            mass_axial: zero,
            mass_lateral: zero,
            polar: zero,
            inv_mass_axial: zero,
            inv_mass_lateral: zero,
            inv_polar: zero,
            inv_rotary: zero,
            gyroscopic: zero,
            clearance: row(NO_WALL_M),
            clearance_slope: zero,
            radius: zero,
            friction: zero,
            friction_rise: zero,
            friction_around: one,
            stiffness: zero,
            damping: zero,
            drag_linear: zero,
            drag_quadratic: zero,
            mud_axial: zero,
            mud_spin: zero,
            sum_normal: zero,
            sum_axial: zero,
            sum_torque: zero,
            sum_wear: zero,
        }
    }
}

impl<R: Real> ElementBlock<R> {
    fn idle() -> Self {
        let row = Row::filled;
        let (zero, one) = (row(0.0), row(1.0));
        Self {
            twist: zero,
            chord: [zero, zero, one],
            excess: zero,
            length: one,
            axial: zero,
            bending_far: zero,
            half_bow_near: zero,
            bow_far: zero,
            torsion: zero,
            bending: zero,
            tension: zero,
            torque: zero,
        }
    }
}

/// The whole chain.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(bound = "")]
pub struct Chain<R: Real = f64> {
    nodes: usize,
    strands: Strands,
    /// Rest length of each element, m: however the chain keeps its numbers, its chords are held against these.
    lengths_m: Vec<f64>,
    /// How the nodes move, row by row; the last row repeats the first one lane lower, for the elements
    /// where strands end.
    pub states: Vec<StateBlock<R>>,
    /// Nodes, row by row.
    pub node_blocks: Vec<NodeBlock<R>>,
    /// Elements, as many rows as nodes have.
    pub element_blocks: Vec<ElementBlock<R>>,
}

/// One number of a node by the name of its field: `node!(chain, index, radius)` reads it,
/// `node!(chain, index, radius = r)` and `+=` write it.
macro_rules! node {
    ($chain:expr, $index:expr, spin $($write:tt)*) => {
        $crate::dynamics::chain::number!($chain, $index, states, spin $($write)*)
    };
    ($chain:expr, $index:expr, $field:ident $($write:tt)*) => {
        $crate::dynamics::chain::number!($chain, $index, node_blocks, $field $($write)*)
    };
}

/// One number of an element by the name of its field, read and written like that of a [`node!`].
macro_rules! element {
    ($chain:expr, $index:expr, $field:ident $($write:tt)*) => {
        $crate::dynamics::chain::number!($chain, $index, element_blocks, $field $($write)*)
    };
}

/// One number of a row: read, or written with an assignment.
macro_rules! number {
    ($chain:expr, $index:expr, $blocks:ident, $field:ident) => {{
        let (row, lane) = $chain.place($index);
        $crate::rod::number::Real::to_f64($chain.$blocks[row].$field.0[lane])
    }};
    ($chain:expr, $index:expr, $blocks:ident, $field:ident = $value:expr) => {{
        let value: f64 = $value;
        let (row, lane) = $chain.place($index);
        $chain.$blocks[row].$field.0[lane] = $crate::rod::number::Real::from_f64(value);
    }};
    ($chain:expr, $index:expr, $blocks:ident, $field:ident $assign:tt $value:expr) => {{
        let value: f64 = $value;
        let mut number: f64 = $crate::dynamics::chain::number!($chain, $index, $blocks, $field);
        number $assign value;
        $crate::dynamics::chain::number!($chain, $index, $blocks, $field = number);
    }};
}
pub(crate) use {element, node, number};

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
    pub fn new(nodes: usize) -> Self {
        Self::idle(nodes)
    }
}

impl<R: Real> Chain<R> {
    fn idle(nodes: usize) -> Self {
        let strands = Strands::new(nodes, R::LANES);
        let rows = strands.rows();
        Self {
            nodes,
            strands,
            lengths_m: vec![1.0; nodes],
            states: vec![StateBlock::at_rest(); rows + 1],
            node_blocks: vec![NodeBlock::idle(); rows],
            element_blocks: vec![ElementBlock::idle(); rows],
        }
    }

    /// The same chain in another kind of number.
    pub fn converted<S: Real>(&self) -> Chain<S> {
        let mut chain = Chain::<S>::idle(self.nodes);
        chain.lengths_m.clone_from(&self.lengths_m);
        for index in 0..self.nodes {
            let ((row, lane), (from, from_lane)) = (chain.place(index), self.place(index));
            chain.states[row].copy_lane(lane, &self.states[from], from_lane);
            chain.node_blocks[row].copy_lane(lane, &self.node_blocks[from], from_lane);
            chain.element_blocks[row].copy_lane(lane, &self.element_blocks[from], from_lane);
        }
        chain
    }

    /// Where what is kept of its nodes in double precision lies.
    pub fn layout(&self) -> Layout {
        Layout::beside::<R>(self.nodes)
    }

    /// Row and lane of a node, and of the element below it.
    #[inline]
    pub fn place(&self, index: usize) -> (usize, usize) {
        self.strands.place(index)
    }

    /// Repeats the first row of states below the last, one lane lower. The last lane ends in itself.
    pub fn close(&mut self) {
        let rows = self.node_blocks.len();
        let (above, close) = self.states.split_at_mut(rows);
        let (first, last) = (above[0].rows(), above[rows - 1].rows());
        for ((row, first), last) in close[0].rows_mut().zip(first).zip(last) {
            let end = R::LANES - 1;
            row.0.as_mut()[..end].copy_from_slice(&first.0.as_ref()[1..]);
            row.0[end] = last.0[end];
        }
    }

    /// How the lower ends of a row of elements move, if the states were closed since: after a step the row that
    /// [closes](Self::close) them is that of the step's beginning.
    pub fn ends(&self, row: usize) -> &StateBlock<R> {
        &self.states[row + 1]
    }

    /// Whether a node has slid further along the hole than `reach_m` from its anchor.
    pub fn slid(&self, reach_m: f64) -> bool {
        let reach = R::from_f64(reach_m);
        let mut slid = false;
        // Every number is looked at: a loop that ends early is none that looks at eight at once.
        for (state, node) in self.states.iter().zip(&self.node_blocks) {
            for lane in 0..R::LANES {
                let [x, y, z] = [0, 1, 2].map(|a| state.u[a].0[lane] * node.tangent[a].0[lane]);
                let along = x + y + z;
                slid |= along > reach || along < -reach;
            }
        }
        slid
    }

    /// Effective tension of each element at the last step, from the top down, N.
    pub fn tensions_N(&self) -> impl Iterator<Item = f64> {
        let along = |lane| {
            let blocks = self.element_blocks.iter();
            blocks.map(move |block: &ElementBlock<R>| block.tension.0[lane].to_f64())
        };
        (0..R::LANES).flat_map(along).take(self.elements())
    }

    /// Work that friction has done at each node since the last sample, from the top down, J.
    pub fn wear_J(&self) -> impl Iterator<Item = f64> {
        let along = |lane| {
            let blocks = self.node_blocks.iter();
            blocks.map(move |block: &NodeBlock<R>| block.sum_wear.0[lane].to_f64())
        };
        (0..R::LANES).flat_map(along).take(self.nodes)
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
        curvature, set_curvature, node_blocks, curvature, "Curvature of the hole at a node's anchor, 1/m.";
        weight, set_weight, node_blocks, weight, "Buoyed weight of a node, N.";
        chord, set_chord, element_blocks, chord, "Chord between the anchors of an element, m.";
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

    /// How an element stands and moves.
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

    /// Takes out what rounding has added to the directors' lengths and to the angular velocities along
    /// them. The step preserves both but for the damping of bending: once in a hundred steps is plenty.
    pub fn square_up(&mut self) {
        for index in 0..self.nodes {
            let d = self.director(index);
            let unit = d.scaled(1.0 / d.dot(d).sqrt());
            let w = self.turning(index);
            self.set_director(index, unit);
            self.set_turning(index, w.minus(unit, w.dot(unit)));
        }
    }

    /// Clears what is summed up between samples.
    pub fn clear_sums(&mut self) {
        for block in &mut self.node_blocks {
            block.clear_sums();
        }
    }

    /// Sets the chord between the anchors of an element, and what follows from it.
    pub fn set_anchor_chord(&mut self, index: usize, chord: Vector<f64>) {
        let length = self.lengths_m[index];
        self.set_chord(index, chord);
        // |a|² − L² = (|a| − L)(|a| + L), exact to the last digits of the chord.
        let a = chord.dot(chord).sqrt();
        element!(self, index, excess = (a - length) * (a + length));
    }
}
