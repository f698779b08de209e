//! Drilling fluid: its density, its rheology, and its effect on a moving pipe.

pub mod annulus;
pub mod bore;
mod column;
mod conduit;
pub mod gel;
pub mod hydraulics;
pub mod rheology;
mod rheometer;
mod turbulence;

pub use annulus::{Annulus, AnnulusDrag, Motion};
pub use column::{
    ColumnLayers, FluidColumn, FluidInterval, FluidLayer, Fluids, FluidsError, MudColumn,
};
pub(crate) use conduit::Conduit;
pub use gel::AnnulusGel;
pub use hydraulics::Hydraulics;
pub use rheology::Rheology;
pub use rheometer::{DIAL_PA, DialFit, DialReading, fit_dial_readings};

/// Lateral drag coefficient `C_d` of a pipe by default: that of a smooth cylinder across a stream
/// at Reynolds numbers from 1e3 to 1e5.
pub const CYLINDER_DRAG_COEFFICIENT: f64 = 1.0;

/// Drilling fluid that fills the string and the annulus.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Mud {
    /// Density, kg/m³; zero means air.
    pub density_kg_per_m3: f64,
    /// Linear lateral drag: force per length per lateral speed, Pa·s.
    pub linear_drag_Pa_s: f64,
    /// Quadratic lateral drag coefficient `C_d` of a cylinder on its outside diameter.
    pub drag_coefficient: f64,
    /// Rheology; without it the mud drags neither along the string nor around it, and circulates
    /// without loss.
    pub rheology: Option<Rheology>,
}

impl Mud {
    /// Mud of a density, kg/m³, that brakes lateral motion as it does that of a smooth cylinder and
    /// has no rheology: neither viscous drag along the string nor pressure losses.
    pub const fn of_density(density_kg_per_m3: f64) -> Self {
        Self {
            density_kg_per_m3,
            linear_drag_Pa_s: 0.0,
            drag_coefficient: CYLINDER_DRAG_COEFFICIENT,
            rheology: None,
        }
    }

    /// Upward thrust of the bit's jets on the string, N: `ρ Q u` with the jet's speed
    /// `u = √(2 Δp/ρ)`; none without a rheology.
    ///
    /// Momentum about the bit leaves nothing else of the nozzles' pressure drop in the effective
    /// tension: the pressure that acts on the bit from inside is the one that effective tension
    /// takes away from real tension.
    pub fn jet_thrust_N(&self, flow_m3_per_s: f64, bit_loss_Pa: f64) -> f64 {
        match self.rheology {
            Some(_) => flow_m3_per_s * (2.0 * self.density_kg_per_m3 * bit_loss_Pa).sqrt(),
            None => 0.0,
        }
    }
}

// Densities of the fluids on both sides of the pipe's wall.

/// Densities of the fluids inside the string and around it at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Densities {
    /// Density inside, kg/m³.
    pub inside_kg_per_m3: f64,
    /// Density in the annulus, kg/m³.
    pub annulus_kg_per_m3: f64,
}

impl Densities {
    /// The same fluid on both sides.
    pub const fn uniform(kg_per_m3: f64) -> Self {
        Self { inside_kg_per_m3: kg_per_m3, annulus_kg_per_m3: kg_per_m3 }
    }

    /// Density inside over the [largest](FluidColumn::densest) of the column, kg/m³; one where
    /// there is nothing but air.
    pub(crate) fn inside_over(&self, kg_per_m3: f64) -> f64 {
        if self.inside_kg_per_m3 == kg_per_m3 { 1.0 } else { self.inside_kg_per_m3 / kg_per_m3 }
    }

    /// Mass of the fluid inside beyond that of the annulus's fluid in the same bore, kg/m; zero
    /// where both are the same. It is what the two sides add to a weight in the annulus's fluid.
    pub fn excess_kg_per_m(&self, bore_m2: f64) -> f64 {
        (self.inside_kg_per_m3 - self.annulus_kg_per_m3) * bore_m2
    }
}
