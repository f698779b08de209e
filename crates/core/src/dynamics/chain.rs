//! The chain of nodes and elements as the time loop holds it.
//!
//! Eight neighbours stand side by side in one block, so that one instruction works on all of them; a
//! whole string of thousands of metres fits in the second-level cache. Positions are displacements
//! from each node's own anchor on the hole's axis.

use crate::rod::{
    element::{Pose, Stiffness},
    lanes::LANES,
    vector::Vector,
};

/// One number for each of eight neighbours.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub struct Row(pub [f64; LANES]);

/// A vector for each of eight neighbours.
pub type Rows = [Row; 3];

const ZERO: Row = Row([0.0; LANES]);
const ONE: Row = Row([1.0; LANES]);

/// Clearance of a node that no wall is near, m.
pub const NO_WALL_M: f64 = 1e3;

/// Eight nodes: what moves, then what they are, then what is summed up between samples.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub struct NodeBlock {
    /// Displacement from the anchor, m.
    pub u: Rows,
    /// Velocity, m/s, half a step behind the displacement.
    pub v: Rows,
    /// Director.
    pub d: Rows,
    /// Angular velocity across the director, rad/s.
    pub w: Rows,
    /// Spin about the director, rad/s.
    pub spin: Row,
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
    /// Clearance `R − r` between pipe and hole, m.
    pub clearance: Row,
    /// Contact radius `r`, m.
    pub radius: Row,
    /// Kinetic friction coefficient.
    pub friction: Row,
    /// What the friction coefficient gains at rest.
    pub friction_rise: Row,
    /// Contact stiffness, N/m or N/m^1.5.
    pub stiffness: Row,
    /// Contact damping of the linear law, N·s/m.
    pub damping: Row,
    /// Linear lateral drag, N·s/m.
    pub drag_linear: Row,
    /// Quadratic lateral drag, N·s²/m².
    pub drag_quadratic: Row,
    /// Sum over steps of the contact force, N.
    pub sum_normal: Row,
    /// Sum over steps of the axial friction on the wall, N, along the hole.
    pub sum_axial: Row,
    /// Sum over steps of the friction torque, N·m.
    pub sum_torque: Row,
}

/// Eight elements; element `i` lies between nodes `i` and `i + 1`.
#[derive(Debug, Clone, Copy)]
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
    /// Nodes that fill the last block: nothing moves them and they move nothing.
    pub const IDLE: Self = Self {
        u: [ZERO; 3],
        v: [ZERO; 3],
        d: DOWN,
        w: [ZERO; 3],
        spin: ZERO,
        tangent: DOWN,
        curvature: [ZERO; 3],
        weight: [ZERO; 3],
        mass_axial: ZERO,
        mass_lateral: ZERO,
        polar: ZERO,
        inv_mass_axial: ZERO,
        inv_mass_lateral: ZERO,
        inv_polar: ZERO,
        inv_rotary: ZERO,
        gyroscopic: ZERO,
        clearance: Row([NO_WALL_M; LANES]),
        radius: ZERO,
        friction: ZERO,
        friction_rise: ZERO,
        stiffness: ZERO,
        damping: ZERO,
        drag_linear: ZERO,
        drag_quadratic: ZERO,
        sum_normal: ZERO,
        sum_axial: ZERO,
        sum_torque: ZERO,
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
#[derive(Debug, Clone)]
pub struct Chain {
    nodes: usize,
    /// Nodes by eights.
    pub node_blocks: Vec<NodeBlock>,
    /// Elements by eights, as many blocks as nodes have.
    pub element_blocks: Vec<ElementBlock>,
}

/// Reads lane `index` of a row that `field` picks.
macro_rules! node {
    ($chain:expr, $index:expr, $field:ident) => {
        $chain.node_blocks[$index / $crate::rod::lanes::LANES].$field.0
            [$index % $crate::rod::lanes::LANES]
    };
}
macro_rules! element {
    ($chain:expr, $index:expr, $field:ident) => {
        $chain.element_blocks[$index / $crate::rod::lanes::LANES].$field.0
            [$index % $crate::rod::lanes::LANES]
    };
}
pub(crate) use {element, node};

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

    vector_access! {
        displacement, set_displacement, node_blocks, u, "Displacement of a node from its anchor, m.";
        velocity, set_velocity, node_blocks, v, "Velocity of a node, m/s.";
        director, set_director, node_blocks, d, "Director of a node.";
        turning, set_turning, node_blocks, w, "Angular velocity of a node across its director, rad/s.";
        tangent, set_tangent, node_blocks, tangent, "Tangent of the hole at a node's anchor.";
        curvature, set_curvature, node_blocks, curvature, "Curvature of the hole at a node's anchor, 1/m.";
        weight, set_weight, node_blocks, weight, "Buoyed weight of a node, N.";
        chord, set_chord, element_blocks, chord, "Chord between the anchors of an element, m.";
    }

    /// Gives an element its stiffness.
    pub fn set_stiffness(&mut self, index: usize, k: &Stiffness<f64>) {
        element!(self, index, length) = k.length;
        element!(self, index, inverse_length) = k.inverse_length;
        element!(self, index, axial) = k.axial;
        element!(self, index, bending_near) = k.bending_near;
        element!(self, index, bending_far) = k.bending_far;
        element!(self, index, bow_near) = k.bow_near;
        element!(self, index, bow_far) = k.bow_far;
        element!(self, index, torsion) = k.twist;
        element!(self, index, bending) = k.bending;
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

    /// Sets the chord between the anchors of an element, and what follows from it.
    pub fn set_anchor_chord(&mut self, index: usize, chord: Vector<f64>) {
        let length = element!(self, index, length);
        self.set_chord(index, chord);
        // |a|² − L² = (|a| − L)(|a| + L), exact to the last digits of the chord.
        let a = chord.dot(chord).sqrt();
        element!(self, index, excess) = (a - length) * (a + length);
    }
}
