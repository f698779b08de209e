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

/// Number of points of a silhouette.
const POINTS: usize = 40;

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
        let column = |numbers: Vec<f64>| numbers.into_iter().map(|number| number as f32).collect();
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
    /// Severity of the most severe check.
    #[schema(value_type = Severity)]
    severity: &'static str,
    /// Its verdict in words: `OK`, `marginal`, `below required factor`, `exceeded`.
    verdict: &'static str,
    /// Its sentence: for a case without an error or a warning, the limit with the least reserve.
    sentence: String,
    /// The operation that it is about: `drill`, ...
    operation: &'static str,
    /// Bit depth of that operation, m.
    bit_depth_m: f64,
    /// Hook load of that operation without the block, N.
    hook_load_N: Option<f64>,
    /// Surface torque of that operation, N m.
    surface_torque_N_m: Option<f64>,
}

/// The most severe check of a case with its operation, in SI units.
#[derive(Debug)]
pub(super) struct Solved {
    check: Check,
    /// Sentence of the whole case, in the units of the case.
    words: String,
    operation: &'static str,
    bit_depth_m: f64,
    hook_load_N: Option<f64>,
    surface_torque_N_m: Option<f64>,
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
        let checks = operations.iter().flat_map(|one| one.checks.iter().map(move |check| (one, check)));
        // The first of equals, because the checks of an operation are sorted.
        let all: Vec<(&OperationSummary, &Check)> = checks.collect();
        let worst = all.iter().rev().max_by(|one, other| one.1.cmp_severity(other.1));
        let (operation, check) = *worst?;
        let overall = Overall::of(all.iter().map(|(_, check)| *check))?;
        let is_complete = operation.status == Status::Complete;
        let scalar = |value: f64| (is_complete && value.is_finite()).then_some(value);
        Some(Self {
            check: check.clone(),
            words: overall.words,
            operation: operation.operation.name(),
            bit_depth_m: operation.bit_depth_m,
            hook_load_N: scalar(operation.scalars.hook_load_N),
            surface_torque_N_m: scalar(operation.scalars.surface_torque_N_m),
        })
    }

    /// The overview with its sentence in these units; by default those of the case.
    pub(super) fn overview(&self, units: Option<UnitSet>) -> CaseOverview {
        let sentence = match units {
            Some(units) => self.check.sentence_in(units),
            None => self.check.sentence.clone(),
        };
        // The number of further errors and warnings follows the sentence of the check.
        let more = self.words.strip_prefix(&self.check.sentence).unwrap_or_default();
        CaseOverview {
            severity: self.check.severity.name(),
            verdict: self.check.verdict.words(),
            sentence: sentence + more,
            operation: self.operation,
            bit_depth_m: self.bit_depth_m,
            hook_load_N: self.hook_load_N,
            surface_torque_N_m: self.surface_torque_N_m,
        }
    }
}
