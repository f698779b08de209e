//! Elements of the string in the fluids around them: their weight, and their length at rest without
//! effective tension.
//!
//! An element may span several components and a boundary between two fluids. Its weight and its
//! strain are then the sums over its pieces of one component in one fluid on each side, so that
//! neither depends on where the mesh has its nodes.

use super::mesh::{Mesh, MeshElement, MeshNode};
use crate::{
    model::Model,
    mud::{Densities, MudColumn},
    string::{DrillString, FreeStrain},
};

/// Weight of an element and the fluids around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementInFluid {
    /// Weight that effective tension balances, N/m.
    pub weight_N_per_m: f64,
    /// Mean densities over its length.
    pub densities: Densities,
}

/// The elements of a mesh in the fluids of a model, from the top down.
pub fn along(model: &Model, mesh: &Mesh) -> Vec<ElementInFluid> {
    let column = model.mud_column();
    let bit_depth_m = model.string.length_m();
    let element = |(element, nodes): (&MeshElement, &[MeshNode])| {
        let [upper_m, lower_m] = [&nodes[0], &nodes[1]].map(|node| bit_depth_m - node.from_bit_m);
        let densities = column.mean_densities([upper_m, lower_m]);
        let weight_N_per_m = match column.is_uniform() {
            true => element.section.buoyed_weight_N_per_m(densities.annulus_kg_per_m3),
            false => weight_N_per_m(&model.string, &column, [upper_m, lower_m]),
        };
        ElementInFluid { weight_N_per_m, densities }
    };
    mesh.elements.iter().zip(mesh.nodes.windows(2)).map(element).collect()
}

/// Mean weight of the string between two measured depths, N/m.
fn weight_N_per_m(string: &DrillString, column: &MudColumn, [from_m, to_m]: [f64; 2]) -> f64 {
    let bit_depth_m = string.length_m();
    let mut lower_m = to_m;
    let weights =
        string.parts_between(bit_depth_m - to_m, bit_depth_m - from_m).map(|(component, part)| {
            let upper_m = lower_m - part * (to_m - from_m);
            let densities = column.mean_densities([upper_m, lower_m]);
            lower_m = upper_m;
            part * component.weight_in_N_per_m(densities)
        });
    weights.sum()
}

/// A place in the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HolePlace {
    /// Measured depth, m.
    pub md_m: f64,
    /// True vertical depth, m.
    pub tvd_m: f64,
}

impl HolePlace {
    /// The place at a part of the way to another.
    fn towards(self, other: Self, part: f64) -> Self {
        let Self { md_m, tvd_m } = self;
        Self {
            md_m: md_m + part * (other.md_m - md_m),
            tvd_m: tvd_m + part * (other.tvd_m - tvd_m),
        }
    }
}

/// Elongation of `length_m` of an element at rest without effective tension, m; its mean strain for
/// a length of 1. The element is between two nodes, whose places are given, the upper one first.
pub fn free_elongation_m(
    string: &DrillString,
    column: &MudColumn,
    (element, nodes): (&MeshElement, [&MeshNode; 2]),
    [upper, lower]: [HolePlace; 2],
    length_m: f64,
) -> f64 {
    if column.is_uniform() {
        let [md_m, tvd_m] =
            [[upper.md_m, lower.md_m], [upper.tvd_m, lower.tvd_m]].map(|[a, b]| 0.5 * (a + b));
        let around = column.surroundings_at(md_m, tvd_m);
        return element.section.free_strain().over(length_m).strain(&around);
    }
    let boundaries_m = column.boundaries_between([upper.md_m, lower.md_m]);
    let span_m = lower.md_m - upper.md_m;
    let mut below = 0.0;
    let mut sum = 0.0;
    for (component, part) in string.parts_between(nodes[1].from_bit_m, nodes[0].from_bit_m) {
        let law = FreeStrain::of(component).over(length_m);
        let top = below + part;
        let cuts = boundaries_m.iter().rev().map(|md_m| (lower.md_m - md_m) / span_m);
        for cut in cuts.filter(|cut| *cut > below && *cut < top).chain([top]).collect::<Vec<_>>() {
            let middle = lower.towards(upper, 0.5 * (below + cut));
            let around = column.surroundings_at(middle.md_m, middle.tvd_m);
            sum += (cut - below) * law.strain(&around);
            below = cut;
        }
    }
    sum
}
