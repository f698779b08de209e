//! The bottom of the hole as the blades have left it.

use crate::damage::{Damaged, ensure};
use serde::{Deserialize, Serialize};

/// Points of the surface between one blade and the next.
const POINTS: usize = 1024;

/// The cut surface ahead of a blade, up to the next one: measured depth against angle.
///
/// All blades are alike and spaced evenly, so the rock ahead of each is the surface left by the
/// blade before it, and one such sector describes the whole bottom. The surface is kept as a ring
/// of points at fixed angles, straight lines between: a blade that passes a point lowers it to
/// where it passed, if it reached that deep. So the delay between the blades needs no search in the
/// past, remains valid while the bit is stationary or jumps, and does not depend on the step.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Bottom {
    surface_m: Vec<f64>,
    /// Angle between points, rad.
    spacing_rad: f64,
    /// The point that a blade passed last.
    passed: usize,
    /// Depth of the rock surface there before the passage, m.
    stood_m: f64,
    /// Angle since then, rad.
    since_rad: f64,
}

impl Bottom {
    /// Whether a stored bottom has all its points, and the blades are at one of them.
    pub(super) fn check(&self) -> Result<(), Damaged> {
        let fits = self.surface_m.len() == POINTS && self.passed < POINTS;
        ensure(fits && self.spacing_rad > 0.0, "the bottom under the bit")
    }

    /// A bottom that `blades` have left in drilling steadily: at `depth_m` now, each of them
    /// cutting `depth_of_cut_m`.
    pub(super) fn new(blades: u32, depth_m: f64, depth_of_cut_m: f64) -> Self {
        let ramp = |i: usize| depth_m - depth_of_cut_m * (1.0 - i as f64 / POINTS as f64);
        Self {
            // Point 0 is under the blade, and the last point a sector ahead.
            surface_m: (0..POINTS).map(|i| if i == 0 { depth_m } else { ramp(i) }).collect(),
            spacing_rad: std::f64::consts::TAU / (f64::from(blades) * POINTS as f64),
            passed: 0,
            stood_m: ramp(0),
            since_rad: 0.0,
        }
    }

    /// Depth of the rock that a blade would meet after a further turn, m.
    pub(super) fn ahead_m(&self, turn_rad: f64) -> f64 {
        let place = (self.since_rad + turn_rad.max(0.0)) / self.spacing_rad;
        let points = (place as usize).min(POINTS - 1);
        let point = |i: usize| self.surface_m[(self.passed + i) % POINTS];
        // The last passage has cut this part itself.
        let here = if points == 0 { self.stood_m } else { point(points) };
        let next = point(points + 1);
        here + (place - points as f64).min(1.0) * (next - here)
    }

    /// Turns the blades on by `turn_rad`, their depth going from `from_m` to `to_m`, and cuts.
    pub(super) fn cut(&mut self, turn_rad: f64, from_m: f64, to_m: f64) {
        let before = self.since_rad;
        let mut since = before + turn_rad;
        let mut passed = 0.0;
        while since >= self.spacing_rad && passed < POINTS as f64 {
            since -= self.spacing_rad;
            passed += 1.0;
            // Position of the blade when it passed the point, linear within the step.
            let part = ((passed * self.spacing_rad - before) / turn_rad).clamp(0.0, 1.0);
            self.passed = (self.passed + 1) % POINTS;
            let point = &mut self.surface_m[self.passed];
            self.stood_m = *point;
            *point = point.max(from_m + part * (to_m - from_m));
        }
        self.since_rad = since;
    }
}
