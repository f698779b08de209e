//! Elements cut in two.

use super::{Mesh, MeshElement, MeshNode, marks::radius_between_m};
use crate::{rod::section::Section, sizing::SizeReason, string::DrillString};

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
