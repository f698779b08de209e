//! Compression beyond the critical loads of its place.

use super::{
    Finding, Kind, Level,
    interval::{Interval, beyond_one},
};
use crate::{
    model::Model,
    operation::Operation,
    outcome::Profile,
    statics::buckling::{Place, Shape},
};

/// A stretch shorter than this is not reported, m: a joint of pipe, of which no wave is shorter.
const SHORTEST_M: f64 = 10.0;

/// The compression along a string, and what it is compared with.
pub struct Line<'a> {
    model: &'a Model,
    bit_depth_m: f64,
    profile: &'a Profile,
    /// Compression over the critical load, by row.
    sinusoidal: Vec<f64>,
    helical: Vec<f64>,
}

impl<'a> Line<'a> {
    /// Of the tensions of a profile, of a dynamic run its means, and its critical loads.
    pub fn of(model: &'a Model, operation: &Operation, profile: &'a Profile) -> Self {
        let over = |loads_N: &[Option<f64>]| -> Vec<f64> {
            let rows = profile.tension_N.iter().zip(loads_N);
            let over = |(tension_N, load_N): (&f64, &Option<f64>)| match load_N {
                Some(load_N) if *tension_N < 0.0 => -tension_N / load_N,
                _ => 0.0,
            };
            rows.map(over).collect()
        };
        Self {
            model,
            bit_depth_m: operation.bit_depth_m,
            profile,
            sinusoidal: over(&profile.sinusoidal_load_N),
            helical: over(&profile.helical_load_N),
        }
    }

    /// Whether any of it is helical.
    pub fn is_helical(&self) -> bool {
        self.helical.iter().any(|over| *over > 1.0)
    }

    /// Whether a row is beyond the load that its weight holds in a vertical hole, and the wall
    /// holds no more under that compression.
    fn is_bowed_by_weight_alone(&self, row: usize) -> bool {
        let place = Place::above(self.model, self.bit_depth_m, self.profile.md_m[row]);
        let place = place.seen_by(self.model.buckling);
        let wall_load_N_per_m = place.wall_load_N_per_m(-self.profile.tension_N[row]);
        place.threshold_N(Shape::Sinusoidal, wall_load_N_per_m)
            <= place.vertical_load_N(Shape::Sinusoidal) * (1.0 + 1e-9)
    }
}

/// The buckled stretches, those of the helix first. A bow in a vertical hole is not reported where
/// the same stretch is a helix.
pub fn findings(line: &Line<'_>) -> Vec<Finding> {
    let of = |kind, over: &[f64]| -> Vec<Finding> {
        let intervals = beyond_one(&line.profile.md_m, over).into_iter();
        let reported = intervals.filter(|of| of.md_m[1] - of.md_m[0] >= SHORTEST_M);
        reported.map(|interval| finding(line, kind, over, &interval)).collect()
    };
    let mut found = of(Kind::HelicalBuckling, &line.helical);
    let bowed = of(Kind::SinusoidalBuckling, &line.sinusoidal);
    let is_helix = |bow: &Finding| {
        let mut helices = found.iter();
        helices.any(|helix| helix.from_md_m < bow.to_md_m && bow.from_md_m < helix.to_md_m)
    };
    let reported = bowed.into_iter();
    let reported = reported.filter(|bow| bow.level > Level::Note || !is_helix(bow));
    let reported: Vec<Finding> = reported.collect();
    found.extend(reported);
    found
}

fn finding(line: &Line<'_>, kind: Kind, over: &[f64], interval: &Interval) -> Finding {
    let worst = interval.worst;
    let compression_N = -line.profile.tension_N[worst];
    let level = match kind {
        // Collars bow in every vertical hole as soon as they press on the bit, and drill on.
        Kind::SinusoidalBuckling if line.is_bowed_by_weight_alone(worst) => Level::Note,
        _ => Level::Warning,
    };
    let limit_N = compression_N / over[worst];
    Finding::new(kind, level).over(interval.md_m).value(compression_N).limit(limit_N)
}
