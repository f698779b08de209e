//! The compression under which an element buckles between its nodes.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::mesh::Mesh;

/// Euler's load of a pipe that is hinged at both ends of a length, N: `π² EI/L²`.
pub fn own_load_N(bending_stiffness_N_m2: f64, length_m: f64) -> f64 {
    PI * PI * bending_stiffness_N_m2 / (length_m * length_m)
}

/// An element whose compression exceeds its own buckling load: it gives way between its nodes,
/// where no wall holds it, and the string folds there as no pipe does.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BuckledElement {
    /// Measured depth of its middle, m.
    #[serde(with = "crate::finite")]
    pub md_m: f64,
    /// Its length, m.
    #[serde(with = "crate::finite")]
    pub length_m: f64,
    /// Compression on it, N.
    #[serde(with = "crate::finite")]
    pub compression_N: f64,
    /// Compression under which it buckles, N: that of [`own_load_N`].
    #[serde(with = "crate::finite")]
    pub own_load_N: f64,
}

impl BuckledElement {
    /// The element of a mesh whose compression, N, exceeds its own buckling load most; none where
    /// none does. `md_m` is the measured depth of each node, m.
    pub fn most(
        mesh: &Mesh,
        md_m: impl Fn(usize) -> f64,
        compression_N: impl Fn(usize) -> f64,
    ) -> Option<Self> {
        let beyond = mesh.elements.iter().enumerate().filter_map(|(index, element)| {
            let length_m = element.length_m;
            let own_load_N = own_load_N(element.section.bending_stiffness_N_m2, length_m);
            let compression_N = compression_N(index);
            let md_m = 0.5 * (md_m(index) + md_m(index + 1));
            (compression_N > own_load_N).then_some(Self {
                md_m,
                length_m,
                compression_N,
                own_load_N,
            })
        });
        beyond.max_by(|a, b| a.share().total_cmp(&b.share()))
    }

    /// Compression over the element's own buckling load: more than one.
    pub fn share(&self) -> f64 {
        self.compression_N / self.own_load_N
    }

    /// Length of elements that are stable under four times this compression, m: half a wave of the
    /// buckled pipe has three of them.
    pub fn sufficient_length_m(&self) -> f64 {
        0.5 * self.length_m / self.share().sqrt()
    }
}
