//! Shortening of the string by the pressure of the mud at rest.

use serde::{Deserialize, Serialize};

use crate::{
    dynamics::boundary::anchor::Anchor,
    model::MudColumn,
    rod::mesh::{Mesh, MeshElement},
};

/// Shortening of each element by the pressure `p` of mud at rest against the unloaded one, `(1 −
/// 2ν)p/E` of its length.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::dynamics) struct Squeezed {
    /// From the top down, m.
    pub(in crate::dynamics) each_m: Vec<f64>,
    /// Their sum, m.
    pub(in crate::dynamics) total_m: f64,
}

impl Squeezed {
    /// Of a string with these anchors.
    pub(in crate::dynamics) fn of(mesh: &Mesh, mud: MudColumn, anchors: &[Anchor]) -> Self {
        let squeeze = |(i, e): (usize, &MeshElement)| {
            let tvd = 0.5 * (anchors[i].position_m.z + anchors[i + 1].position_m.z);
            e.length_m * e.section.pressure_strain_per_Pa * mud.pressure_Pa(tvd)
        };
        let each_m: Vec<f64> = mesh.elements.iter().enumerate().map(squeeze).collect();
        Self { total_m: each_m.iter().sum(), each_m }
    }
}
