//! Positions of the nodes.

mod cut;
mod marks;

pub use marks::MeshNode;

use self::marks::{BLADE_HEIGHT_M, radius_between_m};
use super::section::Section;
use crate::{
    sizing::{SizeReason, Sizing},
    string::{Component, DrillString},
};

/// An element between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshElement {
    /// Length of the unloaded element, m.
    pub length_m: f64,
    /// Its mean section.
    pub section: Section,
    /// Reason for its length; nodes at mandatory positions make it shorter.
    pub reason: SizeReason,
}

/// The string cut into elements, from the surface down to the bit: node 0 is the top, the last node
/// the bit, element `i` is between nodes `i` and `i + 1`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Nodes, one more than elements.
    pub nodes: Vec<MeshNode>,
    /// Elements.
    pub elements: Vec<MeshElement>,
}

impl Mesh {
    /// Cuts `string` into elements of about the lengths of `sizing`, with a node at the bit, at the
    /// top, on every stabiliser, at every bend of a body, at every lateral force and on the tool
    /// joints.
    ///
    /// Elements are between 0.8 and 1.25 of those lengths wherever only tool joints restrict them:
    /// a joint that would leave a shorter element is replaced by nodes at equal distances. Only
    /// ends, stabilisers, bends and lateral forces make shorter ones.
    ///
    /// Blades touch at both edges where they are longer than half a metre and half an element, so
    /// that a stabiliser resists tilting in its hole; shorter ones touch at their middle.
    pub fn new(string: &DrillString, sizing: &Sizing) -> Self {
        let mut nodes = cut::nodes(string, marks::of(string, sizing), sizing);
        nodes.reverse();
        let elements = nodes
            .windows(2)
            .map(|pair| {
                let (top_m, bottom_m) = (pair[0].from_bit_m, pair[1].from_bit_m);
                MeshElement {
                    length_m: top_m - bottom_m,
                    section: Section::between(string, bottom_m, top_m),
                    reason: sizing.at(0.5 * (top_m + bottom_m)).reason,
                }
            })
            .collect();
        Self { nodes, elements }
    }

    /// Cuts `string` into elements of about `element_length_m` everywhere.
    pub fn uniform(string: &DrillString, element_length_m: f64) -> Self {
        Self::new(string, &Sizing::uniform(element_length_m))
    }

    /// Its lower end: the elements that reach no farther from the bit than this, m, two at least.
    #[must_use]
    pub fn lower_end(mut self, length_m: f64) -> Self {
        let beyond = self.nodes.partition_point(|node| node.from_bit_m > length_m);
        let removed = beyond.min(self.elements.len().saturating_sub(2));
        self.nodes.drain(..removed);
        self.elements.drain(..removed);
        self
    }

    /// The node nearest to a place.
    pub fn nearest_node(&self, from_bit_m: f64) -> usize {
        // The distances go down along the nodes.
        let below = self.nodes.partition_point(|n| n.from_bit_m >= from_bit_m);
        let above = below.saturating_sub(1);
        let below = below.min(self.nodes.len() - 1);
        let off = |i: usize| (self.nodes[i].from_bit_m - from_bit_m).abs();
        if off(below) < off(above) { below } else { above }
    }

    /// The node nearest to a place between the ends, the ends left out.
    ///
    /// # Panics
    /// Where the mesh has no node but the ends.
    pub fn nearest_inner_node(&self, from_bit_m: f64) -> usize {
        let off = |i: &usize| (self.nodes[*i].from_bit_m - from_bit_m).abs();
        (1..self.nodes.len() - 1)
            .min_by(|a, b| off(a).total_cmp(&off(b)))
            .expect("bends and lateral forces have a node between the ends")
    }

    /// Period in nodes with which most of the string has a node that is wider than the one below
    /// it, as tool joints are; one where there is no such period.
    pub fn nodes_per_joint(&self) -> usize {
        let stands_out = |pair: &[MeshNode]| {
            pair[0].contact_radius_m > pair[1].contact_radius_m + BLADE_HEIGHT_M
        };
        let pairs = self.nodes.windows(2).enumerate();
        let joints: Vec<usize> = pairs.filter(|(_, p)| stands_out(p)).map(|(i, _)| i).collect();
        let gaps = || joints.windows(2).map(|pair| pair[1] - pair[0]);
        let many = |gap: usize| gaps().filter(|g| *g == gap).count() * gap;
        gaps().find(|gap| 2 * many(*gap) > self.nodes.len()).unwrap_or(1)
    }

    /// The component that touches at a node, counted from the bit.
    pub fn touching_component(&self, string: &DrillString, node: usize) -> usize {
        marks::touching_component(string, &self.nodes[node])
    }

    /// The body with the smallest section modulus within half an element on either side of a node:
    /// the body that governs the stress there.
    pub(crate) fn weakest_body<'a>(&self, string: &'a DrillString, node: usize) -> &'a Component {
        let half = |element: Option<usize>| {
            let element = element.and_then(|index| self.elements.get(index));
            element.map_or(0.0, |element| 0.5 * element.length_m)
        };
        let from_bit_m = self.nodes[node].from_bit_m;
        let (first, lowest) = string.component_at(from_bit_m - half(Some(node)));
        let (last, _) = string.component_at(from_bit_m + half(node.checked_sub(1)));
        let modulus = |component: &&Component| component.section_modulus_m3();
        let bodies = string.components()[first..=last].iter();
        bodies.min_by(|a, b| modulus(a).total_cmp(&modulus(b))).unwrap_or(lowest)
    }

    /// Length of the unloaded string, m.
    pub fn length_m(&self) -> f64 {
        self.nodes[0].from_bit_m
    }

    /// Half of each neighbouring element: the length that a node answers for, m.
    pub fn tributary_length_m(&self, node: usize) -> f64 {
        let above = if node > 0 { self.elements[node - 1].length_m } else { 0.0 };
        let below = self.elements.get(node).map_or(0.0, |e| e.length_m);
        0.5 * (above + below)
    }
}

// Elements cut in two.

impl Mesh {
    /// Cuts elements of `string` in two, from the surface down; the body touches at their middles,
    /// blades only between nodes on blades. Every node stays where it is.
    #[must_use]
    pub fn halved(&self, string: &DrillString, which: &[bool], reason: SizeReason) -> Self {
        let mut nodes = vec![self.nodes[0]];
        let mut elements = Vec::with_capacity(self.elements.len());
        for (index, element) in self.elements.iter().enumerate() {
            let (top, bottom) = (self.nodes[index], self.nodes[index + 1]);
            if which[index] {
                let from_bit_m = 0.5 * (top.from_bit_m + bottom.from_bit_m);
                let contact_radius_m = radius_between_m(string, from_bit_m, [&top, &bottom]);
                let half = |low_m: f64, high_m: f64| MeshElement {
                    length_m: high_m - low_m,
                    section: Section::between(string, low_m, high_m),
                    reason,
                };
                nodes.push(MeshNode { from_bit_m, contact_radius_m });
                elements.push(half(from_bit_m, top.from_bit_m));
                elements.push(half(bottom.from_bit_m, from_bit_m));
            } else {
                elements.push(*element);
            }
            nodes.push(bottom);
        }
        Self { nodes, elements }
    }
}
