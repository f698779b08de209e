//! A part of a campaign: an operation with its duration.

use std::f64::consts::TAU;

use wholestring::{model::Model, operation::Operation, outcome::Solution};

/// A solved operation and its duration, the terms of the sums of fatigue and wear.
#[derive(Debug, Clone, Copy)]
pub struct Stage<'a> {
    /// The model.
    pub model: &'a Model,
    /// The operation.
    pub operation: &'a Operation,
    /// The solution of a method.
    pub solution: Solution<'a>,
    /// Its duration, s.
    pub duration_s: f64,
}

impl<'a> Stage<'a> {
    /// Returns an operation that moves the string by a length, m, at its own speed: drilling at its
    /// rate of penetration, tripping and reaming at its trip speed. `None` for one that does not
    /// move.
    pub fn moved(
        model: &'a Model,
        operation: &'a Operation,
        solution: impl Into<Solution<'a>>,
        length_m: f64,
    ) -> Option<Self> {
        let speed_m_per_s = operation.axial_velocity_m_per_s().abs();
        (speed_m_per_s > 0.0).then(|| Self {
            model,
            operation,
            solution: solution.into(),
            duration_s: length_m / speed_m_per_s,
        })
    }

    /// Returns the revolutions of the string.
    pub fn revolutions(&self) -> f64 {
        self.operation.rotation_rad_per_s() * self.duration_s / TAU
    }

    /// Returns the axial travel of the string, m.
    pub fn travel_m(&self) -> f64 {
        self.operation.axial_velocity_m_per_s().abs() * self.duration_s
    }
}

/// Returns the length of hole below a depth, m, that each of some depths of the bit represents:
/// half the distance to its neighbours, and for the first of them all of the distance above it. The
/// depths increase; the lengths add up to the distance from the given depth to the last.
pub fn lengths_m(bit_depths_m: &[f64], below_m: f64) -> Vec<f64> {
    let half_way_m = |pair: &[f64]| 0.5 * (pair[0] + pair[1]);
    let between_m = bit_depths_m.windows(2).map(half_way_m);
    let ends_m = bit_depths_m.first().into_iter().map(|first_m| first_m.min(below_m));
    let ends_m = ends_m.chain(between_m).chain(bit_depths_m.last().copied());
    let ends_m: Vec<f64> = ends_m.map(|end_m| end_m.max(below_m)).collect();
    ends_m.windows(2).map(|ends_m| ends_m[1] - ends_m[0]).collect()
}
