//! Contact over depth and time, as coarse as a picture of it needs: memory does not grow with the
//! run.

use serde::{Deserialize, Serialize};

use crate::{
    damage::{Damaged, ensure},
    dynamics::boundary::anchor::Anchor,
    outcome::ContactMap,
    rod::{
        contact_length::{ContactLength, contact_lengths},
        mesh::Mesh,
    },
};

/// Rows in time, at most one more where the window begins between two.
const MAX_ROWS: u64 = 200;

/// Stretches of string in a row, at most.
const MAX_INTERVALS: usize = 200;

/// Neighbouring nodes and the length of string that they represent.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct MapInterval {
    first: usize,
    last: usize,
    /// Distances of its ends from the bit, m.
    top_m: f64,
    bottom_m: f64,
}

/// The map so far, and the sums at the time when its last row was closed.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct MapKeeper {
    intervals: Vec<MapInterval>,
    /// Distance of each node from the bit, m.
    from_bit_m: Vec<f64>,
    /// Of each node, sums of the signed contact force over the samples, N, and of its magnitude.
    before: Vec<[f64; 2]>,
    samples: u64,
    map: ContactMap,
}

impl MapKeeper {
    /// Whether a stored map is one of so many nodes.
    pub(super) fn check(&self, nodes: usize) -> Result<(), Damaged> {
        let ContactMap { time_s, md_m, side_force_N_per_m, contact_force_N_per_m } = &self.map;
        let rows = time_s.len();
        let fits = self.from_bit_m.len() == nodes
            && self.before.len() == nodes
            && self.intervals.len() <= nodes
            && self
                .intervals
                .iter()
                .all(|interval| interval.first < nodes && interval.last < nodes)
            && [md_m, side_force_N_per_m, contact_force_N_per_m]
                .iter()
                .all(|column| column.len() == rows);
        ensure(fits, "the map of contact")
    }

    pub(super) fn new(mesh: &Mesh) -> Self {
        let nodes = mesh.nodes.len();
        let many = nodes.div_ceil(MAX_INTERVALS);
        let border = |upper: usize, lower: usize| {
            0.5 * (mesh.nodes[upper].from_bit_m + mesh.nodes[lower].from_bit_m)
        };
        let intervals: Vec<MapInterval> = (0..nodes)
            .step_by(many)
            .map(|first| {
                let last = (first + many).min(nodes) - 1;
                MapInterval {
                    first,
                    last,
                    top_m: border(first.saturating_sub(1), first),
                    bottom_m: border(last, (last + 1).min(nodes - 1)),
                }
            })
            .collect();
        Self {
            before: vec![[0.0; 2]; nodes],
            from_bit_m: mesh.nodes.iter().map(|node| node.from_bit_m).collect(),
            intervals,
            samples: 0,
            map: ContactMap::default(),
        }
    }

    /// The sums begin anew.
    pub(super) fn restart(&mut self) {
        self.before.fill([0.0; 2]);
    }

    /// Forgets the rows.
    pub(super) fn forget(&mut self) {
        self.map = ContactMap::default();
    }

    /// Drops the rows of before a time, s.
    pub(super) fn drop_rows(&mut self, before_s: f64) {
        let ContactMap { time_s, md_m, side_force_N_per_m, contact_force_N_per_m } = &mut self.map;
        let rows = time_s.partition_point(|time_s| *time_s < before_s);
        for column in [time_s, md_m, side_force_N_per_m, contact_force_N_per_m] {
            column.drain(..rows);
        }
    }

    /// Counts a sample of a run that takes `run_samples`; whether a row of the map is full.
    pub(super) fn count(&mut self, run_samples: u64) -> bool {
        self.samples += 1;
        self.samples >= run_samples.div_ceil(MAX_ROWS).max(1)
    }

