//! Maximum reach of a well in its last direction, and the limit that stops it.

mod operations;
mod sample;
mod tables;

pub use crate::uncertain::{notes as uncertain_notes, scatter};
pub(crate) use operations::operation;
pub use wholestring_report::{end_of_limit, reach_answers as answers, reach_notes as notes};

use std::{collections::BTreeSet, num::NonZeroUsize, path::PathBuf, sync::Mutex, time::Duration};

use serde_json::json;
use wholestring::operation::{Operation, OperationKind};
use wholestring_case::{Case, Override, Template};
use wholestring_judge::Unchecked;
use wholestring_plan::{
    Setup,
    reach::{Curve, End, OperationReach, ReachError, ReachSettings, first_stop, reach_unless},
};
use wholestring_report::Reach;
use wholestring_results::{
    Occupant, REACH_VERSION, ReachLimit, ReachOfFriction, ReachStop, ReachSummary, UncertainTables,
    digest,
};
use wholestring_units::{Dimension, UnitSet};

use self::{
    operations::{Operations, operations},
    sample::{SampleSolver, with_friction},
    tables::{LIMITS, REACH, reach_table},
};
use crate::{
    batch::BatchOutcome,
    cancellation::CancellationToken,
    claim::Claim,
    clock::Instant,
    error::Error,
    observer::Observer,
    output::Output,
    parallel::{in_parallel, jobs, lock},
    results_kind::Results,
    run::checkpoint_every,
    uncertain::{self, Sampler},
};

// Request of a reach, and its outcome.

/// Request to find the reach of a case.
#[derive(Debug)]
pub struct Request<'a> {
    /// The case.
    pub case: &'a Case,
    /// Text of the case, which is read again with each sample of its uncertain inputs.
    pub template: &'a Template,
    /// Changes of the case.
    pub overrides: &'a [Override],
    /// First depth of the bit, m; by default the end of the survey.
    pub from_m: Option<f64>,
    /// Deepest bit, m; by default 15 km, or twice the first depth if that is deeper.
    pub to_m: Option<f64>,
    /// Friction factors that are applied to all sections one after the other; if empty, the case's
    /// own.
    pub frictions: Vec<f64>,
    /// The operations; if empty, pick-up, slack-off, rotating off bottom, drilling, sliding and
    /// those of the case, if the case has their set points.
    pub operations: Vec<OperationKind>,
    /// Whether the wall force of a helix causes friction; without it a string never locks up.
    pub helix_side_force: bool,
    /// Whether the string stops at the onset of its helix, although it could advance buckled.
    pub stop_at_helix: bool,
    /// Units of the pictures and the page; by default those of the case.
    pub units: Option<UnitSet>,
    /// Destination of the results.
    pub output: Output,
    /// Whether to also write a PNG image.
    pub png: bool,
    /// Number of parallel jobs, an operation each; one per core by default.
    pub jobs: Option<NonZeroUsize>,
}

/// Outcome of a reach.
#[derive(Debug)]
pub struct Outcome {
    /// Results, as in `summary.json`.
    pub summary: ReachSummary,
    /// Folder of the results.
    pub folder: PathBuf,
    /// Wall-clock time, without writing.
    pub took: Duration,
    /// Number of finished samples; `None` if no input is uncertain, or after an interruption before
    /// the first.
    pub samples: Option<BatchOutcome>,
    /// Whether it was interrupted before every operation was solved; the summary names the missing
    /// ones.
    pub interrupted: bool,
}

impl<'a> Request<'a> {
    /// Request with default options.
    pub fn new(case: &'a Case, template: &'a Template, overrides: &'a [Override]) -> Self {
        Self {
            case,
            template,
            overrides,
            from_m: None,
            to_m: None,
            frictions: Vec::new(),
            operations: Vec::new(),
            helix_side_force: true,
            stop_at_helix: false,
            units: None,
            output: Output::default(),
            png: false,
            jobs: None,
        }
    }

