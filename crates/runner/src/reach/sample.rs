//! Samples of a reach: the reach with sampled inputs of the case.

use std::time::Duration;

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::Case;
use wholestring_judge::DepthLimit;
use wholestring_plan::{
    Setup,
    reach::{Curve, End, OperationReach, ReachSettings, first_stop, reach},
};
use wholestring_results::{ResultsFolder, Table, UncertainSummary};

use super::operations::operations;
use crate::{
    batch::BatchOutcome,
    cancellation::CancellationToken,
    checkpoint::Keeper,
    clock::Instant,
    error::Error,
    observer::Observer,
    output::Existing,
    tasks::Tasks,
    uncertain::{Quantity, Sampled, Sampler, samples_table, summary},
};

/// Margins are clipped to this range, because the margin of a locked-up string is infinite.
const MARGIN: [f64; 2] = [-1.0, 1.0];

/// Quantities that each sample of a reach computes, in order.
pub(super) struct SampleSolver<'a> {
    pub(super) sampler: &'a Sampler<'a>,
    pub(super) settings: &'a ReachSettings,
    /// Friction factors of all sections; `None` for their own.
    pub(super) frictions: Vec<Option<f64>>,
    /// Results of the case itself: every operation at each friction factor.
    pub(super) own: &'a [OperationReach],
    pub(super) kinds: Vec<OperationKind>,
}

/// Depth of the limit, or the deepest one evaluated, m.
fn depth_m(end: End) -> f64 {
    match end {
        End::At(depth_m)
        | End::Already(depth_m)
        | End::NoneTo(depth_m)
        | End::LockedUp(depth_m) => depth_m,
    }
}

impl SampleSolver<'_> {
    /// The case's own reaches at each friction.
    fn own(&self) -> impl Iterator<Item = (Option<f64>, &[OperationReach])> {
        let chunks = self.own.chunks(self.kinds.len().max(1));
        self.frictions.iter().copied().zip(chunks)
    }

    /// The quantities in the order of the answers.
    fn quantities(&self) -> Vec<Quantity> {
        let mut all = Vec::new();
        for (friction, reaches) in self.own() {
            let depth = |operation, limit, expected| Quantity {
                friction,
                limit,
                expected,
                to_m: Some(self.settings.to_m),
                ..Quantity::new("depth", operation, "m")
            };
            let first_m = first_stop(reaches).and_then(|(_, curve)| curve.end.depth_m());
            all.push(depth(None, "", first_m));
            for reache in reaches {
                for curve in &reache.curves {
                    let name = curve.limit.name();
                    all.push(depth(Some(reache.kind), name, curve.end.depth_m()));
                    if !curve.stops {
                        continue;
                    }
                    let margin = |(bit_depth_m, own): (&f64, &f64)| Quantity {
                        friction,
                        limit: name,
                        bit_depth_m: Some(*bit_depth_m),
                        expected: Some(*own).filter(|own| own.is_finite()),
                        is_owed: false,
                        ..Quantity::new("margin", Some(reache.kind), "1")
                    };
                    let own: Vec<f64> = curve.margins.iter().map(|margin| margin.margin).collect();
                    all.extend(reache.depth_m.iter().zip(&own).map(margin));
                }
            }
        }
        all
    }

    /// Solves all samples except those already solved, and summarises them.
    pub(super) fn solve_all(
        &self,
        identity: String,
        (folder, existing, every): (&ResultsFolder, Existing, Duration),
        jobs: usize,
        observer: &dyn Observer,
        cancellation: &CancellationToken,
    ) -> Result<(BatchOutcome, UncertainSummary, Table), Error> {
        let (begun, count) = (Instant::now(), self.sampler.points.len());
        let keeper = Keeper::new(folder, every);
        let tasks =
            Tasks::new((count, identity), (folder, existing), keeper, observer, cancellation)?;
        let quantities = self.quantities();
        let order: Vec<usize> = (0..count).collect();
        tasks.solve_all(&order, jobs, |sample| Some(self.solve(sample, quantities.len())))?;
        let mut batch = BatchOutcome::begin(folder.path(), count, begun, cancellation);
        batch.finished = tasks.ended();
        let sampled = tasks.into_done();
        let found = summary(self.sampler, ModelKind::Soft, &quantities, &self.frictions, &sampled);
        Ok((batch, found, samples_table(self.sampler, &sampled)))
    }

    /// Solves a sample.
    fn solve(&self, sample: usize, answers: usize) -> Sampled {
        let found = self.sampler.case(sample).and_then(|case| self.reaches(&case));
        let found = match found {
            Ok(found) => found,
            Err(message) => return Sampled::none(answers, self.own.len(), message),
        };
        let mut sampled = Sampled::default();
        let reached = found.chunks(self.kinds.len().max(1));
        for ((_, own), found) in self.own().zip(reached) {
            let sound: Vec<OperationReach> =
                found.iter().filter_map(|reach| reach.as_ref().ok().cloned()).collect();
            // The first stop is known only if all operations are.
            let first = (sound.len() == own.len()).then(|| first_stop(&sound));
            let to_m = self.settings.to_m;
            let of_first = |reach: Option<(&OperationReach, &Curve)>| {
                reach.map_or(to_m, |(_, curve)| depth_m(curve.end))
            };
            sampled.answers.push(first.map(of_first));
            let stop = first.flatten();
            sampled.stops.push(stop.map(|(reach, curve)| (reach.kind, curve.limit)));
            for (own, found) in own.iter().zip(found) {
                if let Err(message) = found {
                    sampled.lacks(|| format!("{}: {message}", own.kind));
                }
                for curve in &own.curves {
                    let found = found.as_ref().ok().and_then(|found| of_limit(found, curve.limit));
                    sampled.answers.push(found.map(|curve| depth_m(curve.end)));
                    if curve.stops {
                        let margins = (0..own.depth_m.len()).map(|row| {
                            let margin = found?.margins.get(row)?.margin;
                            Some(margin.clamp(MARGIN[0], MARGIN[1]))
                                .filter(|value| value.is_finite())
                        });
                        sampled.answers.extend(margins);
                    }
                }
            }
        }
        sampled
    }

    /// Every operation at every friction factor.
    fn reaches(&self, case: &Case) -> Result<Vec<Result<OperationReach, String>>, String> {
        let operations = operations(case, &self.kinds).map_err(|error| error.to_string())?.all;
        let mut all = Vec::new();
        for friction in &self.frictions {
            let setup = with_friction(case, *friction).map_err(|error| error.to_string())?;
            all.extend(operations.iter().map(|operation| {
                reach(&setup, operation, self.settings).map_err(|error| error.to_string())
            }));
        }
        Ok(all)
    }
}

fn of_limit(reach: &OperationReach, limit: DepthLimit) -> Option<&Curve> {
    reach.curves.iter().find(|curve| curve.limit == limit)
}

/// String and well of a case, with one friction factor in all sections instead of their own.
pub(super) fn with_friction(case: &Case, friction: Option<f64>) -> Result<Setup, Error> {
    let own = case.setup();
    let Some(friction) = friction else { return Ok(own) };
    let mut setup = own.clone();
    setup.well.hole = own.well.hole.with_friction(friction).map_err(Error::failed)?;
    Ok(setup)
}
