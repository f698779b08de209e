//! The chain of nodes and elements as the time loop holds it.
//!
//! Neighbours stand side by side, so that one instruction works on eight of them; a whole string of thousands of metres fits in the second-level cache. Positions are displacements
//! from each node's own anchor on the hole's axis.

use serde::{Deserialize, Serialize};

use crate::rod::{
    element::{Pose, Stiffness},
    lanes::LANES,
    vector::Vector,
};

/// One number for each of eight neighbours.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[repr(C, align(64))]
pub struct Row(pub [f64; LANES]);

/// A vector for each of eight neighbours.
pub type Rows = [Row; 3];

const ZERO: Row = Row([0.0; LANES]);
const ONE: Row = Row([1.0; LANES]);

/// Clearance of a node that no wall is near, m.
pub const NO_WALL_M: f64 = 1e3;

/// One number for each node, in one piece: an element reads its two ends from neighbouring places.
/// Padded so that nine numbers can be read at every eighth place.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Field(pub Vec<f64>);

impl Field {
    fn filled(blocks: usize, value: f64) -> Self {
        Self(vec![value; (blocks + 1) * LANES])
    }

    /// The eight numbers of a block and the first of the next.
    #[inline(always)]
    pub fn nine(&self, block: usize) -> &[f64; LANES + 1] {
        self.0[block * LANES..]
            .first_chunk()
            .expect("every field is padded by a block")
    }

    /// The eight numbers of a block.
    #[inline(always)]
    pub fn eight(&mut self, block: usize) -> &mut [f64; LANES] {
        self.0[block * LANES..]
            .first_chunk_mut()
            .expect("every field is padded by a block")
    }
}

/// What moves.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct State {
    /// Displacement from the anchor, m.
    pub u: [Field; 3],
    /// Velocity, m/s, half a step behind the displacement.
    pub v: [Field; 3],
    /// Director.
    pub d: [Field; 3],
    /// Angular velocity across the director, rad/s.
    pub w: [Field; 3],
    /// Spin about the director, rad/s.
    pub spin: Field,
}

impl State {
    fn at_rest(blocks: usize) -> Self {
        let zeros = || std::array::from_fn(|_| Field::filled(blocks, 0.0));
        Self {
            u: zeros(),
            v: zeros(),
            d: [0.0, 0.0, 1.0].map(|x| Field::filled(blocks, x)),
            w: zeros(),
            spin: Field::filled(blocks, 0.0),
        }
    }
}

/// Eight nodes: what they are, then what is summed up between samples.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[repr(C, align(64))]
pub struct NodeBlock {
    /// Tangent of the hole's axis at the anchor.
    pub tangent: Rows,
    /// Curvature vector of the hole's axis at the anchor, 1/m.
    pub curvature: Rows,
    /// Buoyed weight, N.
    pub weight: Rows,
    /// Inertia along the hole, kg: steel.
    pub mass_axial: Row,
    /// Inertia across the hole, kg: steel, mud inside and mud carried along outside.
    pub mass_lateral: Row,
    /// Moment of inertia about the director, kg·m².
    pub polar: Row,
    /// Inverse of `mass_axial`; zero where the motion is prescribed.
    pub inv_mass_axial: Row,
    /// Inverse of `mass_lateral`; zero where the motion is prescribed.
    pub inv_mass_lateral: Row,
    /// Inverse of `polar`; zero where the spin is prescribed.
    pub inv_polar: Row,
    /// Inverse of the moment of inertia across the director; zero where it may not turn.
    pub inv_rotary: Row,
    /// `polar` over the moment of inertia across the director.
    pub gyroscopic: Row,
    /// Clearance `R − r` between pipe and hole at the anchor, m.
    pub clearance: Row,
    /// What the clearance gains per metre below the anchor.
    pub clearance_slope: Row,
    /// Contact radius `r`, m.
    pub radius: Row,
    /// Kinetic friction coefficient.
    pub friction: Row,
    /// What the friction coefficient gains at rest.
    pub friction_rise: Row,
    /// Friction around the hole over friction along it.
    pub friction_around: Row,
    /// Contact stiffness, N/m or N/m^1.5.
    pub stiffness: Row,
    /// Contact damping of the linear law, N·s/m.
    pub damping: Row,
    /// Linear lateral drag, N·s/m.
    pub drag_linear: Row,
    /// Quadratic lateral drag, N·s²/m².
    pub drag_quadratic: Row,
    /// Viscous drag of the mud along the hole, N·s/m.
    pub mud_axial: Row,
    /// Viscous drag of the mud about the axis, N·m·s.
    pub mud_spin: Row,
    /// Sum over steps of the contact force, N.
    pub sum_normal: Row,
    /// Sum over steps of the axial friction on the wall, N, along the hole.
    pub sum_axial: Row,
    /// Sum over steps of the friction torque, N·m.
    pub sum_torque: Row,
    /// Work that friction has done, J: force times sliding distance.
    pub sum_wear: Row,
}

