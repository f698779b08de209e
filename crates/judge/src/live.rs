//! Alarms of a string in motion: its loads over the last seconds against the limits of pipe and
//! rig.
//!
//! A live string has no window of statistics. Its loads are the largest of the last seconds along
//! the string, and the samples of that time at the surface and at the bit.

use wholestring::{
    dynamics::DynamicsSettings,
    model::Model,
    operation::Operation,
    outcome::Profile,
    statics::buckling::{Place, Shape, segments},
};

use crate::{
    Check, CheckKind, Checks, Judge, along, buckling, descent,
    loads::Loads,
    motion,
    recent::Recent,
    rig,
    sentence::Words,
    strengths::Strengths,
    weight_on_bit::{self, weight_not_available},
};

/// Number of points at which the weight along a string is summed.
const POINTS: usize = 200;

/// Largest weight on bit that string, block and rig provide without friction, N.
fn available_weight_N(model: &Model, operation: &Operation) -> f64 {
    let depths = (0..=POINTS).map(|i| operation.bit_depth_m * i as f64 / POINTS as f64);
    let segments = segments(model, operation, &depths.collect::<Vec<_>>());
    let weight_N = |segment: &wholestring::statics::buckling::Segment| {
        segment.length_m * segment.weight_along_N_per_m
    };
    segments.iter().map(weight_N).sum::<f64>() + model.rig.push_with_block_N()
}

impl Judge {
    /// The check of a weight on bit that a driller sets, N; `None` where string, block and rig can
    /// provide it.
    pub fn set_weight(
        &self,
        model: &Model,
        operation: &Operation,
        requested_N: f64,
    ) -> Option<Check> {
        let available_N = available_weight_N(model, operation);
        let check = weight_not_available(model, requested_N, available_N)?;
        let words = Words::of_loads(&model.rig, f64::NAN);
        let sentence = words.sentence(&check);
        Some(check.worded(sentence).in_units(self.units))
    }

    /// The checks of a live string that need attention, the most severe first; none before its
    /// first sample.
    pub fn live(
        &self,
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        recent: &Recent<'_>,
    ) -> Checks {
        let mut checks = Checks::default();
        let (Some(bit_depth_m), false) =
            (recent.largest.md_m.last(), recent.hook_load_N.is_empty())
        else {
            return checks;
        };
        // The bit moves: components are found from its present depth.
        let operation = &Operation { bit_depth_m: *bit_depth_m, ..*operation };
        let loads = Loads::of_recent(model, operation, recent);
        let strengths = Strengths::of(model, &mut checks);
        along::limits(model, &strengths, &loads, &self.limits, &mut checks);
        rig::limits(model, operation, &loads, &self.limits, &mut checks);
        // The torque that starts a string is no load of one that turns.
        checks.checks.retain(|check| check.kind != CheckKind::Breakaway);
        let compressed = compressed(model, operation, recent);
        let line = buckling::Line::of(model, operation, &compressed);
        checks.checks.extend(buckling::checks(&line, &self.limits));
        let hook_load_N = loads.hook_load_N.mean;
        checks.checks.extend(descent::goes_down(model, operation, hook_load_N, None));
        let set_N = recent.weight_on_bit_set_N.last().copied().filter(|set_N| *set_N > 0.0);
        let missing = set_N.and_then(|set_N| {
            weight_not_available(model, set_N, available_weight_N(model, operation))
        });
        match missing {
            Some(check) => checks.checks.push(check),
            None => checks.checks.extend(weight_on_bit::recent(recent)),
        }
        checks.checks.extend(motion::recent(settings, recent));
        checks.checks.retain(|check| !check.is_ok());
        let words = Words::of_motion(&model.rig, hook_load_N, recent.indicators);
        self.with_sentences(checks, &words)
    }
}

/// Tension and, of compressed nodes, the critical load of the helix. A sinusoid is no alarm:
/// collars bow wherever they press on a bit.
fn compressed(model: &Model, operation: &Operation, recent: &Recent<'_>) -> Profile {
    let nodes = || recent.largest.md_m.iter().zip(recent.tension_N);
    let critical_N = |(md_m, tension_N): (&f64, &f64)| {
        (*tension_N < 0.0).then(|| {
            let place = Place::above(model, operation.bit_depth_m, *md_m).seen_by(model.buckling);
            place.threshold_N(Shape::Helical, place.wall_load_N_per_m(-tension_N))
        })
    };
    Profile {
        md_m: nodes().map(|(md_m, _)| *md_m).collect(),
        tension_N: nodes().map(|(_, tension_N)| *tension_N).collect(),
        sinusoidal_load_N: nodes().map(|_| None).collect(),
        helical_load_N: nodes().map(critical_N).collect(),
        ..Profile::default()
    }
}
