//! Densities of the fluids on both sides of the pipe's wall.

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

    /// Density inside over the [largest](super::FluidColumn::densest) of the column, kg/m³; one where
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