/// Eight elements; element `i` lies between nodes `i` and `i + 1`.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[repr(C, align(64))]
pub struct ElementBlock {
    /// Twist, rad.
    pub twist: Row,
    /// Chord between the anchors of the two ends, m.
    pub chord: Rows,
    /// Square of that chord less the square of the rest length, m².
    pub excess: Row,
    /// Stiffness, in the order of [`Stiffness`].
    pub length: Row,
    /// `1/L`.
    pub inverse_length: Row,
    /// `EA`.
    pub axial: Row,
    /// `A₀ EI/L`.
    pub bending_near: Row,
    /// `B₀ EI/L`.
    pub bending_far: Row,
    /// `a L`.
    pub bow_near: Row,
    /// `b L`.
    pub bow_far: Row,
    /// `GJ/L`.
    pub torsion: Row,
    /// `EI/L`.
    pub bending: Row,
    /// Effective tension at the last step, N.
    pub tension: Row,
    /// Torque `M` at the last step, N·m: negative while the top leads the bit.
    pub torque: Row,
}

const DOWN: Rows = [ZERO, ZERO, ONE];

impl NodeBlock {
    /// Nodes that fill the last block: nothing moves them and they move nothing. Real nodes begin as
    /// these, with the masses cleared.
    const IDLE: Self = Self {
        tangent: DOWN,
        curvature: [ZERO; 3],
        weight: [ZERO; 3],
        mass_axial: ONE,
        mass_lateral: ONE,
        polar: ONE,
        inv_mass_axial: ZERO,
        inv_mass_lateral: ZERO,
        inv_polar: ZERO,
        inv_rotary: ZERO,
        gyroscopic: ZERO,
        clearance: Row([NO_WALL_M; LANES]),
        clearance_slope: ZERO,
        radius: ZERO,
        friction: ZERO,
        friction_rise: ZERO,
        friction_around: ONE,
        stiffness: ZERO,
        damping: ZERO,
        drag_linear: ZERO,
        drag_quadratic: ZERO,
        mud_axial: ZERO,
        mud_spin: ZERO,
        sum_normal: ZERO,
        sum_axial: ZERO,
        sum_torque: ZERO,
        sum_wear: ZERO,
    };
}

impl ElementBlock {
    const IDLE: Self = Self {
        twist: ZERO,
        chord: DOWN,
        excess: ZERO,
        length: ONE,
        inverse_length: ONE,
        axial: ZERO,
        bending_near: ZERO,
        bending_far: ZERO,
        bow_near: ZERO,
        bow_far: ZERO,
        torsion: ZERO,
        bending: ZERO,
        tension: ZERO,
        torque: ZERO,
    };
}

/// The whole chain.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Chain {
    nodes: usize,
    /// What moves.
    pub state: State,
    /// Nodes by eights.
    pub node_blocks: Vec<NodeBlock>,
    /// Elements by eights, as many blocks as nodes have.
    pub element_blocks: Vec<ElementBlock>,
}

/// One number of a node by the name of its field: `node!(chain, index, radius)` reads it,
/// `node!(chain, index, radius = r)` and `+=` write it.
macro_rules! node {
    ($chain:expr, $index:expr, spin) => {
        $chain.state.spin.0[$index]
    };
    ($chain:expr, $index:expr, $field:ident) => {
        $chain.node_blocks[$index / $crate::rod::lanes::LANES]
            .$field
            .0[$index % $crate::rod::lanes::LANES]
    };
    ($chain:expr, $index:expr, $field:ident $assign:tt $value:expr) => {{
        let value: f64 = $value;
        $crate::dynamics::chain::node!($chain, $index, $field) $assign value;
    }};
}

/// One number of an element by the name of its field, read and written like that of a [`node!`].
macro_rules! element {
    ($chain:expr, $index:expr, $field:ident) => {
        $chain.element_blocks[$index / $crate::rod::lanes::LANES]
            .$field
            .0[$index % $crate::rod::lanes::LANES]
    };
    ($chain:expr, $index:expr, $field:ident $assign:tt $value:expr) => {{
        let value: f64 = $value;
        $crate::dynamics::chain::element!($chain, $index, $field) $assign value;
    }};
}
pub(crate) use {element, node};

