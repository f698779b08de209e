//! Parallel tasks of a plan, whose results are stored as they finish.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};
use serde_json::json;
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_judge::{CheckKind, Unchecked};
use wholestring_plan::{Broomstick, BroomstickTask, Campaign, FrictionLevel, Statics};
use wholestring_results::{
    PLAN_VERSION, PlanBuckling, PlanCheck, PlanDamage, PlanOperation, PlanPoint, PlanStation,
    PlanSummary, PlanWear, ResultsError, ResultsFolder, Row as _, Texts, plan_limits_table,
    plan_peaks_time_table,
};

use super::{
    campaign::{Counted, Taken, taken, totals},
    checks::{self, governing},
    dynamic::{Parts, Ran, Run, runs},
    files::Tables,
    measured::{Measured, MeasuredDone, MeasuredTask},
    request::Request,
    rows::{self, buckling, checks, frictions, left_out, points, unchecked},
    sample::SampleSolver,
};
use crate::{
    batch::BatchOutcome,
    cancellation::CancellationToken,
    checkpoint::Keeper,
    clock::Instant,
    observer::Observer,
    parallel::jobs,
    run::checkpoint_every,
    tasks::Tasks,
    uncertain::{self, Sampled, Sampler, samples_table},
};

/// Depths closer than this are one, m.
const SAME_M: f64 = 1.0;

/// A task of a plan.
#[derive(Debug, Clone, Copy)]
enum PlanTask {
    /// An operation at a depth, with every friction level.
    Points(BroomstickTask),
    /// An operation of the campaign that is not a point of the plan, with the expected friction.
    Campaign(BroomstickTask),
    /// Weights at which the string buckles at a depth, m.
    Buckling(f64),
    /// A sample of the uncertain inputs.
    Sample(usize),
    /// Prediction of measured readings.
    Measured(MeasuredTask),
    /// A run of the dynamic part.
    Dynamic(Run),
}

/// Outcome of a task.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum Done {
    Points(
        Vec<PlanPoint>,
        #[serde(with = "checks")] Vec<PlanCheck>,
        BTreeSet<Unchecked>,
        Vec<Taken>,
    ),
    Campaign(Vec<Taken>),
    Buckling(Vec<PlanBuckling>),
    Sample(Sampled),
    Measured(MeasuredDone),
    Dynamic(Ran),
}

/// Outcome of the work.
pub(super) struct Ended {
    pub(super) summary: PlanSummary,
    pub(super) tables: Tables,
    pub(super) batch: BatchOutcome,
}

/// Checks of depths at which the operation is done: nothing is drilled, slid or reamed above the
/// section of the campaign.
fn of_section(checks: &[PlanCheck], campaign: Option<&Campaign>) -> Vec<PlanCheck> {
    let is_done = |row: &&PlanCheck| {
        let PlanOperation::Kind(kind) = row.operation else { return true };
        let from_m = campaign.and_then(|campaign| campaign.done_from_m(kind));
        from_m.is_none_or(|from_m| row.bit_depth_m >= from_m - SAME_M)
    };
    checks.iter().filter(is_done).cloned().collect()
}

/// Checks that are relevant to a plan: without those of depths at which the string is too light for
/// the requested weight on bit, if it is heavy enough at the deepest.
fn relevant(checks: &[PlanCheck]) -> Vec<PlanCheck> {
    let is_too_light = |row: &PlanCheck| row.check.kind == CheckKind::WeightNotAvailable;
    let is_alike = |row: &PlanCheck, other: &PlanCheck| {
        (row.model, row.operation, row.friction) == (other.model, other.operation, other.friction)
    };
    let too_light: Vec<&PlanCheck> = checks
        .iter()
        .filter(|row| is_too_light(row))
        .filter(|light| {
            let deeper = |row: &&PlanCheck| {
                is_alike(row, light) && row.bit_depth_m > light.bit_depth_m && !is_too_light(row)
            };
            let deepest = checks.iter().filter(deeper).map(|row| row.bit_depth_m);
            let deepest_m = deepest.fold(f64::NEG_INFINITY, f64::max);
            !checks.iter().any(|row| {
                is_alike(row, light) && is_too_light(row) && row.bit_depth_m >= deepest_m
            })
        })
        .collect();
    let matters = |row: &&PlanCheck| {
        let mut shallow = too_light.iter();
        !shallow.any(|light| is_alike(row, light) && row.bit_depth_m == light.bit_depth_m)
    };
    checks.iter().filter(matters).cloned().collect()
}

