//! Settings of the soft string's integration.

use serde::Serialize;

/// Settings of the soft string's integration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SoftSettings {
    /// Longest step along the hole, m, from 0.05 to 100. Steps also end at survey stations, at the
    /// ends of a spline's transitions, of components and of hole sections. The rows of the profile
    /// are the steps' ends.
    ///
    /// Default 1 m. The method is of fourth order. Where the pipe changes sides `|q|` has a kink:
    /// a step there is halved until 2e-8 N are left, so that no force depends on where steps fall.
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
