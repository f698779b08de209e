//! Contact over depth and time, as coarse as a picture of it needs: memory does not grow with the run.

use serde::{Deserialize, Serialize};

use super::Record;
use crate::{
    dynamics::{assembly::Anchor, outcome::ContactMap},
    rod::mesh::Mesh,
};

/// Rows in time, at most one more where the window begins between two.
const MOST_ROWS: u64 = 200;

/// Stretches of string in a row, at most.
const MOST_STRETCHES: usize = 200;

/// Neighbouring nodes and the string that they stand for.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Stretch {
    first: usize,
    last: usize,
    length_m: f64,
}

/// The map so far, and what the sums were when its last row was closed.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct MapKeeper {
    stretches: Vec<Stretch>,
    /// Sums of the signed contact force over the samples, N, and of its magnitude.
    before: Vec<[f64; 2]>,
    samples: u64,
    map: ContactMap,
}

impl MapKeeper {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let nodes = mesh.nodes.len();
        let many = nodes.div_ceil(MOST_STRETCHES);
        let border = |upper: usize, lower: usize| {
            0.5 * (mesh.nodes[upper].from_bit_m + mesh.nodes[lower].from_bit_m)
        };
        let stretches: Vec<Stretch> = (0..nodes)
            .step_by(many)
            .map(|first| {
                let last = (first + many).min(nodes) - 1;
                let top_m = border(first.saturating_sub(1), first);
                let bottom_m = border(last, (last + 1).min(nodes - 1));
                Stretch {
                    first,
                    last,
                    length_m: top_m - bottom_m,
                }
            })
            .collect();
        Self {
            before: vec![[0.0; 2]; stretches.len()],
            stretches,
            samples: 0,
            map: ContactMap::default(),
        }
    }

    /// The sums begin anew.
    pub(super) fn restart(&mut self) {
        self.before.fill([0.0; 2]);
    }
}

impl Record {
    /// Counts a sample of a run that takes `run_samples`, and closes a row of the map where one is full.
    pub fn map_contact(&mut self, anchors: &[Anchor], time_s: f64, run_samples: u64) {
        self.contact.samples += 1;
        if self.contact.samples >= run_samples.div_ceil(MOST_ROWS).max(1) {
            self.close_contact_row(anchors, time_s);
        }
    }

    /// Closes a row of the map with the samples since the last one, if there are any.
    pub fn close_contact_row(&mut self, anchors: &[Anchor], time_s: f64) {
        let samples = std::mem::take(&mut self.contact.samples) as f64;
        if samples == 0.0 {
            return;
        }
        for index in 0..self.contact.stretches.len() {
            let Stretch {
                first,
                last,
                length_m,
            } = self.contact.stretches[index];
            let sums = [
                (first..=last).map(|i| self.sum_of(i, |s| &s.signed)).sum(),
                (first..=last)
                    .map(|i| self.sum_of(i, |s| &s.normal[0]))
                    .sum(),
            ];
            let before = std::mem::replace(&mut self.contact.before[index], sums);
            let per_metre = |k: usize| (sums[k] - before[k]) / (samples * length_m);
            let map = &mut self.contact.map;
            map.time_s.push(time_s);
            map.md_m
                .push(0.5 * (anchors[first].md_m + anchors[last].md_m));
            map.side_force_N_per_m.push(per_metre(0));
            map.contact_force_N_per_m.push(per_metre(1));
        }
    }

    /// The map so far.
    pub fn contact_map(&self) -> &ContactMap {
        &self.contact.map
    }
}
