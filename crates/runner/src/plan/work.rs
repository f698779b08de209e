//! The work of a plan, on all cores, kept as it comes.

use std::{collections::BTreeSet, sync::Mutex, thread, time::Instant};

use serde::{Deserialize, Serialize};
use serde_json::json;
use wholestring_plan::{Broomstick, BroomstickTask, FrictionLevel, Statics, limits::LimitKind};
use wholestring_results::{
    PLAN_VERSION, PlanBuckling, PlanLimit, PlanPoint, PlanSummary, ResultsError, ResultsFolder,
    plan_fatigue_table, plan_limits_table, plan_peaks_time_table, plan_wear_table,
};

use super::{
    campaign::{Taken, came, taken},
    dynamic::{Parts, Ran, Run, runs},
    files::Tables,
    mud,
    request::Request,
    rows::{Lack, buckling, frictions, in_words, limits, points, unchecked},
};
use crate::{
    batch::BatchOutcome,
    cancellation::CancellationToken,
    checkpoint::Keeper,
    observer::{BatchSize, CaseEnded, Observer},
    output::Existing,
    parallel::{in_parallel, lock},
    run::checkpoint_every,
};

/// A piece of the work.
#[derive(Debug, Clone, Copy)]
enum Piece {
    /// An operation at a depth, with every friction.
    Points(BroomstickTask),
    /// The weights to buckle at a depth, m.
    Buckling(f64),
    /// What the dynamics is asked for.
    Dynamic(Run),
}

/// What came of a piece.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum Done {
    Points(Vec<PlanPoint>, Vec<PlanLimit>, BTreeSet<Lack>, Vec<Taken>),
    Buckling(Vec<PlanBuckling>),
    Dynamic(Ran),
}

/// What is kept of the work, and whose work it is.
#[derive(Serialize, Deserialize)]
struct Kept<D> {
    identity: String,
    done: D,
}

/// What became of the work.
pub(super) struct Ended {
    pub(super) summary: PlanSummary,
    pub(super) tables: Tables,
    pub(super) batch: BatchOutcome,
}

/// Of each kind and each operation the limit with the least reserve, in the order of the kinds.
fn worst(limits: &[PlanLimit]) -> Vec<PlanLimit> {
    let mut found: Vec<&PlanLimit> = Vec::new();
    for of in limits {
        let same = |one: &&PlanLimit| one.kind == of.kind && one.operation == of.operation;
        match found.iter().position(same) {
            Some(place) if of.reserve() < found[place].reserve() => found[place] = of,
            Some(_) => {}
            None => found.push(of),
        }
    }
    let place = |of: &&PlanLimit| LimitKind::ALL.iter().position(|kind| kind.name() == of.kind);
    found.sort_by_key(place);
    found.into_iter().cloned().collect()
}

/// Pieces that are solved together.
pub(super) struct Work<'a> {
    request: &'a Request<'a>,
    broomstick: &'a Broomstick,
    identity: String,
    folder: &'a ResultsFolder,
    pieces: Vec<Piece>,
    /// What came of each piece, none where nothing has yet.
    done: Mutex<Vec<Option<Done>>>,
    keeper: Mutex<Keeper<'a>>,
    observer: &'a dyn Observer,
    cancellation: &'a CancellationToken,
    start: Instant,
}

impl<'a> Work<'a> {
    /// The work of a plan, less what an earlier one has left in its folder, where that is to be
    /// continued.
    pub(super) fn new(
        request: &'a Request<'a>,
        broomstick: &'a Broomstick,
        identity: String,
        folder: &'a ResultsFolder,
        observer: &'a dyn Observer,
        cancellation: &'a CancellationToken,
    ) -> Result<Self, ResultsError> {
        let tasks = broomstick.tasks().into_iter().map(Piece::Points);
        let depths = broomstick.depths_m().iter().copied().map(Piece::Buckling);
        let runs = runs(request.case, broomstick).into_iter().map(Piece::Dynamic);
        let pieces: Vec<Piece> = tasks.chain(depths).chain(runs).collect();
        let every = request.checkpoint_every.unwrap_or_else(|| checkpoint_every(request.case));
        let work = Self {
            request,
            broomstick,
            identity,
            folder,
            done: Mutex::new(vec![None; pieces.len()]),
            pieces,
            keeper: Mutex::new(Keeper::new(folder, every)),
            observer,
            cancellation,
            start: Instant::now(),
        };
        match request.output.existing {
            Existing::Resume => work.take_up(),
            Existing::Protect | Existing::Overwrite => folder.remove_checkpoint()?,
        }
        Ok(work)
    }

