//! Whether the numbers of a run still mean anything.

use super::{diverged::Diverged, run::Run};
use crate::{
    dynamics::{boundary::wall_friction::WallFriction, kernel::chain::node},
    simd::number::Real,
};

/// Speed beyond which a run has diverged, m/s: no drill string moves at that of a bullet.
const DIVERGED_M_PER_S: f64 = 1e3;

/// Spin beyond which a run has diverged, rad/s: a million revolutions a minute.
const DIVERGED_RAD_PER_S: f64 = 1e5;

impl<R: Real> Run<R> {
    /// Looks at every number; the run has diverged where one is too large or none.
    pub(super) fn check_numbers(&self) -> Result<(), Diverged> {
        let friction = self.state.friction.as_ref();
        if let Some((node, value)) = friction.and_then(WallFriction::fault) {
            return Err(Diverged {
                time_s: self.time_s(),
                md_m: self.state.anchors[node].md_m,
                quantity: "coefficient of friction",
                value,
            });
        }
        // Not a number is too fast, too.
        let fast = |x: f64, limit: f64| x.is_nan() || x.abs() >= limit;
        if self.chain.slower_than(DIVERGED_M_PER_S, DIVERGED_RAD_PER_S) {
            return Ok(());
        }
        let speed = |i: usize| {
            let v = self.chain.velocity(i);
            v.dot(v).sqrt()
        };
        let worst = (0..self.chain.nodes())
            .find(|i| {
                !speed(*i).is_finite() || fast(node!(self.chain, *i, spin), DIVERGED_RAD_PER_S)
            })
            .unwrap_or_else(|| {
                (0..self.chain.nodes()).max_by(|a, b| speed(*a).total_cmp(&speed(*b))).unwrap_or(0)
            });
        let spin = node!(self.chain, worst, spin);
        let (quantity, value) = if !fast(spin, DIVERGED_RAD_PER_S) {
            ("velocity (m/s)", speed(worst))
        } else {
            ("spin (rad/s)", spin)
        };
        Err(Diverged {
            time_s: self.time_s(),
            md_m: self.state.anchors[worst].md_m,
            quantity,
            value,
        })
    }
}
