//! Distribution of friction work along the string and along the hole.

use crate::{
    damage::{Damaged, ensure},
    dynamics::kernel::chain::Chain,
    outcome::{HOLE_STEP_M, hole_steps, spread},
    rod::contact_length::LONGEST_REACH_M,
    simd::number::Real,
};

/// Work of friction since the window began: force times sliding distance, J.
///
/// The friction work of a node is summed at the node, and distributed over the hole whenever the
/// string has moved by [`HOLE_STEP_M`].
#[derive(Debug, Clone, serde::Serialize, serde::Deserialize)]
pub struct Wear {
    /// Of each node.
    string_J: Vec<f64>,
    /// Part of the work that has been distributed over the hole.
    laid_J: Vec<f64>,
    /// Depth of the bit when that was done, m.
    bit_md_m: f64,
    /// On each stretch of hole from the surface down.
    hole_J: Vec<f64>,
}

impl Wear {
    /// Whether stored wear is that of a string of so many nodes in a hole down to `hole_end_m`.
    pub(in crate::dynamics) fn check(&self, nodes: usize, hole_end_m: f64) -> Result<(), Damaged> {
        let intervals = Self::new(0, hole_end_m, 0.0).hole_J.len();
        let fits = [&self.string_J, &self.laid_J].iter().all(|each| each.len() == nodes);
        ensure(fits && self.hole_J.len() == intervals, "the wear")
    }

    /// No wear yet of a string of `nodes` in a hole down to `hole_end_m`, its bit at `bit_md_m`.
    pub fn new(nodes: usize, hole_end_m: f64, bit_md_m: f64) -> Self {
        Self {
            string_J: vec![0.0; nodes],
            laid_J: vec![0.0; nodes],
            bit_md_m,
            hole_J: vec![0.0; hole_steps(hole_end_m)],
        }
    }

    /// Forgets everything: the window begins, with the bit at `bit_md_m`.
    pub fn restart(&mut self, bit_md_m: f64) {
        self.string_J.fill(0.0);
        self.laid_J.fill(0.0);
        self.hole_J.fill(0.0);
        self.bit_md_m = bit_md_m;
    }

    /// Adds the chain's sums since its last sample, before they are cleared, and returns their
    /// total, J. `md_m` gives the measured depth of a node.
    pub fn sample(&mut self, chain: &Chain<impl Real>, md_m: impl Fn(usize) -> f64) -> f64 {
        let all = chain.take_up_wear(&mut self.string_J);
        let bit_md_m = md_m(self.string_J.len() - 1);
        if (bit_md_m - self.bit_md_m).abs() >= HOLE_STEP_M {
            self.deposit(md_m);
            self.bit_md_m = bit_md_m;
        }
        all
    }

    /// Work of friction at a node, J.
    pub fn string_J(&self, node: usize) -> f64 {
        self.string_J[node]
    }

    /// Work on each stretch of the hole up to now, J per metre of hole, with the nodes at `md_m`.
    pub fn hole_J_per_m(&self, md_m: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut now = self.clone();
        now.deposit(md_m);
        now.hole_J.iter().map(|work| work / HOLE_STEP_M).collect()
    }

    /// Distributes over the hole the work that has not been distributed yet. The work of each node
    /// is spread over half the distance to the next working node on either side, at most
    /// [`LONGEST_REACH_M`].
    fn deposit(&mut self, md_m: impl Fn(usize) -> f64) {
        let working: Vec<(f64, f64)> = (0..self.string_J.len())
            .map(|i| (md_m(i), self.string_J[i] - self.laid_J[i]))
            .filter(|(_, work)| *work != 0.0)
            .collect();
        for (index, &(md, work)) in working.iter().enumerate() {
            let half = |other: Option<&(f64, f64)>| {
                other.map_or(LONGEST_REACH_M, |(there, _)| {
                    (0.5 * (there - md).abs()).min(LONGEST_REACH_M)
                })
            };
            let above = half(index.checked_sub(1).and_then(|above| working.get(above)));
            let below = half(working.get(index + 1));
            spread(&mut self.hole_J, md - above, md + below, work);
        }
        self.laid_J.copy_from_slice(&self.string_J);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::kernel::chain::node;

    /// Nothing is lost wherever the string goes, and a string that works evenly while it moves
    /// works evenly on the hole: 40 nodes of 4 J each, 3.2 m apart, over 30 m.
    #[test]
    fn work_is_laid_where_it_was_done() {
        let nodes = 40;
        let mut chain = Chain::new(nodes);
        let mut wear = Wear::new(nodes, 400.0, 200.0);
        for sample in 0..100 {
            for i in 0..nodes {
                node!(chain, i, sum_wear = 0.04);
            }
            let bit = 200.0 + 0.3 * f64::from(sample);
            wear.sample(&chain, |i| bit - 3.2 * (nodes - 1 - i) as f64);
        }
        let bit = 229.7;
        let at = |i: usize| bit - 3.2 * (nodes - 1 - i) as f64;
        let hole = wear.hole_J_per_m(at);
        let total: f64 = hole.iter().sum::<f64>() * HOLE_STEP_M;
        assert!((total - 160.0).abs() < 1e-9, "{total}");
        assert_eq!(wear.string_J(7), (0..100).fold(0.0, |sum, _| sum + 0.04));
        // Away from the ends, which reach 10 m beyond the last node.
        for (step, work) in hole.iter().enumerate() {
            let middle = (step as f64 + 0.5) * HOLE_STEP_M;
            if (120.0..195.0).contains(&middle) {
                assert!((work - 4.0 / 3.2).abs() < 0.05, "{middle}: {work}");
            } else if !(65.0..240.0).contains(&middle) {
                assert_eq!(*work, 0.0);
            }
        }
        // Nothing falls off the ends of the hole.
        let mut wear = Wear::new(nodes, 100.0, 0.0);
        wear.sample(&chain, |i| at(i) - 130.0);
        let total: f64 = wear.hole_J_per_m(|i| at(i) - 130.0).iter().sum::<f64>() * HOLE_STEP_M;
        assert!((total - 1.6).abs() < 1e-12, "{total}");
        wear.restart(0.0);
        assert!(wear.hole_J_per_m(at).iter().all(|work| *work == 0.0));
    }
}
