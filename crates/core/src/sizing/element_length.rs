//! Length of the elements of a run.

use serde::{Deserialize, Serialize};

/// Length of the elements of a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum ElementLength {
    /// About so long everywhere, m.
    Uniform(f64),
    /// As long as the required accuracy allows: from joint to joint, finer where needed.
    Auto(Accuracy),
}

/// Accuracy of a mesh with automatic lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Accuracy {
    /// From joint to joint, the assembly too: for sweeps and for runs at many times real time.
    Coarse,
    /// From joint to joint where pipe hangs or rests on its joints, the assembly in elements of 3
    /// m.
    #[default]
    Standard,
    /// Half of the standard elements, everywhere.
    Fine,
}

impl Default for ElementLength {
    /// Automatic length, standard accuracy.
    fn default() -> Self {
        Self::Auto(Accuracy::default())
    }
}