    fn settings(&self) -> Result<ReachSettings, Error> {
        let bad = |text: String| Err(Error::BadInput(text));
        let units = self.units.unwrap_or(self.case.units);
        let depth = |md_m: f64| Dimension::Length.format(md_m, units);
        let setup = self.case.setup();
        let least_m = setup.least_depth_m();
        // A string that runs in a hole above the end of its survey, as a casing does, begins there.
        let well = &self.case.model.well;
        let hole_m = well.hole.sections().last().map_or(f64::INFINITY, |section| section.to_md_m);
        let end_m = well.path.last_md_m().min(hole_m);
        let from_m = self.from_m.unwrap_or(end_m.max(least_m + 1.0));
        let mut settings = ReachSettings::from_depth(from_m);
        settings.to_m = self.to_m.unwrap_or(settings.to_m);
        settings.soft.helix_side_force = self.helix_side_force;
        settings.stop_at_helix = self.stop_at_helix;
        settings.factors = self.case.plan.limits.factors;
        if from_m <= least_m {
            return bad(format!(
                "the reach begins with the bit at {}: expected more than {}",
                depth(from_m),
                depth(least_m)
            ));
        }
        if settings.to_m <= from_m {
            return bad(format!(
                "the reach ends at {}, which is not below its beginning at {}",
                depth(settings.to_m),
                depth(from_m)
            ));
        }
        if settings.to_m > DEEPEST_M {
            let (to, most) = (depth(settings.to_m), depth(DEEPEST_M));
            return bad(format!("the reach ends at {to}: {most} is the most"));
        }
        for friction in &self.frictions {
            if !(0.0..=MAX_FRICTION).contains(friction) {
                return bad(format!("a friction factor of {friction} is outside 0 to 2"));
            }
        }
        Ok(settings)
    }

    /// String and well at each friction factor.
    fn setups(&self) -> Result<Vec<(Option<f64>, Setup)>, Error> {
        let all: Vec<Option<f64>> = match self.frictions.is_empty() {
            true => vec![None],
            false => self.frictions.iter().copied().map(Some).collect(),
        };
        let with = |friction: Option<f64>| Ok((friction, with_friction(self.case, friction)?));
        all.into_iter().map(with).collect()
    }
}

/// Deepest bit that the soft string allows, m.
const DEEPEST_M: f64 = 1e5;

/// Largest friction factor allowed by the case file.
const MAX_FRICTION: f64 = 2.0;

/// Finds the reach of the well of a case, and writes tables, picture and page. After a cancellation
/// the solved operations are kept.
///
/// # Errors
/// Depths or friction factors out of their range, an operation whose set points are not in the
/// case, a folder that cannot take the results, a soft string without a solution, or a cancellation
/// before the first operation was solved.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Outcome, Error> {
    let case = request.case;
    let settings = request.settings()?;
    let Operations { all, left_out } = operations(case, &request.operations)?;
    let setups = request.setups()?;
    let name = format!("{} reach", case.name);
    let kinds: Vec<OperationKind> = all.iter().map(|operation| operation.kind).collect();
    let inputs = json!([settings.from_m, settings.to_m, request.frictions, kinds]);
    let uncertain = &case.plan.uncertain;
    let helix = [request.helix_side_force, request.stop_at_helix];
    let identity = digest(&json!([case.identity(), inputs, helix, uncertain]));
    let occupant =
        Occupant { kind: "reach".into(), name: name.clone(), identity: identity.clone() };
    let claimed = Claim {
        is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
        ..Claim::new(occupant, &request.output, observer)
    }
    .folder()?;
    let begun = Instant::now();
    let jobs = jobs(request.jobs);
    let found = solve(&setups, &all, &settings, jobs, cancellation)?;
    let folder = &claimed.folder;
    let interrupted = found.iter().any(Option::is_none);
    let each = found.chunks(all.len().max(1)).zip(&setups);
    let answers: Vec<Answer> =
        each.map(|(found, (friction, _))| Answer::of(*friction, found, &all)).collect();
    if answers.iter().all(|answer| answer.reaches.is_empty()) && interrupted {
        return Err(Error::Interrupted);
    }
    let own: Vec<OperationReach> =
        answers.iter().flat_map(|answer| answer.reaches.clone()).collect();
    let sampler = Sampler::of(case, request.template, request.overrides).filter(|_| !interrupted);
    let solver = sampler.as_ref().map(|sampler| SampleSolver {
        sampler,
        settings: &settings,
        frictions: setups.iter().map(|(friction, _)| *friction).collect(),
        own: &own,
        kinds: all.iter().map(|operation| operation.kind).collect(),
    });
    let every = checkpoint_every(case);
    let samples = solver.map(|solver| {
        let place = (folder, request.output.existing, every);
        solver.solve_all(identity, place, jobs, observer, cancellation)
    });
    let samples = samples.transpose()?;
    let took = begun.elapsed();
    let bit = case.model.well.path.at(settings.from_m);
    let frictions = answers.iter().zip(&setups).map(|(answer, (_, setup))| {
        answer.summary(setup.well.hole.at(settings.to_m).friction.kinetic)
    });
    let frictions: Vec<ReachOfFriction> = frictions.collect();
    let judge = case.judge(request.units.unwrap_or(case.units));
    let planned_m =
        case.operations.iter().map(|operation| operation.bit_depth_m).fold(0.0, f64::max);
    let rows: Vec<_> =
        answers.iter().map(|answer| (answer.friction, &answer.reaches[..])).collect();
    let rig_pushes = case.model.rig.snubbing_force_N.is_some();
    let ends_m = [settings.from_m, settings.to_m];
    let checks = operations::checks(&rows, ends_m, planned_m, rig_pushes, &judge);
    let unchecked: BTreeSet<&Unchecked> = answers
        .iter()
        .flat_map(|answer| &answer.reaches)
        .flat_map(|reach| &reach.unchecked)
        .collect();
    let summary = ReachSummary {
        schema_version: REACH_VERSION,
        case: case.name.clone(),
        settings: case.settings.clone(),
        from_m: settings.from_m,
        to_m: settings.to_m,
        inclination_rad: bit.inclination_rad(),
        helix_side_force: request.helix_side_force,
        stop_at_helix: request.stop_at_helix,
        left_out,
        unchecked: Unchecked::phrases(unchecked),
        frictions,
        checks,
        uncertain: samples.as_ref().map(|(_, found, _)| found.clone()),
    };
    let written = samples.as_ref().map(|(_, found, table)| (found, table));
    uncertain::write(folder, &UncertainTables::REACH, written)?;
    uncertain::write_picture_numbers(folder, summary.uncertain.as_ref())?;
    // Also as CSV, because the page links to them.
    let margins = reach_table(&rows);
    folder.write_table(REACH, &margins, false)?;
    tables::picture(&margins, &summary).write_csv(&folder.path().join(format!("{REACH}.csv")))?;
    folder.write_table(LIMITS, &summary.limits_table(), true)?;
    summary.write(&folder.path().join("summary.json"))?;
    let units = request.units.unwrap_or(case.units);
    Reach::gather(folder.path(), Some(units))?.write(folder, request.png)?;
    let samples = samples.map(|(batch, ..)| batch);
    Ok(Outcome { summary, folder: folder.path().to_owned(), took, samples, interrupted })
}

