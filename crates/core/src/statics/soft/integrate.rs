//! Integration from the bit to the surface.

use nalgebra::Vector3;

use super::{
    SoftError, SoftSettings,
    hole::{self, Node, Step, Stretch},
    load::{Load, Point, Totals},
    segment::{Course, Segment},
};
use crate::{
    model::Model,
    mud::Hydraulics,
    operation::Operation,
    statics::{
        circulation::{self, Passage},
        sliding::Sliding,
    },
    well::Path,
};

/// Values kept during the integration on its way up.
pub(super) trait Keep {
    /// The state at a node, the bit's first. Where two segments meet, it is of the one above.
    fn node(&mut self, segment: &Segment<'_>, node: &Node, totals: &Totals, load: &Load);

    /// A step from a lower node, with the totals accumulated there, to an upper one.
    fn step(
        &mut self,
        _segment: &Segment<'_>,
        _step_m: f64,
        _lower: (f64, &Totals),
        _upper: (f64, &Totals),
    ) {
    }
}

/// Result of the integration.
pub(super) struct Integral {
    /// Totals accumulated at the surface.
    pub(super) totals: Totals,
    /// Increase of the totals over the uppermost metre.
    pub(super) per_metre_at_surface: Totals,
    /// Effect of the mud, if it flows.
    pub(super) hydraulics: Option<Hydraulics>,
}

/// One step of the classical Runge-Kutta method, up by `step_m`, through three points of the path,
/// with the load at its lower end.
fn step(
    segment: &Segment<'_>,
    points: [&Point; 3],
    step_m: f64,
    (at, load): (Totals, &Load),
    course: Course,
) -> Totals {
    let [lower, middle, upper] = points;
    let k1 = segment.rate_under(lower, &at, load);
    let k2 = segment.rate(middle, &(at + k1 * (0.5 * step_m)), course);
    let k3 = segment.rate(middle, &(at + k2 * (0.5 * step_m)), course);
    let k4 = segment.rate(upper, &(at + k3 * step_m), course);
    at + (k1 + (k2 + k3) * 2.0 + k4) * (step_m / 6.0)
}

/// A stretch with an operation on it, along which a string is integrated on one course.
struct Climb<'a> {
    segment: &'a Segment<'a>,
    path: &'a Path,
    course: Course,
}

impl Climb<'_> {
    /// A step from a lower to an upper depth, halved wherever the wall load has a kink: returns the
    /// accumulated totals and the load there. `load` is the one at its lower end.
    fn step(
        &self,
        [lower_md_m, upper_md_m]: [f64; 2],
        points: [&Point; 3],
        step_m: f64,
        (at, load): (Totals, &Load),
        halvings: usize,
    ) -> (Totals, Load) {
        let [lower, middle, upper] = points;
        let totals = step(self.segment, points, step_m, (at, load), self.course);
        let end = self.segment.load(upper, totals.tension_N, self.course);
        let ends = [&load.q_N_per_m, &end.q_N_per_m];
        let bend = || {
            let tension_N = 0.5 * (at.tension_N + totals.tension_N);
            let half_way = self.segment.load(middle, tension_N, self.course).q_N_per_m;
            (half_way - (ends[0] + ends[1]) * 0.5).norm()
        };
        if halvings == 0 || kink_N(ends, bend, step_m) < KINK_N {
            return (totals, end);
        }
        let ends_m = [self.segment.from_md_m, self.segment.to_md_m];
        let heading = |md_m: f64| hole::heading_within(self.path, ends_m, md_m);
        let (half_m, middle_md_m) = (0.5 * step_m, 0.5 * (lower_md_m + upper_md_m));
        let half = |mds_m: [f64; 2], from: &Point, (at, load): (Totals, &Load)| {
            let (middle, end) = hole::points(heading, mds_m, half_m, from);
            let found = self.step(mds_m, [from, &middle, &end], half_m, (at, load), halvings - 1);
            (found, end)
        };
        let ((totals, load), there) = half([lower_md_m, middle_md_m], lower, (at, load));
        half([middle_md_m, upper_md_m], &there, (totals, &load)).0
    }
}

/// Error of a step that is let pass, N: 2e-12 of a hook load of 10 kN.
const KINK_N: f64 = 2e-8;

/// Most halvings of a step: each makes the error of a kink a quarter.
const MAX_HALVINGS: usize = 20;

/// Error of Simpson's rule for the size of a vector that changes from one value to another over a
/// step, N: the maximum of the fourth derivative, times `step⁵/2880`. With the change `δ`, the
/// distance `d` of the straight line between the two from zero, the least size `r` on it, and `b`
/// by which the vector is off that line half-way, that is `12 d² δ⁴/r⁵`, `192 b²/r` and `96 b
/// δ²/r²` over `step⁴`. Where the vector goes through zero its size has a kink, which costs `δ
/// step/16` at most. `b` is read only where the least size is much less than the largest: elsewhere
/// it costs nothing.
fn kink_N([from, to]: [&Vector3<f64>; 2], bend: impl Fn() -> f64, step_m: f64) -> f64 {
    let by = to - from;
    let square = by.norm_squared();
    if square == 0.0 {
        return 0.0;
    }
    let part = (-from.dot(&by) / square).clamp(0.0, 1.0);
    let least = (from + by * part).norm_squared();
    let line = from.cross(&by).norm_squared() / square;
    let change = square.sqrt();
    let size = least.sqrt();
    // Not numbers where the least is zero, of which the least of two makes the other.
    let straight = (change * square * line / (240.0 * least * least * size)).min(1.0 / 16.0);
    let mut off = change * straight;
    if least < SMALL * from.norm_squared().max(to.norm_squared()) || size < LIGHT_N_PER_M {
        let bend = bend();
        off += bend * (bend / (15.0 * size) + square / (30.0 * least)).min(1.0 / 16.0);
    }
    step_m * off
}

