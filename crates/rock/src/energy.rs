//! Sources and sinks of the energy of a block.

use serde::{Deserialize, Serialize};

/// Energies of a block, J.
///
/// The stored energy is that at the middle between the last step and the next, where the velocities
/// are defined; positions are advanced by half a step, so that the sums are second-order accurate
/// in the step.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    /// In motion.
    pub kinetic_J: f64,
    /// In stress.
    pub elastic_J: f64,
    /// In hourglasses.
    pub hourglass_J: f64,
    /// Gone with plastic flow.
    pub plastic_J: f64,
    /// Gone to viscosity.
    pub viscous_J: f64,
    /// Gone out of open faces.
    pub absorbed_J: f64,
    /// Gone with removed elements.
    pub removed_J: f64,
    /// Supplied by external forces.
    pub pushed_J: f64,
    /// Given by held nodes and the rock beyond open faces.
    pub edges_J: f64,
    /// Given by the pressure of the filling.
    pub pressure_J: f64,
    /// Given with the elements that the block began with or got since.
    pub entered_J: f64,
}

impl Energies {
    /// Energy stored in the block.
    pub fn held_J(&self) -> f64 {
        self.kinetic_J + self.elastic_J + self.hourglass_J
    }

    /// Energy that has left the block.
    pub fn lost_J(&self) -> f64 {
        self.plastic_J + self.viscous_J + self.absorbed_J + self.removed_J
    }

    /// Energy supplied to the block.
    pub fn given_J(&self) -> f64 {
        self.pushed_J + self.edges_J + self.pressure_J + self.entered_J
    }

    /// Residual of the energy balance.
    pub fn residual_J(&self) -> f64 {
        self.held_J() + self.lost_J() - self.given_J()
    }

    /// Kinetic energy over the energy that deformation took: small where inertia does not matter,
    /// and the density may be scaled.
    pub fn kinetic_fraction(&self) -> f64 {
        let deformation =
            self.elastic_J + self.hourglass_J - self.entered_J + self.plastic_J + self.removed_J;
        self.kinetic_J / deformation.abs().max(f64::MIN_POSITIVE)
    }
}
