//! The largest tension and torque of every node during an event.

use wholestring::{dynamics::Frame, outcome::Profile};

/// Extremes of each node, from the surface down.
#[derive(Debug, Default)]
pub(super) struct Extremes {
    /// Depths of the nodes before they move, m.
    md_m: Vec<f64>,
    most_tension_N: Vec<f64>,
    torque_N_m: Vec<[f64; 2]>,
}

impl Extremes {
    /// Adds a frame.
    pub(super) fn see(&mut self, frame: &Frame) {
        if self.md_m.is_empty() {
            // The upper end of a string that is longer than the hole to its bit, by its stretch, is
            // at the surface.
            self.md_m = frame.md_m.iter().map(|md_m| md_m.max(0.0)).collect();
        }
        self.most_tension_N.resize(frame.tension_N.len(), f64::NEG_INFINITY);
        self.torque_N_m.resize(frame.torque_N_m.len(), [f64::INFINITY, f64::NEG_INFINITY]);
        for (most, now) in self.most_tension_N.iter_mut().zip(&frame.tension_N) {
            *most = most.max(*now);
        }
        for ([least, most], now) in self.torque_N_m.iter_mut().zip(&frame.torque_N_m) {
            (*least, *most) = (least.min(*now), most.max(*now));
        }
    }

    /// Returns the profile with these in place of its percentiles, which exclude short peaks, and
    /// with the depths of the string at rest.
    pub(super) fn in_profile(self, profile: &Profile) -> Profile {
        if self.most_tension_N.len() != profile.md_m.len() {
            return profile.clone();
        }
        Profile {
            md_m: self.md_m,
            tension_p95_N: self.most_tension_N,
            torque_p05_N_m: self.torque_N_m.iter().map(|ends| ends[0]).collect(),
            torque_p95_N_m: self.torque_N_m.iter().map(|ends| ends[1]).collect(),
            ..profile.clone()
        }
    }
}
