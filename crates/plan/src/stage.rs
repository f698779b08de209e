//! A part of a campaign: an operation that goes on for a time.

use std::f64::consts::TAU;

use wholestring::{model::Model, operation::Operation, outcome::Solution};

/// A solved operation, and how long it goes on: what fatigue and wear are summed of.
#[derive(Debug, Clone, Copy)]
pub struct Stage<'a> {
    /// The model.
    pub model: &'a Model,
    /// The operation.
    pub operation: &'a Operation,
    /// What a method answers of it.
    pub solution: Solution<'a>,
    /// How long it goes on, s.
    pub duration_s: f64,
}

impl<'a> Stage<'a> {
    /// An operation that moves the string by a length, m, at its own speed: drilling at its rate of
    /// penetration, tripping and reaming at its trip speed. None of one that does not move.
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

    /// Revolutions of the string.
    pub fn revolutions(&self) -> f64 {
        self.operation.rotation_rad_per_s() * self.duration_s / TAU
    }

    /// How far the string moves along the hole, m.
    pub fn travel_m(&self) -> f64 {
        self.operation.axial_velocity_m_per_s().abs() * self.duration_s
    }
}

/// The length that each of some depths of the bit stands for where the hole is drilled from the first to the
/// last, m: half the way to its neighbours. The depths grow.
pub fn drilled_lengths_m(bit_depths_m: &[f64]) -> Vec<f64> {
    let last = bit_depths_m.len().saturating_sub(1);
    let of = |row: usize| {
        let (above, below) = (row.saturating_sub(1), (row + 1).min(last));
        0.5 * (bit_depths_m[below] - bit_depths_m[above])
    };
    (0..bit_depths_m.len()).map(of).collect()
}