/// The operations at a friction factor.
struct Answer {
    friction: Option<f64>,
    reaches: Vec<OperationReach>,
    /// Operations that were not solved.
    missing: Vec<OperationKind>,
}

impl Answer {
    fn of(
        friction: Option<f64>,
        found: &[Option<OperationReach>],
        operations: &[Operation],
    ) -> Self {
        let unsolved = found.iter().zip(operations).filter(|(found, _)| found.is_none());
        let missing = unsolved.map(|(_, unsolved)| unsolved.kind).collect();
        Self { friction, reaches: found.iter().flatten().cloned().collect(), missing }
    }

    fn summary(&self, friction_at_bit: f64) -> ReachOfFriction {
        let first = first_stop(&self.reaches).and_then(|(reach, curve)| {
            Some(ReachStop {
                operation: reach.kind,
                limit: curve.limit,
                depth_m: curve.end.depth_m()?,
            })
        });
        let limits = self.reaches.iter().flat_map(|reach| {
            let limit = |curve: &Curve| limit(reach.kind, curve);
            reach.curves.iter().map(limit).collect::<Vec<_>>()
        });
        ReachOfFriction {
            friction: self.friction,
            friction_at_bit,
            critical_inclination_rad: (friction_at_bit > 0.0)
                .then(|| libm::atan(1.0 / friction_at_bit)),
            first,
            limits: limits.collect(),
            missing: self.missing.clone(),
        }
    }
}

/// Solves every operation at every friction factor, ordered by friction; operations that were not
/// finished at a cancellation are left out.
fn solve(
    setups: &[(Option<f64>, Setup)],
    operations: &[Operation],
    settings: &ReachSettings,
    jobs: usize,
    cancellation: &CancellationToken,
) -> Result<Vec<Option<OperationReach>>, Error> {
    let order: Vec<usize> = (0..setups.len() * operations.len()).collect();
    let done: Vec<_> = order.iter().map(|_| Mutex::new(None)).collect();
    in_parallel(jobs, &order, |index| {
        let (_, setup) = &setups[index / operations.len()];
        let operation = &operations[index % operations.len()];
        let found = reach_unless(setup, operation, settings, &|| cancellation.is_cancelled());
        *lock(&done[index]) = match found {
            Err(ReachError::Stopped) => None,
            found => Some(found),
        };
    });
    done.iter().map(|done| lock(done).take().transpose().map_err(Error::failed)).collect()
}

fn limit(operation: OperationKind, curve: &Curve) -> ReachLimit {
    let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
    ReachLimit {
        operation,
        limit: curve.limit,
        title: curve.limit.title().into(),
        stops: curve.stops,
        depth_m: curve.end.depth_m(),
        already: matches!(curve.end, End::Already(_)),
        locked_up_m: curve.end.locked_up_m(),
        margin_at_from: finite(curve.margins.first().map(|margin| margin.margin)),
        margin_at_to: finite(curve.margins.last().map(|margin| margin.margin)),
        at_md_m: curve.there.at_md_m,
    }
}
