//! Compression beyond the critical loads of its place.

use super::{
    Finding, Kind, Level,
    interval::{Interval, beyond_one},
};
use crate::{
    model::Model,
    operation::Operation,
    outcome::Profile,
    statics::{
        buckling::{Criterion, Place},
        soft::SoftProfile,
    },
};

/// A stretch shorter than this is not reported, m: a joint of pipe, of which no wave is shorter.
const SHORTEST_M: f64 = 10.0;

/// The compression along a string, and what it is compared with.
pub struct Line<'a> {
    md_m: &'a [f64],
    tension_N: &'a [f64],
    place: Box<dyn Fn(usize) -> Place + 'a>,
    /// Compression over the critical load, by row.
    sinusoidal: Vec<f64>,
    helical: Vec<f64>,
}

impl<'a> Line<'a> {
    /// Of the soft string, whose side force is the wall load of the criterion.
    pub fn of_soft(model: &'a Model, operation: &Operation, profile: &'a SoftProfile) -> Self {
        let load = |row: usize| profile.side_force_N_per_m[row].abs();
        Self::new(model, operation, &profile.md_m, &profile.tension_N, load)
    }

    /// Of the mean tension of a dynamic run; the wall load is that of a straight pipe, whatever the
    /// nodes' was.
    pub fn of_nodes(model: &'a Model, operation: &Operation, nodes: &'a Profile) -> Self {
        let bit_depth_m = operation.bit_depth_m;
        let load = |row: usize| {
            let place = Place::of(model, bit_depth_m, nodes.md_m[row]);
            place.wall_load_N_per_m(-nodes.tension_N[row])
        };
        Self::new(model, operation, &nodes.md_m, &nodes.tension_N, load)
    }

    fn new(
        model: &'a Model,
        operation: &Operation,
        md_m: &'a [f64],
        tension_N: &'a [f64],
        wall_load_N_per_m: impl Fn(usize) -> f64,
    ) -> Self {
        let bit_depth_m = operation.bit_depth_m;
        // Of the last component and hole: load squared per wall load and load in a vertical hole,
        // sinusoidal and helical.
        let mut known: Option<(usize, f64, [f64; 4])> = None;
        let mut of_row = |row: usize| -> [f64; 2] {
            let compression_N = -tension_N[row];
            if compression_N.is_nan() || compression_N <= 0.0 {
                return [0.0; 2];
            }
            let (index, component) = model.string.component_at(bit_depth_m - md_m[row]);
            let hole_m = model.well.hole.at(md_m[row]).diameter_m;
            let of = match known {
                Some((last, diameter_m, of)) if last == index && diameter_m == hole_m => of,
                _ => {
                    let weight =
                        component.buoyed_weight_per_length_N_per_m(model.mud.density_kg_per_m3);
                    let stiffness = component.bending_stiffness_N_m2();
                    let clearance_m = 0.5 * hole_m - component.contact_radius_m();
                    let place = Place {
                        bending_stiffness_N_m2: stiffness,
                        clearance_m,
                        weight_N_per_m: weight.abs(),
                        weight_across_N_per_m: 0.0,
                        build_rad_per_m: 0.0,
                        turn_rad_per_m: 0.0,
                    };
                    let of = if clearance_m > 0.0 {
                        let per_load = |of: Criterion| of.beta() * stiffness / clearance_m;
                        [
                            per_load(Criterion::Sinusoidal),
                            place.vertical_load_N(Criterion::Sinusoidal),
                            per_load(Criterion::Helical),
                            place.vertical_load_N(Criterion::Helical),
                        ]
                    } else {
                        // A bit that fills its hole does not buckle in it.
                        [f64::INFINITY; 4]
                    };
                    known = Some((index, hole_m, of));
                    of
                }
            };
            // Below the load of a vertical hole nothing buckles, whatever presses the pipe to the
            // wall.
            if compression_N <= of[1] {
                return [compression_N / of[1], compression_N / of[3]];
            }
            let load = wall_load_N_per_m(row);
            let over = |per_load: f64, vertical_N: f64| {
                compression_N / (per_load * load).sqrt().max(vertical_N)
            };
            [over(of[0], of[1]), over(of[2], of[3])]
        };
        let (sinusoidal, helical) = (0..md_m.len())
            .map(|row| {
                let [sinusoidal, helical] = of_row(row);
                (sinusoidal, helical)
            })
            .unzip();
        let place = Box::new(move |row: usize| Place::of(model, bit_depth_m, md_m[row]));
        Self { md_m, tension_N, place, sinusoidal, helical }
    }

    /// Whether any of it is helical.
    pub fn is_helical(&self) -> bool {
        self.helical.iter().any(|over| *over > 1.0)
    }
}

/// The buckled stretches, those of the helix first. A bow in a vertical hole is not reported where
/// the same stretch is a helix.
pub fn findings(line: &Line<'_>) -> Vec<Finding> {
    let of = |criterion, kind, over: &[f64]| -> Vec<Finding> {
        let intervals = beyond_one(line.md_m, over).into_iter();
        let reported = intervals.filter(|of| of.md_m[1] - of.md_m[0] >= SHORTEST_M);
        reported.map(|interval| finding(line, criterion, kind, over, &interval)).collect()
    };
    let mut found = of(Criterion::Helical, Kind::HelicalBuckling, &line.helical);
    let bowed = of(Criterion::Sinusoidal, Kind::SinusoidalBuckling, &line.sinusoidal);
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

fn finding(
    line: &Line<'_>,
    criterion: Criterion,
    kind: Kind,
    over: &[f64],
    interval: &Interval,
) -> Finding {
    let worst = interval.worst;
    let compression_N = -line.tension_N[worst];
    let limit_N = compression_N / over[worst];
    let place = (line.place)(worst);
    // Collars bow in every vertical hole as soon as they press on the bit, and drill on.
    let by_weight_alone = limit_N <= place.vertical_load_N(criterion) * (1.0 + 1e-9);
    let level = match kind {
        Kind::SinusoidalBuckling if by_weight_alone => Level::Note,
        _ => Level::Warning,
    };
    Finding::new(kind, level).over(interval.md_m).value(compression_N).limit(
        match place.critical_load_N(criterion, compression_N) {
            // The curvature jumps at the row: the load that the row itself was compared with.
            load_N if load_N > compression_N => limit_N,
            load_N => load_N,
        },
    )
}
