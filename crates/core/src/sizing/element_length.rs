//! How long the elements of a run are.

use serde::{Deserialize, Serialize};

/// How long the elements of a run are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum ElementLength {
    /// About so long everywhere, m.
    Uniform(f64),
    /// As long as the answer allows: from joint to joint, finer where something asks for it.
    Auto(Accuracy),
}

/// How accurate a mesh that chooses itself is to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Accuracy {
    /// From joint to joint, the assembly too: for sweeps and for what comes at many times real
    /// time.
    Coarse,
    /// From joint to joint where pipe hangs or lies between its joints, the assembly in elements of
    /// 3 m.
    #[default]
    Standard,
    /// Half of the standard elements, everywhere.
    Fine,
}

impl Default for ElementLength {
    /// Of the length that the string asks for, standard accuracy.
    fn default() -> Self {
        Self::Auto(Accuracy::default())
    }
}
