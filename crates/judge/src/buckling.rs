//! Compression compared with the critical load at its depth.

use wholestring::{
    model::Model,
    operation::Operation,
    outcome::Profile,
    statics::buckling::{Place, Shape},
};

use crate::{
    Check, CheckKind, LimitSettings, Severity,
    interval::{Interval, beyond_one},
};

/// A stretch shorter than this is a note, m: a joint of pipe, of which no wave is shorter.
const SHORTEST_M: f64 = 10.0;

/// The compression along a string and the critical loads it is compared with.
pub struct Line<'a> {
    model: &'a Model,
    bit_depth_m: f64,
    profile: &'a Profile,
    /// Compression over the critical load, by row.
    sinusoidal: Vec<f64>,
    helical: Vec<f64>,
}

impl<'a> Line<'a> {
    /// Takes the tensions and critical loads of a profile; for a dynamic run the tensions are its
    /// means.
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

    /// Whether the compression at a row exceeds the load that the string's weight supports in a
    /// vertical hole, while the wall gives no further support under that compression.
    fn is_bowed_by_weight_alone(&self, row: usize) -> bool {
        let place = Place::above(self.model, self.bit_depth_m, self.profile.md_m[row]);
        let place = place.seen_by(self.model.buckling);
        is_held_by_weight_alone(&place, -self.profile.tension_N[row])
    }

    fn component_at(&self, row: usize) -> &'a str {
        let from_bit_m = self.bit_depth_m - self.profile.md_m[row];
        &self.model.string.component_at(from_bit_m).1.name
    }
}

/// Whether the load that a place supports under a compression, N, is that of a vertical hole: the
/// wall adds nothing to it.
fn is_held_by_weight_alone(place: &Place, compression_N: f64) -> bool {
    let wall_load_N_per_m = place.wall_load_N_per_m(compression_N);
    place.threshold_N(Shape::Sinusoidal, wall_load_N_per_m)
        <= place.vertical_load_N(Shape::Sinusoidal) * (1.0 + 1e-9)
}

/// Whether a string that is buckled somewhere is so in a vertical hole alone: collars bow there in
/// every well as soon as they press on the bit. `tensions` are pairs of measured depth, m, and
/// effective tension, N.
pub fn bows_in_vertical_hole(
    model: &Model,
    operation: &Operation,
    tensions: impl IntoIterator<Item = (f64, f64)>,
) -> bool {
    let mut bows = false;
    for (md_m, tension_N) in tensions.into_iter().filter(|(_, tension_N)| *tension_N < 0.0) {
        let place = Place::above(model, operation.bit_depth_m, md_m).seen_by(model.buckling);
        if place.is_beyond(Shape::Sinusoidal, -tension_N) {
            if !is_held_by_weight_alone(&place, -tension_N) {
                return false;
            }
            bows = true;
        }
    }
    bows
}

/// Returns the buckled stretches, the helical ones first. For a shape in which nothing is buckled,
/// returns the place with the least reserve. A bow in a vertical hole is not reported where the
/// same stretch is a helix.
pub fn checks(line: &Line<'_>, settings: &LimitSettings) -> Vec<Check> {
    let of_kind = |kind, over: &[f64]| -> Vec<Check> {
        let intervals = beyond_one(&line.profile.md_m, over);
        if intervals.is_empty() {
            return nearest(line, kind, over, settings).into_iter().collect();
        }
        let stretches = intervals.iter();
        stretches.filter_map(|interval| stretch(line, kind, over, interval, settings)).collect()
    };
    let mut checks = of_kind(CheckKind::HelicalBuckling, &line.helical);
    let bowed = of_kind(CheckKind::SinusoidalBuckling, &line.sinusoidal);
    let is_helix = |bow: &Check| {
        let mut helices = checks.iter().filter(|helix| helix.to_md_m.is_some());
        helices.any(|helix| helix.md_m < bow.to_md_m && bow.md_m < helix.to_md_m)
    };
    let reported = bowed.into_iter();
    let reported = reported.filter(|bow| bow.severity != Severity::Note || !is_helix(bow));
    let reported: Vec<Check> = reported.collect();
    checks.extend(reported);
    checks
}

fn stretch(
    line: &Line<'_>,
    kind: CheckKind,
    over: &[f64],
    interval: &Interval,
    settings: &LimitSettings,
) -> Option<Check> {
    let worst = interval.worst;
    let check = at_row(line, kind, over, worst, settings)?.over(interval.md_m);
    let short = interval.md_m[1] - interval.md_m[0] < SHORTEST_M;
    // Collars bow in every vertical hole as soon as they press on the bit, and drill on.
    let bows = kind == CheckKind::SinusoidalBuckling && line.is_bowed_by_weight_alone(worst);
    Some(if short || bows { check.at_most(Severity::Note) } else { check })
}

fn nearest(
    line: &Line<'_>,
    kind: CheckKind,
    over: &[f64],
    settings: &LimitSettings,
) -> Option<Check> {
    let row = (0..over.len()).max_by(|a, b| over[*a].total_cmp(&over[*b]))?;
    Some(at_row(line, kind, over, row, settings)?.at(line.profile.md_m[row]))
}

fn at_row(
    line: &Line<'_>,
    kind: CheckKind,
    over: &[f64],
    row: usize,
    settings: &LimitSettings,
) -> Option<Check> {
    let compression_N = -line.profile.tension_N[row];
    let critical_N = compression_N / over[row];
    let check = Check::load(kind, compression_N, critical_N, settings.factors.required(kind))?;
    Some(check.of_component(line.component_at(row)))
}
