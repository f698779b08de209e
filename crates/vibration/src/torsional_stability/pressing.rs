//! Contact forces of the string on the wall while it drills under a weight.

use wholestring::{
    dynamics::DynamicsSettings,
    model::Model,
    operation::Operation,
    rod::mesh::Mesh,
    statics::{
        soft::{SoftError, soft_string},
        stiff,
    },
};

/// Method that provided the contact of the string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LiesBy {
    /// The stiff string.
    Stiff,
    /// The soft string: the stiff one found no equilibrium.
    Soft,
}

impl LiesBy {
    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stiff => "stiff",
            Self::Soft => "soft",
        }
    }
}

/// Contact forces of a string that turns and drills.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pressing {
    /// At each node of the mesh, N.
    pub(super) contact_force_N: Vec<f64>,
    /// Torque at the top, N·m.
    pub(super) surface_torque_N_m: f64,
    pub(super) by: LiesBy,
}

impl Pressing {
    /// By the stiff string, or the soft one where that finds no equilibrium.
    pub(super) fn new(
        model: &Model,
        mesh: &Mesh,
        settings: &DynamicsSettings,
        operation: &Operation,
    ) -> Result<Self, SoftError> {
        if let Ok(found) = stiff::solve(model, operation, &settings.stiff_string()) {
            let places = found.md_m.iter().zip(&found.contact_force_N);
            return Ok(Self {
                contact_force_N: on_nodes(mesh, operation.bit_depth_m, places),
                surface_torque_N_m: found.scalars.surface_torque_N_m,
                by: LiesBy::Stiff,
            });
        }
        let found = soft_string(model, operation)?;
        let md_m = &found.md_m;
        let last = md_m.len() - 1;
        let forces: Vec<f64> = (0..=last)
            .map(|i| {
                let length_m = 0.5 * (md_m[(i + 1).min(last)] - md_m[i.saturating_sub(1)]);
                found.side_force_N_per_m[i].abs() * length_m
            })
            .collect();
        Ok(Self {
            contact_force_N: on_nodes(mesh, operation.bit_depth_m, md_m.iter().zip(&forces)),
            surface_torque_N_m: found.scalars.surface_torque_N_m,
            by: LiesBy::Soft,
        })
    }
}

/// Forces at measured depths, each at the nearest node between the ends.
fn on_nodes<'a>(
    mesh: &Mesh,
    bit_depth_m: f64,
    forces: impl Iterator<Item = (&'a f64, &'a f64)>,
) -> Vec<f64> {
    let mut on = vec![0.0; mesh.nodes.len()];
    for (md_m, force_N) in forces {
        let node = mesh.nearest_node(bit_depth_m - md_m);
        if (1..mesh.nodes.len() - 1).contains(&node) {
            on[node] += force_N;
        }
    }
    on
}