/// The most severe check of each kind and operation, among equals the one with the least reserve,
/// in the order of the kinds.
fn worst(checks: &[PlanCheck]) -> Vec<PlanCheck> {
    let mut found: Vec<&PlanCheck> = Vec::new();
    for row in checks {
        let is_same = |other: &&PlanCheck| {
            other.check.kind == row.check.kind && other.operation == row.operation
        };
        match found.iter().position(is_same) {
            Some(place) if is_worse(checks, row, found[place]) => found[place] = row,
            Some(_) => {}
            None => found.push(row),
        }
    }
    found.sort_by_key(|row| row.check.kind);
    found.into_iter().cloned().collect()
}

/// Of equal checks, the one at the deeper bit is the worse. Strings that go down by their weight
/// are ranked by the reserve of their lock-up: the hook load is the least of the shortest string.
fn is_worse(checks: &[PlanCheck], row: &PlanCheck, other: &PlanCheck) -> bool {
    let deeper = row.bit_depth_m.total_cmp(&other.bit_depth_m);
    let goes_down = |row: &PlanCheck| row.check.kind == CheckKind::GoesDown && row.check.is_ok();
    if goes_down(row) && goes_down(other) {
        let reserve = |row: &PlanCheck| {
            let mut alike = checks.iter();
            let lock_up = alike.find(|alike| {
                alike.check.kind == CheckKind::LockUp
                    && (alike.model, alike.operation, alike.friction)
                        == (row.model, row.operation, row.friction)
                    && alike.bit_depth_m == row.bit_depth_m
            });
            lock_up.map_or(f64::INFINITY, |lock_up| lock_up.check.reserve())
        };
        return reserve(other).total_cmp(&reserve(row)).then(deeper).is_gt();
    }
    row.check.cmp_severity(&other.check).then(deeper).is_gt()
}

/// Solvers of the tasks.
#[derive(Clone, Copy)]
pub(super) struct Solvers<'a> {
    /// Every operation at every depth.
    pub(super) broomstick: &'a Broomstick,
    /// Predictions of measured readings.
    pub(super) measured: &'a Measured,
    /// Samples of uncertain inputs, if there are any.
    pub(super) sampler: Option<&'a Sampler<'a>>,
}

/// Tasks that are solved together.
pub(super) struct Work<'a> {
    request: &'a Request<'a>,
    broomstick: &'a Broomstick,
    measured: &'a Measured,
    sampler: Option<&'a Sampler<'a>>,
    folder: &'a ResultsFolder,
    list: Vec<PlanTask>,
    tasks: Tasks<'a, Done>,
    cancellation: &'a CancellationToken,
    start: Instant,
}

impl<'a> Work<'a> {
    /// Creates the tasks of a plan, without those finished earlier in its folder if the plan is
    /// resumed.
    pub(super) fn new(
        request: &'a Request<'a>,
        Solvers { broomstick, measured, sampler }: Solvers<'a>,
        identity: String,
        folder: &'a ResultsFolder,
        observer: &'a dyn Observer,
        cancellation: &'a CancellationToken,
    ) -> Result<Self, ResultsError> {
        let points = broomstick.tasks().into_iter().map(PlanTask::Points);
        let depths = broomstick.depths_m().iter().copied().map(PlanTask::Buckling);
        let read = measured.tasks(request).into_iter().map(PlanTask::Measured);
        let runs = runs(request.case, broomstick).into_iter().map(PlanTask::Dynamic);
        let samples = (0..sampler.map_or(0, |sampler| sampler.points.len())).map(PlanTask::Sample);
        let campaign = broomstick.campaign_tasks().into_iter().map(PlanTask::Campaign);
        let points = points.chain(campaign);
        let list: Vec<PlanTask> =
            points.chain(depths).chain(read).chain(runs).chain(samples).collect();
        let every = request.checkpoint_every.unwrap_or_else(|| checkpoint_every(request.case));
        let to_solve = Tasks::new(
            (list.len(), identity),
            (folder, request.output.existing),
            Keeper::new(folder, every),
            observer,
            cancellation,
        )?;
        let start = Instant::now();
        Ok(Self {
            request,
            broomstick,
            measured,
            sampler,
            folder,
            list,
            tasks: to_solve,
            cancellation,
            start,
        })
    }