macro_rules! state_access {
    ($($get:ident, $set:ident, $field:ident, $what:literal;)*) => {$(
        #[doc = $what]
        pub fn $get(&self, index: usize) -> Vector<f64> {
            let [x, y, z] = &self.state.$field;
            Vector(x.0[index], y.0[index], z.0[index])
        }
        #[doc = concat!("Sets: ", $what)]
        pub fn $set(&mut self, index: usize, value: Vector<f64>) {
            let [x, y, z] = &mut self.state.$field;
            (x.0[index], y.0[index], z.0[index]) = (value.0, value.1, value.2);
        }
    )*};
}
macro_rules! vector_access {
    ($($get:ident, $set:ident, $blocks:ident, $field:ident, $what:literal;)*) => {$(
        #[doc = $what]
        pub fn $get(&self, index: usize) -> Vector<f64> {
            let rows = &self.$blocks[index / LANES].$field;
            let lane = index % LANES;
            Vector(rows[0].0[lane], rows[1].0[lane], rows[2].0[lane])
        }
        #[doc = concat!("Sets: ", $what)]
        pub fn $set(&mut self, index: usize, value: Vector<f64>) {
            let rows = &mut self.$blocks[index / LANES].$field;
            let lane = index % LANES;
            rows[0].0[lane] = value.0;
            rows[1].0[lane] = value.1;
            rows[2].0[lane] = value.2;
        }
    )*};
}

impl Chain {
    /// A chain of `nodes` idle nodes.
    pub fn new(nodes: usize) -> Self {
        let blocks = nodes.div_ceil(LANES);
        Self {
            nodes,
            state: State::at_rest(blocks),
            node_blocks: vec![NodeBlock::IDLE; blocks],
            element_blocks: vec![ElementBlock::IDLE; blocks],
        }
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.nodes - 1
    }

    state_access! {
        displacement, set_displacement, u, "Displacement of a node from its anchor, m.";
        velocity, set_velocity, v, "Velocity of a node, m/s.";
        director, set_director, d, "Director of a node.";
        turning, set_turning, w, "Angular velocity of a node across its director, rad/s.";
    }

    vector_access! {
        tangent, set_tangent, node_blocks, tangent, "Tangent of the hole at a node's anchor.";
        weight, set_weight, node_blocks, weight, "Buoyed weight of a node, N.";
        chord, set_chord, element_blocks, chord, "Chord between the anchors of an element, m.";
    }

    /// Curvature of the hole at a node's anchor, 1/m.
    pub fn curvature(&self, index: usize) -> Vector<f64> {
        let rows = &self.node_blocks[index / LANES].curvature;
        let lane = index % LANES;
        Vector(rows[0].0[lane], rows[1].0[lane], rows[2].0[lane])
    }

    /// Sets the curvature of the hole at a node's anchor, 1/m.
    pub fn set_curvature(&mut self, index: usize, value: Vector<f64>) {
        let rows = &mut self.node_blocks[index / LANES].curvature;
        let lane = index % LANES;
        (rows[0].0[lane], rows[1].0[lane], rows[2].0[lane]) = (value.0, value.1, value.2);
    }

    /// Gives an element its stiffness.
    pub fn set_stiffness(&mut self, index: usize, k: &Stiffness<f64>) {
        element!(self, index, length = k.length);
        element!(self, index, inverse_length = k.inverse_length);
        element!(self, index, axial = k.axial);
        element!(self, index, bending_near = k.bending_near);
        element!(self, index, bending_far = k.bending_far);
        element!(self, index, bow_near = k.bow_near);
        element!(self, index, bow_far = k.bow_far);
        element!(self, index, torsion = k.twist);
        element!(self, index, bending = k.bending);
    }

    /// The stiffness of an element.
    pub fn stiffness(&self, index: usize) -> Stiffness<f64> {
        Stiffness {
            length: element!(self, index, length),
            inverse_length: element!(self, index, inverse_length),
            axial: element!(self, index, axial),
            bending_near: element!(self, index, bending_near),
            bending_far: element!(self, index, bending_far),
            bow_near: element!(self, index, bow_near),
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
            block.sum_normal.0.fill(0.0);
            block.sum_axial.0.fill(0.0);
            block.sum_torque.0.fill(0.0);
            block.sum_wear.0.fill(0.0);
        }
    }

    /// Sets the chord between the anchors of an element, and what follows from it.
    pub fn set_anchor_chord(&mut self, index: usize, chord: Vector<f64>) {
        let length = element!(self, index, length);
        self.set_chord(index, chord);
        // |a|² − L² = (|a| − L)(|a| + L), exact to the last digits of the chord.
        let a = chord.dot(chord).sqrt();
        element!(self, index, excess = (a - length) * (a + length));
    }
}
