//! Depths at which the string changes from tension to compression and from the high side to the low
//! one, while it moves.

use serde::{Deserialize, Serialize};

use crate::{
    dynamics::{boundary::anchor::Anchor, kernel::chain::Chain},
    outcome,
    rod::{contact_length, mesh::Mesh},
    simd::number::Real,
    well::Path,
};

/// Time over which the side of the contacts is averaged, s. A shorter one sees impacts.
const SIDE_S: f64 = 1.0;

/// The sides on which the nodes have lain since the last sample.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Sides {
    /// Sums of the signed contact forces at that look, N.
    before: Vec<f64>,
    samples: u64,
}

impl Sides {
    /// Whether they are of so many nodes.
    pub(super) fn is_of(&self, nodes: usize) -> bool {
        self.before.len() == nodes
    }

    pub(super) fn new(nodes: usize) -> Self {
        Self { before: vec![0.0; nodes], samples: 0 }
    }

    /// The sums begin anew.
    pub(super) fn restart(&mut self) {
        self.before.fill(0.0);
        self.samples = 0;
    }

    /// Counts a sample; whether a second has passed since the last sample.
    pub(super) fn is_due(&mut self, sample_interval_s: f64) -> bool {
        self.samples += 1;
        let due = (self.samples as f64 + 0.5) * sample_interval_s >= SIDE_S;
        if due {
            self.samples = 0;
        }
        due
    }

    /// Measured depth at which the side force changed from the high to the low side since the last
    /// sample, m. `sum` is that of a node's signed contact force, N.
    pub(super) fn cutoff_depth_m(
        &mut self,
        mesh: &Mesh,
        path: &Path,
        anchors: &[Anchor],
        sum: impl Fn(usize) -> f64,
    ) -> Option<f64> {
        let signed: Vec<f64> = (0..mesh.nodes.len())
            .map(|i| {
                let sum = sum(i);
                sum - std::mem::replace(&mut self.before[i], sum)
            })
            .collect();
        let contact_spans = contact_length::contact_spans(mesh, |i| signed[i] != 0.0);
        let side_force = contact_length::spread(&contact_spans, signed.len(), |i| signed[i]);
        let md_m: Vec<f64> = anchors.iter().map(|a| a.md_m).collect();
        let bit_depth_m = anchors.last()?.md_m;
        outcome::cutoff_in_build_m(path, bit_depth_m, &md_m, &side_force)
    }
}

/// Measured depth of the shallowest zero of effective tension, m: between the middles of elements.
/// The largest magnitude of the tension is `largest_N`.
pub fn neutral_point_m(
    chain: &Chain<impl Real>,
    anchors: &[Anchor],
    largest_N: f64,
) -> Option<f64> {
    let md_m = |i: usize| {
        let along = |i: usize| chain.displacement(i).dot(chain.tangent(i));
        0.5 * (anchors[i].md_m + along(i) + anchors[i + 1].md_m + along(i + 1))
    };
    // Pieces that hang from the top have none; the last of them may end just above it.
    let hanging = chain.lanes_above_N(outcome::SLACK * largest_N);
    let tensions_N = chain.tensions_N(hanging.saturating_sub(1));
    outcome::neutral_point_among(tensions_N, largest_N, md_m)
}
