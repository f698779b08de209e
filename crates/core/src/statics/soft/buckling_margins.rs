//! Additional compression of a string up to buckling.

use super::{
    hole::Node,
    integrate::Keep,
    load::{Load, Totals},
    segment::Segment,
};

/// The least margins so far, N, before a sinusoid and before a helix.
pub(super) struct BucklingMargins(pub(super) [f64; 2]);

impl BucklingMargins {
    /// Nothing can buckle yet.
    pub(super) const NONE: Self = Self([f64::INFINITY; 2]);
}

impl Keep for BucklingMargins {
    fn node(&mut self, _: &Segment<'_>, node: &Node, totals: &Totals, _: &Load) {
        let Some(loads_N) = node.buckling_loads.compared_with_N(-totals.tension_N) else {
            return;
        };
        for (least_N, load_N) in self.0.iter_mut().zip(loads_N) {
            *least_N = least_N.min(load_N + totals.tension_N);
        }
    }
}
