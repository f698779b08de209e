//! The assembly node by node.

use serde::{Deserialize, Serialize};

use crate::{model::Model, statics::stiff::StiffProfile};

/// A node of the assembly. Each pair is the part towards the high side and that to the right of it
/// as one looks down the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AssemblyNode {
    /// Measured depth, m.
    pub md_m: f64,
    /// Distance from the bit, m.
    pub from_bit_m: f64,
    /// Component, counted from the bit; at its end the one above.
    pub component: usize,
    /// Component that touches, counted from the bit: at an end the one with the wider radius.
    pub touching: usize,
    /// Radius of the hole, m.
    pub hole_radius_m: f64,
    /// Offset from the hole's axis, m.
    pub offset_m: [f64; 2],
    /// Tilt of the axis downwards against the hole's, rad; at a bend that of the part above it.
    pub tilt_rad: [f64; 2],
    /// Contact force on the wall, N.
    pub push_N: [f64; 2],
    /// Bending moment, N·m, towards the centre of curvature.
    pub moment_N_m: [f64; 2],
    /// Effective tension, N.
    pub tension_N: f64,
    /// Torque, N·m.
    pub torque_N_m: f64,
    /// Largest bending stress from here to the next node below, Pa.
    pub bending_stress_Pa: f64,
    /// Largest von Mises stress there, Pa.
    pub von_mises_stress_Pa: f64,
}

impl AssemblyNode {
    /// Size of the bending moment, N·m.
    pub fn bending_moment_N_m(&self) -> f64 {
        libm::hypot(self.moment_N_m[0], self.moment_N_m[1])
    }
}

/// The largest value of something, and where.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Largest {
    /// The value, SI.
    pub value: f64,
    /// Distance from the bit, m.
    pub from_bit_m: f64,
}

impl Largest {
    pub(super) fn of(nodes: &[AssemblyNode], value: impl Fn(&AssemblyNode) -> f64) -> Self {
        nodes.iter().fold(Self::default(), |most, node| {
            let here = value(node);
            if here > most.value { Self { value: here, from_bit_m: node.from_bit_m } } else { most }
        })
    }
}

/// The nodes of the solved part, from the bit up. `places` are their distances from the bit, m, and
/// the components that touch there, from the top down.
pub(super) fn nodes(
    model: &Model,
    profile: &StiffProfile,
    places: &[(f64, usize)],
) -> Vec<AssemblyNode> {
    let axis = &profile.axis;
    let node = |index: usize| AssemblyNode {
        md_m: profile.md_m[index],
        from_bit_m: places[index].0,
        component: model.string.component_at(places[index].0).0,
        touching: places[index].1,
        hole_radius_m: axis.hole_radius_m[index],
        offset_m: axis.offset_m[index],
        tilt_rad: axis.tilt_rad[index],
        push_N: axis.push_N[index],
        moment_N_m: axis.moment_N_m[index],
        tension_N: profile.tension_N[index],
        torque_N_m: profile.torque_N_m[index],
        bending_stress_Pa: profile.bending_stress_Pa[index],
        von_mises_stress_Pa: profile.von_mises_stress_Pa[index],
    };
    (0..places.len()).rev().map(node).collect()
}
