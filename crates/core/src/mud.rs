//! Drilling fluid.

/// Drilling fluid that fills the string and the annulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mud {
    /// Density, kg/m³; zero means air.
    pub density_kg_per_m3: f64,
}