    /// Closes a row of the map with the samples since the last one, if there are any. `sums` are
    /// those of a node's signed contact force and of its magnitude, N.
    pub(super) fn close_row(
        &mut self,
        anchors: &[Anchor],
        time_s: f64,
        sums: impl Fn(usize) -> [f64; 2],
    ) {
        let samples = std::mem::take(&mut self.samples) as f64;
        if samples == 0.0 {
            return;
        }
        let sums: Vec<[f64; 2]> = (0..self.before.len()).map(sums).collect();
        let since = sums.iter().zip(&self.before);
        let since = since.map(|(sums, before)| [0, 1].map(|k| (sums[k] - before[k]) / samples));
        let per_metre = self.per_metre(&since.collect::<Vec<_>>());
        self.before = sums;
        let map = &mut self.map;
        for (interval, [side, contact]) in self.intervals.iter().zip(per_metre) {
            let ends_m = anchors[interval.first].md_m + anchors[interval.last].md_m;
            map.time_s.push(time_s);
            map.md_m.push(0.5 * ends_m);
            map.side_force_N_per_m.push(side);
            map.contact_force_N_per_m.push(contact);
        }
    }

    /// The map so far.
    pub(super) fn map(&self) -> &ContactMap {
        &self.map
    }

    /// Contact force of each stretch per metre, from the nodes' forces. A joint carries the string
    /// about it: by stretches of so few joints that one has two of them and the next has three, the
    /// map would have stripes.
    fn per_metre(&self, forces: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let top_m = self.from_bit_m.first().copied().unwrap_or(0.0);
        let mut shares = vec![[0.0; 2]; self.intervals.len()];
        let mut first = 0;
        for reach in contact_lengths(&self.from_bit_m, |i| forces[i][1] > 0.0) {
            let ContactLength { contact, above_m, below_m } = reach;
            let at_m = self.from_bit_m[contact];
            let (high_m, low_m) = ((at_m + above_m).min(top_m), (at_m - below_m).max(0.0));
            // Stretches follow each other from the surface down, and so do contacts: the first
            // stretch that reaches above is the last contact's or one below.
            while self.intervals.get(first).is_some_and(|interval| interval.bottom_m >= high_m) {
                first += 1;
            }
            while first > 0 && self.intervals[first - 1].bottom_m < high_m {
                first -= 1;
            }
            let intervals = self.intervals[first..].iter().zip(&mut shares[first..]);
            for (interval, share) in intervals.take_while(|(interval, _)| interval.top_m > low_m) {
                let both_m = interval.top_m.min(high_m) - interval.bottom_m.max(low_m);
                let part = both_m / ((high_m - low_m) * (interval.top_m - interval.bottom_m));
                for (share, force) in share.iter_mut().zip(forces[contact]) {
                    *share += part * force;
                }
            }
        }
        shares
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Joints three nodes apart in stretches of two nodes: each stretch has one of them or none,
    /// and their map no stripes all the same. All of the force is in it, on its side.
    #[test]
    fn joints_make_no_stripes() {
        const NODES: usize = 301;
        const ELEMENT_M: f64 = 0.4;
        const FORCE_N: f64 = 300.0;
        let from_bit_m: Vec<f64> = (0..NODES).rev().map(|i| ELEMENT_M * i as f64).collect();
        let deep = from_bit_m[0];
        let intervals = (0..NODES).step_by(2).map(|first| MapInterval {
            first,
            last: (first + 1).min(NODES - 1),
            top_m: (from_bit_m[first] + 0.5 * ELEMENT_M).min(deep),
            bottom_m: (from_bit_m[first] - 1.5 * ELEMENT_M).max(0.0),
        });
        let keeper = MapKeeper {
            intervals: intervals.collect(),
            before: vec![[0.0; 2]; NODES],
            from_bit_m,
            samples: 0,
            map: ContactMap::default(),
        };
        let joints = (0..NODES).map(|i| match i % 3 {
            1 => [-FORCE_N, FORCE_N],
            _ => [0.0; 2],
        });
        let joints: Vec<[f64; 2]> = joints.collect();
        let found = keeper.per_metre(&joints);
        let expected = FORCE_N / (3.0 * ELEMENT_M);
        for [side, contact] in &found[2..found.len() - 3] {
            assert!((contact / expected - 1.0).abs() < 1e-12, "{contact} N/m");
            assert_eq!(*side, -contact);
        }
        let lengths = keeper.intervals.iter().map(|interval| interval.top_m - interval.bottom_m);
        let total: f64 = found.iter().zip(lengths).map(|([_, contact], m)| contact * m).sum();
        assert!((total / (100.0 * FORCE_N) - 1.0).abs() < 1e-12, "{total} N");
    }
}
