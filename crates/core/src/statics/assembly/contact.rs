//! Contacts of the assembly.

use serde::{Deserialize, Serialize};

use super::axis::AssemblyNode;
use crate::string::{Component, DrillString};

/// Touching part of the string.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Touching {
    /// The bit.
    Bit,
    /// Blades.
    Blades,
    /// A tool joint.
    Joint,
    /// A body.
    Body,
}

impl Touching {
    /// As people call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bit => "bit",
            Self::Blades => "blades",
            Self::Joint => "joint",
            Self::Body => "body",
        }
    }
}

/// A place where the string presses on its hole: one node, or a stretch of neighbours of a
/// component.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// The touching part.
    pub touching: Touching,
    /// Component, counted from the bit.
    pub component: usize,
    /// Its name.
    pub name: String,
    /// Measured depth of the middle of its force, m.
    pub md_m: f64,
    /// Lower and upper end, from the bit, m.
    pub from_bit_m: [f64; 2],
    /// Force on the wall, N, towards the high side and to the right.
    pub force_N: [f64; 2],
    /// Its direction: angle from the high side, clockwise as one looks down the hole, rad, 0 to 2π.
    pub side_rad: f64,
}

impl Contact {
    /// Size of the force, N.
    pub fn size_N(&self) -> f64 {
        libm::hypot(self.force_N[0], self.force_N[1])
    }

    /// Whether a force presses the same side of the hole.
    fn same_side(&self, force_N: &[f64; 2]) -> bool {
        self.force_N[0] * force_N[0] + self.force_N[1] * force_N[1] > 0.0
    }

    fn begin(string: &DrillString, node: &AssemblyNode, touching: Touching) -> Self {
        Self {
            touching,
            component: node.touching,
            name: string.components()[node.touching].name.clone(),
            md_m: node.md_m,
            from_bit_m: [node.from_bit_m; 2],
            force_N: node.push_N,
            side_rad: 0.0,
        }
    }
}

/// Returns the part that touches at a node of a component.
fn touching(component: &Component, index: usize) -> Touching {
    match component {
        _ if index == 0 => Touching::Bit,
        Component { blades: Some(_), .. } => Touching::Blades,
        Component { joints: Some(_), .. } => Touching::Joint,
        _ => Touching::Body,
    }
}

/// The contacts of nodes, ordered from the bit up: the bit first, whether in contact or not.
pub(super) fn contacts(string: &DrillString, nodes: &[AssemblyNode]) -> Vec<Contact> {
    let mut contacts: Vec<Contact> = Vec::new();
    // Of the last contact, where its stretch ended: only the next node may lengthen it.
    let mut last_node = 0;
    for (index, node) in nodes.iter().enumerate() {
        let force_N = libm::hypot(node.push_N[0], node.push_N[1]);
        if index > 0 && force_N <= 0.0 {
            continue;
        }
        let part = touching(&string.components()[node.touching], index);
        match contacts.last_mut() {
            Some(last)
                if last.component == node.touching
                    && last.touching == part
                    && last.same_side(&node.push_N)
                    && (part == Touching::Blades
                        || last_node + 1 == index && part == Touching::Body) =>
            {
                let before_N = last.size_N();
                last.md_m = (last.md_m * before_N + node.md_m * force_N) / (before_N + force_N);
                last.from_bit_m[1] = node.from_bit_m;
                last.force_N[0] += node.push_N[0];
                last.force_N[1] += node.push_N[1];
            }
            _ => contacts.push(Contact::begin(string, node, part)),
        }
        last_node = index;
    }
    for contact in &mut contacts {
        let [high_N, right_N] = contact.force_N;
        contact.side_rad = libm::atan2(right_N, high_N).rem_euclid(std::f64::consts::TAU);
    }
    contacts
}

/// Ends of the contacts of bodies, from the bit, m: half-way to the node that is free. Those of the
/// assembly, up to `to_m`, and the first above it: the touch-down point sets the length that hangs
/// free above the highest blades.
pub(super) fn ends_m(string: &DrillString, nodes: &[AssemblyNode], to_m: f64) -> Vec<f64> {
    let on = |node: &AssemblyNode| node.push_N != [0.0; 2];
    let is_body = |node: &AssemblyNode| {
        let component = &string.components()[node.touching];
        component.blades.is_none() && component.joints.is_none()
    };
    let pairs = nodes.windows(2).skip(1);
    let pairs = pairs.filter(|pair| on(&pair[0]) != on(&pair[1]));
    let bodies = pairs.filter(|pair| pair.iter().any(|node| on(node) && is_body(node)));
    let mut ends_m: Vec<f64> =
        bodies.map(|pair| 0.5 * (pair[0].from_bit_m + pair[1].from_bit_m)).collect();
    let above = ends_m.partition_point(|end_m| *end_m <= to_m);
    ends_m.truncate(above + 1);
    ends_m
}
