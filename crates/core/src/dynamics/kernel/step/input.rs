//! Inputs that are the same for all nodes in a step.

/// Inputs that are the same for all nodes in a step.
#[derive(Debug, Clone, Copy)]
pub struct StepInput {
    /// Step, s.
    pub dt: f64,
    /// Stiffness-proportional damping, s.
    pub stiffness_damping: f64,
    /// Hunt-Crossley dissipation of the Hertz law, s/m.
    pub dissipation: f64,
    /// Sliding speed at which the friction at rest has half decayed to the kinetic one, m/s.
    pub stribeck_speed: f64,
}
