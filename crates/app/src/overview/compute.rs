//! Computation of the overview of one case.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::{
    outcome::{ModelKind, WellPath},
    well::{HoleKind, Path},
};
use wholestring_case::Case;
use wholestring_judge::{Check, Overall};
use wholestring_results::{OperationSummary, Status};
use wholestring_runner::{CancellationToken, Silent, run};
use wholestring_screens::words::Severity;
use wholestring_units::UnitSet;

/// Number of intervals of a silhouette, and its resolution, parts of a metre.
const POINTS: usize = 28;
const PARTS: f64 = 10.0;

/// The well of a case as a line, for a small drawing.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct Silhouette {
    /// Measured depths, m.
    md_m: Vec<f32>,
    /// Distances along the direction of the closure, m.
    vertical_section_m: Vec<f32>,
    /// True vertical depths, m.
    tvd_m: Vec<f32>,
    /// Measured depth of the deepest casing shoe, m; null without casing.
    shoe_md_m: Option<f64>,
    /// Measured depth of the bit in the first operation, m.
    bit_md_m: f64,
}

impl Silhouette {
    pub(super) fn of(case: &Case) -> Self {
        let path = &case.model.well.path;
        let well = WellPath::at(path, depths(path)).drawn(path);
        let column = |numbers: Vec<f64>| {
            numbers.into_iter().map(|number| ((number * PARTS).round() / PARTS) as f32).collect()
        };
        let sections = case.model.well.hole.sections().iter();
        let shoes = sections.filter(|section| section.kind == HoleKind::Casing);
        let bit = case.operations.first().map(|operation| operation.bit_depth_m);
        Self {
            md_m: column(well.md_m),
            vertical_section_m: column(well.vertical_section_m),
            tvd_m: column(well.tvd_m),
            shoe_md_m: shoes.map(|section| section.to_md_m).reduce(f64::max),
            bit_md_m: bit.unwrap_or_else(|| path.last_md_m()),
        }
    }
}

fn depths(path: &Path) -> Vec<f64> {
    let (from_m, to_m) = (path.first_md_m(), path.last_md_m());
    (0..=POINTS).map(|i| from_m + (to_m - from_m) * i as f64 / POINTS as f64).collect()
}

/// The judge's verdict on a case by the soft string, and key numbers of the operation that it is
/// about.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct CaseOverview {
    /// The most severe check; null if the case has no capacity that a load could be compared with.
    check: Option<WorstCheck>,
    /// Reason why an operation has no answer.
    message: Option<String>,
    /// The operation of the check: `drill`, ...; without a check, the first.
    operation: &'static str,
    /// Bit depth of that operation, m.
    bit_depth_m: f64,
    /// Hook load of that operation without the block, N.
    hook_load_N: Option<f64>,
    /// Surface torque of that operation, N m.
    surface_torque_N_m: Option<f64>,
}

/// The most severe check of a case.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub(crate) struct WorstCheck {
    /// Its severity.
    #[schema(value_type = Severity)]
    severity: &'static str,
    /// The verdict in words: `OK`, `marginal`, `below required factor`, `exceeded`.
    verdict: &'static str,
    /// Its sentence, and the number of other errors and warnings. For a case without an error or a
    /// warning, it is the limit with the least reserve.
    sentence: String,
}

/// The overview in SI units, and the check from which its sentence is rendered.
#[derive(Debug)]
pub(super) struct Solved {
    check: Option<Check>,
    /// Number of other errors and warnings, in words.
    others: String,
    overview: CaseOverview,
}

impl Solved {
    /// Solves a case by the soft string. `None` for a case without an answer and after a
    /// cancellation.
    pub(super) fn of(mut case: Case, cancellation: &CancellationToken) -> Option<Self> {
        case.models = vec![ModelKind::Soft];
        case.records.frame_interval_s = None;
        let solved = run::answer(&case, None, &Silent, cancellation).ok()?;
        if cancellation.is_cancelled() {
            return None;
        }
        let operations = &solved.answers.summary().operations;
        let pairs =
            operations.iter().flat_map(|one| one.checks.iter().map(move |check| (one, check)));
        let pairs: Vec<(&OperationSummary, &Check)> = pairs.collect();
        // The first of equals, because the checks of an operation are sorted.
        let worst = pairs.iter().rev().max_by(|one, other| one.1.cmp_severity(other.1));
        let operation =
            worst.map_or_else(|| operations.first(), |(operation, _)| Some(*operation))?;
        let check = worst.map(|(_, check)| (*check).clone());
        let overall = Overall::of(pairs.iter().map(|(_, check)| *check));
        let others = overall.zip(check.as_ref()).and_then(|(overall, check)| {
            overall.words.strip_prefix(&check.sentence).map(str::to_owned)
        });
        let message = operations.iter().find_map(|one| match &one.status {
            Status::Failed(message) => Some(message.clone()),
            _ => None,
        });
        let is_complete = operation.status == Status::Complete;
        let scalar = |value: f64| (is_complete && value.is_finite()).then_some(value);
        let overview = CaseOverview {
            check: None,
            message,
            operation: operation.operation.name(),
            bit_depth_m: operation.bit_depth_m,
            hook_load_N: scalar(operation.scalars.hook_load_N),
            surface_torque_N_m: scalar(operation.scalars.surface_torque_N_m),
        };
        Some(Self { check, others: others.unwrap_or_default(), overview })
    }

    /// The overview with its sentence in these units; by default those of the case.
    pub(super) fn overview(&self, units: Option<UnitSet>) -> CaseOverview {
        let check = self.check.as_ref().map(|check| {
            let sentence =
                units.map_or_else(|| check.sentence.clone(), |units| check.sentence_in(units));
            let (severity, verdict) = (check.severity.name(), check.verdict.words());
            WorstCheck { severity, verdict, sentence: sentence + &self.others }
        });
        CaseOverview { check, ..self.overview.clone() }
    }
}
