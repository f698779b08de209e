//! How the soft string is integrated.

/// How the soft string is integrated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoftSettings {
    /// Longest step along the hole, m, from 0.05 to 100. Steps also end at survey stations, at the
    /// ends of components and at those of hole sections. The rows of the profile are the steps'
    /// ends.
    ///
    /// Default 1 m. The method is of fourth order, but where the pipe changes sides `|q|` has a
    /// kink that costs `μ |dq/ds| step²`: at 1 m less than a newton, 1e-6 of a hook load.
    pub step_m: f64,
}

impl Default for SoftSettings {
    fn default() -> Self {
        Self { step_m: 1.0 }
    }
}
