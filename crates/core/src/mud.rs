//! Drilling fluid.

/// Drilling fluid that fills the string and the annulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mud {
    /// Density, kg/m³; zero means air.
    pub density_kg_per_m3: f64,
    /// Linear lateral drag: force per length per lateral speed, Pa·s.
    pub linear_drag_Pa_s: f64,
    /// Quadratic lateral drag coefficient `C_d` of a cylinder on its outside diameter.
    pub drag_coefficient: f64,
}