/// Part of the larger square below which a wall load is small, and the load that is small anyhow, N/m.
const SMALL: f64 = 0.5;
const LIGHT_N_PER_M: f64 = 30.0;

/// The step from a lower to an upper depth in which a helix begins or ends: to there, and on from
/// there.
fn divided(
    segment: &Segment<'_>,
    path: &Path,
    [lower_md_m, upper_md_m]: [f64; 2],
    [lower, _, upper]: [&Point; 3],
    at: Totals,
    course: Course,
) -> Totals {
    let length_m = lower_md_m - upper_md_m;
    // The depth below surface, which only the pressures see, changes linearly.
    let point = |part: f64| {
        let tvd_m = lower.tvd_m + part * (upper.tvd_m - lower.tvd_m);
        let md_m = lower_md_m - part * length_m;
        Point::new(path.heading_at(md_m), [md_m, tvd_m])
    };
    let first = |part: f64| {
        let (middle, end) = (point(0.5 * part), point(part));
        let load = segment.load(lower, at.tension_N, course);
        let totals = step(segment, [lower, &middle, &end], part * length_m, (at, &load), course);
        (totals, end)
    };
    let (mut same, mut other) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let part = 0.5 * (same + other);
        let (totals, end) = first(part);
        if segment.course(true, &end, totals.tension_N) == course {
            same = part;
        } else {
            other = part;
        }
    }
    let (totals, there) = first(other);
    let middle = point(0.5 * (1.0 + other));
    let rest_m = (1.0 - other) * length_m;
    let load = segment.load(&there, totals.tension_N, course.other());
    step(segment, [&there, &middle, upper], rest_m, (totals, &load), course.other())
}

/// Halvings of a step until nothing is left of it in double precision.
const HALVINGS: usize = 50;

/// Integrates an operation from the bit to the surface, through the stretches of its hole.
pub(super) fn from_bit(
    model: &Model,
    stretches: &[Stretch],
    operation: &Operation,
    settings: &SoftSettings,
    keep: &mut impl Keep,
) -> Result<Integral, SoftError> {
    let path = &model.well.path;
    let sliding = Sliding::of(operation);
    let mud = model.mud_column();
    let mut segments: Vec<Segment<'_>> = stretches
        .iter()
        .map(|stretch| Segment::new(model, &mud, operation, sliding, stretch))
        .collect();
    let passages: Vec<Passage> = segments.iter().map(Segment::passage).collect();
    let (circulating, hydraulics) = circulation::along(model, operation, &passages);
    for (segment, circulating) in segments.iter_mut().zip(circulating) {
        segment.circulating = circulating;
    }
    // At the bit: F = P − WOB less the thrust of the jets, M = M_bit.
    let mut totals = Totals {
        tension_N: operation.tension_at_bit_N() - hydraulics.map_or(0.0, |mud| mud.jet_thrust_N),
        torque_N_m: operation.bit_torque_now_N_m(),
        axial_friction_N: 0.0,
        side_force_N: 0.0,
        stretch_m: 0.0,
        twist_rad: 0.0,
    };
    let helix_counts = settings.helix_side_force;
    let mut per_metre_at_surface = totals;
    for (segment, stretch) in segments.iter().zip(stretches) {
        let step_m = stretch.step_m;
        let mut lower = &stretch.lowest;
        let mut known: Option<(Course, Load)> = None;
        for Step { middle, upper } in &stretch.steps {
            let before = totals;
            let course = segment.course(helix_counts, &lower.point, before.tension_N);
            let load = match known {
                Some((same, load)) if same == course => load,
                _ => segment.load(&lower.point, before.tension_N, course),
            };
            keep.node(segment, lower, &before, &load);
            let points = [&lower.point, middle, &upper.point];
            let mds_m = [lower.md_m, upper.md_m];
            let climb = Climb { segment, path, course };
            let found = climb.step(mds_m, points, step_m, (before, &load), MAX_HALVINGS);
            totals = found.0;
            known = Some((course, found.1));
            if helix_counts {
                if course == Course::Helix && segment.locks_up(before.tension_N, step_m) {
                    return Err(SoftError::LocksUp { md_m: lower.md_m });
                }
                if segment.course(helix_counts, &upper.point, totals.tension_N) != course {
                    totals = divided(segment, path, mds_m, points, before, course);
                    known = None;
                }
            }
            if !(totals.tension_N.is_finite()
                && totals.torque_N_m.is_finite()
                && totals.stretch_m.is_finite()
                && totals.twist_rad.is_finite())
            {
                return Err(SoftError::NotFinite { md_m: upper.md_m });
            }
            keep.step(segment, step_m, (lower.md_m, &before), (upper.md_m, &totals));
            lower = upper;
        }
        // The uppermost stretch ends at the surface, with a node of its own.
        if stretch.from_md_m == 0.0 {
            let course = segment.course(helix_counts, &lower.point, totals.tension_N);
            let load = segment.load(&lower.point, totals.tension_N, course);
            keep.node(segment, lower, &totals, &load);
            per_metre_at_surface = segment.rate_under(&lower.point, &totals, &load);
        }
    }
    Ok(Integral { totals, per_metre_at_surface, hydraulics })
}
