//! Push through a string that slides down its hole, with the wall load of its helix.
//!
//! Upwards from the bit by `x`, the compression of a string that slides down grows by
//!
//! ```text
//! dF/dx = μ (w_n(F) + [helical] r F²/(4 EI)) − w cos θ
//! ```
//!
//! (Mitchell 1986). `F` becomes infinite within a finite length: the string locks up. The angle `φ
//! = atan(F/F₀)`, which approaches a right angle there, is the integrated variable. Theory:
//! `docs/src/findings.md`.

use std::f64::consts::FRAC_PI_2;

use super::{
    loads::Criterion,
    place::{Pipe, Place},
};
use crate::{model::Model, operation::Operation};

/// `F₀`, N: of the order of the critical loads of drill pipe.
const SCALE_N: f64 = 1e5;

/// A stretch of string on which everything but the compression is the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Length, m.
    pub length_m: f64,
    /// Pipe and hole.
    pub place: Place,
    /// Coefficient of axial friction.
    pub friction: f64,
    /// Part of the buoyed weight along the hole `w cos θ`, N/m.
    pub weight_along_N_per_m: f64,
}

/// Result of a push from the bit up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pushed {
    /// Compression at the upper end, N; negative where the string hangs there.
    Through(f64),
    /// It grows beyond all bounds within this distance from the lower end, m.
    LocksUp(f64),
}

impl Segment {
    /// `dF/dx` upwards.
    fn rate_N_per_m(&self, compression_N: f64, helical: bool) -> f64 {
        let mut wall_load = self.place.wall_load_N_per_m(compression_N);
        if helical {
            wall_load += self.place.helix_load_N_per_m(compression_N);
        }
        self.friction * wall_load - self.weight_along_N_per_m
    }

    /// `dφ/dx` upwards.
    fn turn_per_m(&self, angle: f64, helical: bool) -> f64 {
        let compression_N = SCALE_N * libm::tan(angle);
        // `cos²φ` as it follows from the tangent: both stay finite at the right angle.
        let square = compression_N * compression_N + SCALE_N * SCALE_N;
        SCALE_N * (self.rate_N_per_m(compression_N, helical) / square)
    }

    fn is_helical(&self, by: Criterion, angle: f64) -> bool {
        self.place.is_helix(by, SCALE_N * libm::tan(angle))
    }

    /// Compression at the upper end under one at the lower, N, of a string without the wall load of
    /// a helix; infinite where that alone locks it up.
    pub fn push_straight_N(&self, at_lower_end_N: f64) -> f64 {
        let angle = self.step(libm::atan(at_lower_end_N / SCALE_N), self.length_m, false);
        if angle < FRAC_PI_2 { SCALE_N * libm::tan(angle) } else { f64::INFINITY }
    }

    /// One step of the classical Runge-Kutta method.
    fn step(&self, angle: f64, by_m: f64, helical: bool) -> f64 {
        let k1 = self.turn_per_m(angle, helical);
        let k2 = self.turn_per_m(angle + 0.5 * by_m * k1, helical);
        let k3 = self.turn_per_m(angle + 0.5 * by_m * k2, helical);
        let k4 = self.turn_per_m(angle + by_m * k3, helical);
        angle + by_m / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)
    }

    /// The angle at the other end, `by_m` upwards (downwards where negative). Where the helix
    /// begins or ends the step is divided.
    fn cross(&self, by: Criterion, angle: f64, by_m: f64) -> f64 {
        let helical = self.is_helical(by, angle);
        let whole = self.step(angle, by_m, helical);
        if whole >= FRAC_PI_2 || self.is_helical(by, whole) == helical {
            return whole;
        }
        let (mut same, mut other) = (0.0, 1.0);
        for _ in 0..50 {
            let part = 0.5 * (same + other);
            if self.is_helical(by, self.step(angle, part * by_m, helical)) == helical {
                same = part;
            } else {
                other = part;
            }
        }
        let there = self.step(angle, other * by_m, helical);
        self.step(there, (1.0 - other) * by_m, !helical)
    }
}

/// Compression at the upper end of stretches, from the bit up, that slide down with a compression
/// at their lower end, N. A pipe is helical beyond the load that the criterion takes.
pub fn push_through(segments: &[Segment], at_bit_N: f64, by: Criterion) -> Pushed {
    let mut angle = libm::atan(at_bit_N / SCALE_N);
    let mut below_m = 0.0;
    for segment in segments {
        let next = segment.cross(by, angle, segment.length_m);
        if next >= FRAC_PI_2 {
            let part = (FRAC_PI_2 - angle) / (next - angle);
            return Pushed::LocksUp(below_m + part * segment.length_m);
        }
        angle = next;
        below_m += segment.length_m;
    }
    Pushed::Through(SCALE_N * libm::tan(angle))
}

/// Compression at the lower end of the same stretches under a compression at their upper end, N,
/// which may be infinite: the part of a push that reaches the bit.
pub fn weight_at_bit_N(segments: &[Segment], at_top_N: f64, by: Criterion) -> f64 {
    let mut angle = libm::atan(at_top_N / SCALE_N);
    for segment in segments.iter().rev() {
        angle = segment.cross(by, angle, -segment.length_m);
    }
    SCALE_N * libm::tan(angle)
}

// The string in its hole as stretches to push through.

/// Longest stretch on which the compression is followed, m.
const STRETCH_M: f64 = 5.0;

/// The string of an operation in stretches, from the bit up, cut at the depths of a profile, m,
/// from the surface down.
pub fn segments(model: &Model, operation: &Operation, md_m: &[f64]) -> Vec<Segment> {
    let bit_depth_m = operation.bit_depth_m;
    let mut segments = Vec::new();
    let mut to_md_m = bit_depth_m;
    for row in (0..md_m.len().saturating_sub(1)).rev() {
        let from_md_m = md_m[row];
        let jumps = {
            let (above, _) =
                model.string.component_at(bit_depth_m - 0.5 * (from_md_m + md_m[row + 1]));
            let next = row.checked_sub(1).map(|next| 0.5 * (md_m[next] + from_md_m));
            next.is_some_and(|next| {
                model.string.component_at(bit_depth_m - next).0 != above
                    || model.well.hole.at(next) != model.well.hole.at(from_md_m)
            })
        };
        if row > 0 && !jumps && to_md_m - from_md_m < STRETCH_M {
            continue;
        }
        let length_m = to_md_m - from_md_m;
        let middle_m = 0.5 * (from_md_m + to_md_m);
        let heading = model.well.path.heading_at(middle_m);
        let (_, component) = model.string.component_at(bit_depth_m - middle_m);
        let section = model.well.hole.at(middle_m);
        let densities = model.densities_at(middle_m);
        let pipe = Pipe::new(component, section.diameter_m, densities);
        segments.push(Segment {
            length_m,
            place: pipe.at(&heading.tangent, &heading.curvature_per_m),
            friction: section.friction.kinetic,
            weight_along_N_per_m: component.weight_in_N_per_m(densities) * heading.tangent.z,
        });
        to_md_m = from_md_m;
    }
    segments
}