    /// Solves the remaining tasks, the deepest and slowest first and samples last, so that the last
    /// jobs are short.
    pub(super) fn solve_all(&self) -> Result<(), ResultsError> {
        let mut order: Vec<usize> = (0..self.list.len()).collect();
        let weight = |task: &usize| match self.list[*task] {
            PlanTask::Points(task)
            | PlanTask::Campaign(task)
            | PlanTask::Measured(MeasuredTask { task, .. }) => {
                (1 + u8::from(task.model == Statics::Stiff), task.operation.bit_depth_m)
            }
            PlanTask::Buckling(depth_m) => (1, 10.0 * depth_m),
            PlanTask::Dynamic(run) => (3, run.bit_depth_m()),
            PlanTask::Sample(_) => (0, 0.0),
        };
        order.sort_by(|a, b| {
            let (a, b) = (weight(a), weight(b));
            b.0.cmp(&a.0).then(b.1.total_cmp(&a.1))
        });
        let solver = self.sample_solver();
        self.tasks.solve_all(&order, jobs(self.request.jobs), |task| {
            self.solve(self.list[task], solver.as_ref())
        })
    }

    /// Quantities that samples compute.
    fn sample_solver(&self) -> Option<SampleSolver<'a>> {
        let plan = &self.request.case.plan;
        Some(SampleSolver::new(self.sampler?, &plan.operations, &plan.bit_depths_m))
    }

    /// Solves a task; `None` if it is cancelled before its end.
    fn solve(&self, task: PlanTask, solver: Option<&SampleSolver<'_>>) -> Option<Done> {
        let broomstick = self.broomstick;
        Some(match task {
            PlanTask::Points(task) => {
                let found = broomstick.solve(&task);
                let (checks, unchecked) = (checks(&found), unchecked(&found));
                Done::Points(points(&found), checks, unchecked, taken(broomstick, &found))
            }
            PlanTask::Campaign(task) => Done::Campaign(taken(
                broomstick,
                &broomstick.solve_at(&task, &[FrictionLevel::Expected]),
            )),
            PlanTask::Buckling(depth_m) => {
                Done::Buckling(buckling(&broomstick.weights_to_buckle(depth_m), broomstick.judge()))
            }
            PlanTask::Measured(task) => Done::Measured(self.measured.solve(&task)),
            PlanTask::Dynamic(run) => {
                let goes_on = || !self.cancellation.is_cancelled();
                Done::Dynamic(run.solve(self.request.case, broomstick, &goes_on)?)
            }
            PlanTask::Sample(sample) => {
                Done::Sample(solver.map(|solver| solver.solve(sample)).unwrap_or_default())
            }
        })
    }

    /// Results of the tasks, and how many ended.
    pub(super) fn end(self) -> Ended {
        let case = self.request.case;
        let all = self.list.len();
        let solver = self.sample_solver();
        let mut batch = BatchOutcome::begin(self.folder.path(), all, self.start, self.cancellation);
        batch.finished = self.tasks.ended();
        let done = self.tasks.into_done();
        let (mut points, mut weights) = (Vec::new(), Vec::new());
        let (mut all_limits, mut lacking) = (Vec::new(), BTreeSet::new());
        let (mut all_taken, mut all_measured) = (Vec::new(), Vec::new());
        let mut sampled = Vec::new();
        let is_run = |task: &&PlanTask| matches!(task, PlanTask::Dynamic(_));
        let run_count = self.list.iter().filter(is_run).count();
        let mut parts = Parts::of(run_count);
        for (task, one) in self.list.iter().zip(done) {
            let Some(one) = one else {
                if let PlanTask::Sample(_) = task {
                    sampled.push(None);
                }
                continue;
            };
            match one {
                Done::Points(found, limits, unchecked, taken) => {
                    all_taken.extend(taken);
                    points.extend(found);
                    all_limits.extend(limits);
                    lacking.extend(unchecked);
                }
                Done::Campaign(taken) => all_taken.extend(taken),
                Done::Buckling(rows) => weights.extend(rows),
                Done::Sample(sample) => sampled.push(Some(sample)),
                Done::Measured(measured) => all_measured.push(measured),
                Done::Dynamic(ran) => parts.add(ran),
            }
        }
        let plan = &case.plan;
        let parts_of_campaign = Counted::of(self.broomstick, &all_taken);
        let totals = totals(self.broomstick, &plan.models, &all_taken, parts.whole_wear());
        // Sorted curve by curve, because a task contains the friction levels of one depth.
        let models: Vec<ModelKind> = plan.models.iter().map(|model| model.kind()).collect();
        let operations: Vec<OperationKind> =
            plan.operations.iter().map(|operation| operation.kind).collect();
        points.sort_by(|a: &PlanPoint, b: &PlanPoint| {
            let key = |point: &PlanPoint| {
                let model = models.iter().position(|model| *model == point.model);
                let operation = operations.iter().position(|kind| *kind == point.operation);
                (model, operation, point.friction as usize)
            };
            key(a).cmp(&key(b)).then(a.bit_depth_m.total_cmp(&b.bit_depth_m))
        });
        weights.sort_by(|a: &PlanBuckling, b: &PlanBuckling| {
            let key =
                |buckling: &PlanBuckling| (buckling.operation.name(), buckling.friction as usize);
            key(a).cmp(&key(b)).then(a.bit_depth_m.total_cmp(&b.bit_depth_m))
        });
        let levels = FrictionLevel::ALL.len();
        let expected = levels * models.len() * operations.len() * plan.bit_depths_m.len();
        let uncertain = self.sampler.zip(solver).map(|(sampler, solver)| {
            let quantities = solver.quantities(&points, &all_limits, &weights);
            let model = sampler.uncertain.model.kind();
            let found = uncertain::summary(sampler, model, &quantities, &[], &sampled);
            (found, samples_table(sampler, &sampled))
        });
        let (uncertain, samples) = uncertain.unzip();
        let mut settings = case.settings.clone();
        settings["plan"] = json!({
            "bit_depths_m": plan.bit_depths_m,
            "operations": operations,
            "models": models,
            "limits": plan.limits,
            "campaign": plan.campaign,
            "measured": plan.measured.as_ref().map(|measured| &measured.file),
        });
        if let Some(uncertain) = &plan.uncertain {
            settings["plan"]["uncertain"] = json!(uncertain);
        }
        all_limits.extend(parts.limits);
        let mut unchecked = left_out(case);
        unchecked.extend(Unchecked::phrases(&lacking));
        let mut texts = Texts::default();
        let mut worded = |all: Vec<String>| -> Vec<String> {
            all.into_iter().map(|text| texts.worded(text, case.units)).collect()
        };
        unchecked.extend(worded(parts.lacking));
        let [counted, not_counted] =
            [parts_of_campaign.counted, parts_of_campaign.not_counted].map(worded);
        let unsolved = all_measured.iter().flat_map(|measured| &measured.points);
        let unsolved = unsolved.filter(|point| point.message.is_some());
        unsolved.filter_map(|point| point.worst.as_ref()).for_each(|check| texts.record(check));
        let hydraulics = rows::rows(case).unwrap_or_else(|why| {
            unchecked.push(why);
            Vec::new()
        });
        let along = rows::along(case, self.broomstick);
        let relevant = relevant(&of_section(&all_limits, self.broomstick.campaign()));
        let mut summary = PlanSummary {
            schema_version: PLAN_VERSION,
            case: case.name.clone(),
            settings,
            frictions: frictions(self.broomstick),
            models,
            operations,
            bit_depths_m: plan.bit_depths_m.clone(),
            missing: expected - points.len(),
            points,
            buckling: weights,
            checks: worst(&relevant),
            governing: governing(&relevant),
            surface_limits: rows::limits(self.broomstick, &plan.limits),
            unchecked,
            counted,
            not_counted,
            hydraulics,
            fatigue: totals.fatigue,
            wear: totals.worst_wear,
            uncertain,
            measured: self.measured.rows(self.request, &all_measured),
            overlay: None,
            peaks: parts.peaks,
            texts,
        };
        if !plan.dynamic.events.is_empty() || !plan.dynamic.wear.is_empty() {
            summary.settings["plan"]["dynamic"] = json!(plan.dynamic);
        }
        let events: Vec<_> = summary.peaks.iter().zip(&parts.histories).collect();
        let tables = Tables {
            along: PlanStation::table(&along),
            limits: plan_limits_table(&all_limits),
            fatigue: PlanDamage::table(&totals.damage),
            wear: PlanWear::table(&totals.wear),
            samples,
            peaks_time: plan_peaks_time_table(&events),
        };
        Ended { summary, tables, batch }
    }
}
