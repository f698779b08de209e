//! How the soft string is integrated.

use serde::Serialize;

/// How the soft string is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SoftSettings {
    /// Longest step along the hole, m, from 0.05 to 100. Steps also end at survey stations, at the
    /// ends of components and at those of hole sections. The rows of the profile are the steps'
    /// ends.
    ///
    /// Default 1 m. The method is of fourth order, but where the pipe changes sides `|q|` has a
    /// kink that costs `μ |dq/ds| step²`: at 1 m less than a newton, 1e-6 of a hook load.
    pub step_m: f64,
    /// Whether a string that is a helix by [`Model::buckling`](crate::model::Model::buckling) is
    /// pressed to the wall by that too, `r F²/(4 EI)` more per metre (Mitchell 1986), and rubs so
    /// much more. Default no.
    pub helix_side_force: bool,
}

impl Default for SoftSettings {
    fn default() -> Self {
        Self { step_m: 1.0, helix_side_force: false }
    }
}