    /// Takes up what an earlier plan of the same case has finished.
    fn take_up(&self) {
        let kept = self.folder.read_checkpoint::<Kept<Vec<Option<Done>>>>();
        let warning = match kept {
            Ok(None) => return,
            Ok(Some(kept)) if kept.identity != self.identity => "it is of another plan".to_owned(),
            Ok(Some(kept)) if kept.done.len() != self.pieces.len() => {
                "it has other pieces".to_owned()
            }
            Ok(Some(kept)) => {
                *lock(&self.done) = kept.done;
                return;
            }
            Err(error) => error.to_string(),
        };
        let place = self.folder.path().display();
        self.observer.warning(&format!("the checkpoint in {place} is left: {warning}"));
    }

    /// Solves what is left, the deepest and slowest first: what is left at the end is short.
    pub(super) fn solve_all(&self) -> Result<(), ResultsError> {
        self.observer.batch_started(&BatchSize {
            cases: self.pieces.len(),
            finished: self.ended(),
            simulated_s: 0.0,
        });
        let mut order: Vec<usize> = (0..self.pieces.len()).collect();
        let weight = |piece: &usize| match self.pieces[*piece] {
            Piece::Points(task) if task.model == Statics::Stiff => (1, task.operation.bit_depth_m),
            Piece::Points(task) => (0, task.operation.bit_depth_m),
            Piece::Buckling(depth_m) => (0, 10.0 * depth_m),
            Piece::Dynamic(run) => (2, run.bit_depth_m()),
        };
        order.sort_by(|a, b| {
            let (a, b) = (weight(a), weight(b));
            b.0.cmp(&a.0).then(b.1.total_cmp(&a.1))
        });
        let jobs = self.request.jobs.or_else(|| thread::available_parallelism().ok());
        in_parallel(jobs.map_or(1, usize::from), &order, |piece| self.solve(piece));
        self.observer.batch_ended();
        if self.ended() < self.pieces.len() {
            return self.keep();
        }
        self.folder.remove_checkpoint()
    }

    fn solve(&self, index: usize) {
        if lock(&self.done)[index].is_none() {
            if self.cancellation.is_cancelled() {
                return;
            }
            let done = match self.pieces[index] {
                Piece::Points(task) => {
                    let found = self.broomstick.solve(&task);
                    let of = self.broomstick;
                    Done::Points(
                        points(&found),
                        limits(of, &found),
                        unchecked(of, &found),
                        taken(&found),
                    )
                }
                Piece::Buckling(depth_m) => {
                    Done::Buckling(buckling(&self.broomstick.weights_to_buckle(depth_m)))
                }
                Piece::Dynamic(run) => {
                    let goes_on = || !self.cancellation.is_cancelled();
                    match run.solve(self.request.case, self.broomstick, &goes_on) {
                        Some(ran) => Done::Dynamic(ran),
                        None => return,
                    }
                }
            };
            lock(&self.done)[index] = Some(done);
            let is_due = lock(&self.keeper).is_due();
            if is_due && let Err(error) = self.keep() {
                // The work does not end because one checkpoint cannot be written: the next may.
                self.observer.warning(&format!("no checkpoint: {error}"));
            }
        }
        let (ended, of) = (self.ended(), self.pieces.len());
        self.observer.case_ended(&CaseEnded { ended, of, reused_s: 0.0 });
    }

