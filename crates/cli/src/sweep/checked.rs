//! The cases of a sweep before they are solved.

use std::{
    collections::BTreeSet,
    sync::{Mutex, PoisonError},
};

use wholestring::{dynamics::Effort, outcome::ModelKind};
use wholestring_case::{Case, Report};
use wholestring_results::digest;

use super::points::Point;
use crate::{
    color,
    failure::Failure,
    parallel::{in_parallel, lock},
    tell,
};

/// What is known of a case before it is solved.
pub(super) struct Checked {
    pub(super) name: String,
    /// Digest of all that its answers depend on.
    pub(super) identity: String,
    /// Element-steps of its dynamic runs, at most.
    pub(super) cost: f64,
    /// Simulated time of its dynamic runs, s, at most.
    pub(super) simulated_s: f64,
    /// Whether its lift is tuned.
    pub(super) lift: bool,
    warnings: String,
    /// The case itself, until it is solved, where reading it again would take as long as solving it.
    case: Mutex<Option<Case>>,
}

/// Most cases that are held in memory between their check and their solution; each takes some 0.2 MB.
const MOST_HELD: usize = 500;

impl Checked {
    fn of(case: Case, holds: bool) -> Self {
        let dynamic = ModelKind::any_in_time(&case.models);
        let operations = if dynamic { &case.operations[..] } else { &[] };
        let efforts: Vec<Effort> = operations
            .iter()
            .filter_map(|operation| Effort::of(&case.model, operation, &case.dynamics).ok())
            .collect();
        let cost = efforts
            .iter()
            .map(|effort| effort.elements as f64 * effort.steps);
        Self {
            name: case.name.clone(),
            identity: digest(&case.identity()),
            cost: cost.sum(),
            lift: dynamic && case.tunes_lift,
            simulated_s: efforts.iter().map(|effort| effort.end_s).sum(),
            warnings: case.warnings.render(color()),
            case: Mutex::new((holds && !dynamic).then_some(case)),
        }
    }

    /// The case, where it was held since its check; only once.
    pub(super) fn take(&self) -> Option<Case> {
        lock(&self.case).take()
    }
}

/// Reads and checks every case, so that no sweep ends on a mistake in its last.
pub(super) fn check(
    points: &[Point<'_>],
    jobs: usize,
    quiet: bool,
) -> Result<Vec<Checked>, Failure> {
    /// Mistakes that are told; the same is told once.
    const SHOWN: usize = 5;
    let all: Vec<usize> = (0..points.len()).collect();
    let answers: Vec<Mutex<Option<Result<Checked, Report>>>> =
        points.iter().map(|_| Mutex::default()).collect();
    in_parallel(jobs, &all, |i| {
        let answer = points[i].template.case(&points[i].changes);
        *lock(&answers[i]) = Some(answer.map(|case| Checked::of(case, points.len() <= MOST_HELD)));
    });
    let mut checked = Vec::new();
    let mut unsound: Vec<(&Point<'_>, String)> = Vec::new();
    for (point, answer) in points.iter().zip(answers) {
        let answer = answer.into_inner().unwrap_or_else(PoisonError::into_inner);
        match answer.expect("every case is checked") {
            Ok(case) => checked.push(case),
            Err(report) => unsound.push((point, report.render(color()))),
        }
    }
    if let Some((first, _)) = unsound.first() {
        let mut told: Vec<&str> = Vec::new();
        for (_, report) in &unsound {
            if told.len() < SHOWN && !told.contains(&report.as_str()) {
                told.push(report);
            }
        }
        let end = match (unsound.len(), points.len()) {
            (_, 1) => String::new(),
            (1, all) => format!(
                "\n1 of {all} cases is not sound, {}: nothing was run",
                first.name
            ),
            (some, all) => format!(
                "\n{some} of {all} cases are not sound, the first is {}: nothing was run",
                first.name
            ),
        };
        return Err(Failure::BadInput(format!("{}{end}", told.join("\n"))));
    }
    if !quiet {
        let warnings: BTreeSet<&str> = checked.iter().map(|case| &*case.warnings).collect();
        warnings.into_iter().take(SHOWN).for_each(tell);
    }
    Ok(checked)
}
