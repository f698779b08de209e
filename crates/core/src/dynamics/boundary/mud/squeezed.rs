//! Shortening of the string by the pressures and the temperature of the fluids at rest.

use serde::{Deserialize, Serialize};

use crate::{
    dynamics::boundary::anchor::Anchor,
    model::Model,
    mud::MudColumn,
    rod::{
        in_fluid::{HolePlace, free_elongation_m},
        mesh::{Mesh, MeshElement},
    },
};

/// Shortening of each element at rest without effective tension against its length at the surface.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::dynamics) struct Squeezed {
    /// From the top down, m.
    pub(in crate::dynamics) each_m: Vec<f64>,
    /// Their sum, m.
    pub(in crate::dynamics) total_m: f64,
}

impl Squeezed {
    /// Of a string with these anchors.
    pub(in crate::dynamics) fn of(
        model: &Model,
        mesh: &Mesh,
        mud: &MudColumn,
        anchors: &[Anchor],
    ) -> Self {
        let squeeze = |(i, e): (usize, &MeshElement)| {
            let ends = [&anchors[i], &anchors[i + 1]]
                .map(|anchor| HolePlace { md_m: anchor.md_m, tvd_m: anchor.position_m.z });
            let element = (e, [&mesh.nodes[i], &mesh.nodes[i + 1]]);
            -free_elongation_m(&model.string, mud, element, ends, e.length_m)
        };
        let each_m: Vec<f64> = mesh.elements.iter().enumerate().map(squeeze).collect();
        Self { total_m: each_m.iter().sum(), each_m }
    }
}