    fn keep(&self) -> Result<(), ResultsError> {
        let mut keeper = lock(&self.keeper);
        let done = lock(&self.done);
        keeper.write(&Kept { identity: self.identity.clone(), done: &*done })
    }

    fn ended(&self) -> usize {
        lock(&self.done).iter().flatten().count()
    }

    /// What was found, and how it went.
    pub(super) fn end(self) -> Ended {
        let case = self.request.case;
        let all = self.pieces.len();
        let mut batch = BatchOutcome::begin(self.folder.path(), all, self.start, self.cancellation);
        batch.finished = self.ended();
        let done = self.done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        let (mut points, mut weights) = (Vec::new(), Vec::new());
        let (mut all_limits, mut lacking) = (Vec::new(), BTreeSet::new());
        let mut all_taken = Vec::new();
        let is_run = |piece: &&Piece| matches!(piece, Piece::Dynamic(_));
        let mut parts = Parts::of(self.pieces.iter().filter(is_run).count());
        for one in done.into_iter().flatten() {
            match one {
                Done::Points(of, limits, unchecked, taken) => {
                    all_taken.extend(taken);
                    points.extend(of);
                    all_limits.extend(limits);
                    lacking.extend(unchecked);
                }
                Done::Buckling(of) => weights.extend(of),
                Done::Dynamic(ran) => parts.add(ran),
            }
        }
        let plan = &case.plan;
        let came = came(self.broomstick, &plan.models, &all_taken, parts.whole_wear());
        // Curve by curve: a task has the frictions of one depth.
        let level = |name: &str| FrictionLevel::ALL.iter().position(|of| of.name() == name);
        let models: Vec<String> = plan.models.iter().map(|of| of.name().to_owned()).collect();
        let operations: Vec<String> =
            plan.operations.iter().map(|of| of.kind.name().to_owned()).collect();
        let place = |names: &[String], name: &str| names.iter().position(|of| of == name);
        points.sort_by(|a: &PlanPoint, b: &PlanPoint| {
            let key = |of: &PlanPoint| {
                let names = (place(&models, &of.model), place(&operations, &of.operation));
                (names, level(&of.friction))
            };
            key(a).cmp(&key(b)).then(a.bit_depth_m.total_cmp(&b.bit_depth_m))
        });
        weights.sort_by(|a: &PlanBuckling, b: &PlanBuckling| {
            let key = |of: &PlanBuckling| (of.operation.clone(), level(&of.friction));
            key(a).cmp(&key(b)).then(a.bit_depth_m.total_cmp(&b.bit_depth_m))
        });
        let levels = FrictionLevel::ALL.len();
        let expected = levels * models.len() * operations.len() * plan.bit_depths_m.len();
        let mut settings = case.settings.clone();
        settings["plan"] = json!({
            "bit_depths_m": plan.bit_depths_m,
            "operations": operations,
            "models": models,
            "limits": plan.limits,
            "campaign": plan.campaign,
        });
        all_limits.extend(parts.limits);
        let mut unchecked = in_words(&lacking);
        unchecked.extend(parts.lacking);
        let hydraulics = mud::rows(case).unwrap_or_else(|why| {
            unchecked.push(why);
            Vec::new()
        });
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
            worst_limits: worst(&all_limits),
            unchecked,
            hydraulics,
            fatigue: came.fatigue,
            wear: came.worst_wear,
            peaks: parts.peaks,
        };
        if !plan.dynamic.events.is_empty() || !plan.dynamic.wear.is_empty() {
            summary.settings["plan"]["dynamic"] = json!(plan.dynamic);
        }
        let samples: Vec<_> = summary.peaks.iter().zip(&parts.histories).collect();
        let tables = Tables {
            limits: plan_limits_table(&all_limits),
            fatigue: plan_fatigue_table(&came.damage),
            wear: plan_wear_table(&came.wear),
            peaks_time: plan_peaks_time_table(&samples),
        };
        Ended { summary, tables, batch }
    }
}
