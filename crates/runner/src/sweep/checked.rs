//! The cases of a sweep before they are solved.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{Mutex, PoisonError},
};

use wholestring::{dynamics::Effort, operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case, Report};
use wholestring_results::digest;

use super::points::Point;
use crate::{
    cancellation::CancellationToken,
    error::{Error, Unsound},
    keep::Keep,
    observer::Observer,
    parallel::{in_parallel, lock},
};

/// Data of a case that are known before it is solved.
pub(super) struct Checked {
    pub(super) name: String,
    /// Digest of all settings that its answers depend on.
    pub(super) identity: String,
    /// Element-steps of its dynamic runs; an upper limit.
    pub(super) cost: f64,
    /// Simulated time of its dynamic runs, s; an upper limit.
    pub(super) simulated_s: f64,
    /// Whether its lift is tuned.
    pub(super) lift: bool,
    /// Number of answers: operations times models.
    pub(super) answers: usize,
    /// Methods and operations that it solves.
    pub(super) solves: (Vec<ModelKind>, Vec<OperationKind>),
    /// Files that are kept by default.
    pub(super) keep: Keep,
    /// The case itself, until it is solved, if reading it again would take as long as solving it.
    case: Mutex<Option<Case>>,
}

/// Largest number of cases in memory between their check and their solution; each takes some 0.2
/// MB.
const MAX_HELD: usize = 500;

impl Checked {
    fn of(case: Case, holds: bool) -> Self {
        let dynamic = ModelKind::any_in_time(&case.models);
        let operations = if dynamic { &case.operations[..] } else { &[] };
        let efforts: Vec<Effort> = operations
            .iter()
            .filter_map(|operation| Effort::of(&case.model, operation, &case.dynamics).ok())
            .collect();
        let cost = efforts.iter().map(Effort::element_steps);
        Self {
            name: case.name.clone(),
            identity: digest(&case.identity()),
            cost: cost.sum(),
            lift: dynamic && case.tunes_hook_load,
            answers: case.operations.len() * case.models.len(),
            solves: (
                case.models.clone(),
                case.operations.iter().map(|operation| operation.kind).collect(),
            ),
            keep: Keep::of_itself(&case, false),
            simulated_s: efforts.iter().map(|effort| effort.end_s).sum(),
            case: Mutex::new((holds && !dynamic).then_some(case)),
        }
    }

    /// Takes the case, if it was held since its check; later calls return `None`.
    pub(super) fn take(&self) -> Option<Case> {
        lock(&self.case).take()
    }
}

/// Largest number of mistakes or warnings that are reported; equal ones are reported once.
const SHOWN: usize = 5;

/// Reads and checks every case, so that no sweep fails at its end on a mistake in its last case.
pub(super) fn check(
    points: &[Point],
    jobs: usize,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Vec<Checked>, Error> {
    let all: Vec<usize> = (0..points.len()).collect();
    let outcomes: Vec<Mutex<Option<Result<Checked, Report>>>> =
        points.iter().map(|_| Mutex::default()).collect();
    // The first in alphabetical order.
    let warnings: Mutex<BTreeMap<String, Report>> = Mutex::default();
    in_parallel(jobs, &all, |i| {
        if cancellation.is_cancelled() {
            return;
        }
        let answer = points[i].template.case(&points[i].changes);
        if let Ok(case) = &answer
            && !case.warnings.is_empty()
        {
            let mut warnings = lock(&warnings);
            warnings.insert(case.warnings.render(false), case.warnings.clone());
            if warnings.len() > SHOWN {
                warnings.pop_last();
            }
        }
        *lock(&outcomes[i]) = Some(answer.map(|case| Checked::of(case, points.len() <= MAX_HELD)));
    });
    let mut checked = Vec::new();
    let mut unsound: Vec<(&Point, Report)> = Vec::new();
    for (point, answer) in points.iter().zip(outcomes) {
        match answer.into_inner().unwrap_or_else(PoisonError::into_inner) {
            Some(Ok(case)) => checked.push(case),
            Some(Err(report)) => unsound.push((point, report)),
            None => return Err(Error::Interrupted),
        }
    }
    if let Some((first, _)) = unsound.first() {
        let summary = match (unsound.len(), points.len()) {
            (_, 1) => None,
            (1, all) => {
                Some(format!("1 of {all} cases is invalid, {}: nothing was run", first.name))
            }
            (some, all) => Some(format!(
                "{some} of {all} cases are invalid, the first is {}: nothing was run",
                first.name
            )),
        };
        let mut seen: BTreeSet<String> = BTreeSet::new();
        let mut reports: Vec<Report> = Vec::new();
        for (_, report) in unsound {
            if reports.len() < SHOWN && seen.insert(report.render(false)) {
                reports.push(report);
            }
        }
        return Err(Error::Unsound(Unsound { reports, summary }));
    }
    let warnings = warnings.into_inner();
    let warnings = warnings.unwrap_or_else(PoisonError::into_inner);
    for report in warnings.values() {
        observer.diagnostics(report);
    }
    Ok(checked)
}
