//! Division of the string into elements, and into regions with different time steps.

use serde::Serialize;

use crate::sizing::{Accuracy, ElementLength};

/// Whether parts of the string have steps of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum Regions {
    /// One step for the whole string.
    #[default]
    One,
    /// Two regions where that takes less time: the bottom-hole assembly, meshed finer than the
    /// pipe, takes several steps in one of the pipe (multirate time stepping, subcycling).
    Auto,
}

/// Division of the string into elements, and into regions with different time steps.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MeshSettings {
    /// Length of the elements. There is a node at every tool joint and stabiliser; between them the
    /// elements are as near to this as whole numbers allow, rather longer than shorter.
    pub element_length: ElementLength,
    /// Divisor of every length, given or chosen: 1, and more for convergence studies.
    pub refinement: u32,
    /// Whether parts of the string have steps of their own.
    pub regions: Regions,
}

impl MeshSettings {
    /// Elements of about the same length everywhere, m, and one step for all of them.
    pub fn uniform(element_length_m: f64) -> Self {
        Self {
            element_length: ElementLength::Uniform(element_length_m),
            refinement: 1,
            regions: Regions::One,
        }
    }

    /// Elements that choose their length, in regions where that takes less time.
    pub fn auto(accuracy: Accuracy) -> Self {
        Self {
            element_length: ElementLength::Auto(accuracy),
            refinement: 1,
            regions: Regions::Auto,
        }
    }
}

impl Default for MeshSettings {
    /// Elements that choose their length, of the standard accuracy.
    fn default() -> Self {
        Self::auto(Accuracy::default())
    }
}
