//! Drilling fluid: what it weighs, how it flows, and what it does to a pipe that moves in it.

pub mod annulus;
pub mod bore;
pub mod hydraulics;
pub mod rheology;
mod turbulence;

pub use annulus::{Annulus, AnnulusDrag, Motion};
pub use hydraulics::Hydraulics;
pub use rheology::Rheology;

/// Drilling fluid that fills the string and the annulus.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Mud {
    /// Density, kg/m³; zero means air.
    pub density_kg_per_m3: f64,
    /// Linear lateral drag: force per length per lateral speed, Pa·s.
    pub linear_drag_Pa_s: f64,
    /// Quadratic lateral drag coefficient `C_d` of a cylinder on its outside diameter.
    pub drag_coefficient: f64,
    /// How it flows; without it the mud drags neither along the string nor around it, and circulates
    /// without loss.
    pub rheology: Option<Rheology>,
}
