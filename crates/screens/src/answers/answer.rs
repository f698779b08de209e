//! The answer of a case by the models that take milliseconds.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::outcome::ModelKind;
use wholestring_case::Case;
use wholestring_judge::Overall;
use wholestring_results::OperationSummary;
use wholestring_runner::{CancellationToken, Error, Instant, Silent, run};

use super::{
    limits::{self, OperationLimits},
    set_points::SetPoints,
    tracks::{Track, tracks},
    well::WellView,
};

/// What a case comes to.
#[derive(Debug, Serialize, ToSchema)]
pub struct Answer {
    /// Each operation by each model, as `summary.json` has it, with its checks.
    #[schema(value_type = Vec<Object>)]
    operations: serde_json::Value,
    /// Values along the string, an operation by a model each.
    tracks: Vec<Track>,
    /// Path, hole and string.
    well: WellView,
    /// The verdict on each operation by each model.
    verdicts: Vec<OperationVerdict>,
    /// How near its operations are to what pipe and rig bear; by the soft string, and so where that
    /// was asked for.
    limits: Vec<OperationLimits>,
    /// What may be replaced without touching the text, and the units of the case.
    set_points: SetPoints,
    /// Wall-clock time of the solving, s.
    took_s: f64,
}

/// The verdict on an operation by a model.
#[derive(Debug, Serialize, ToSchema)]
pub struct OperationVerdict {
    /// The model.
    model: &'static str,
    /// The operation: `drill`, ...
    operation: String,
    /// `ok`, `note`, `warning` or `error`.
    severity: &'static str,
    /// The verdict in words.
    words: String,
}

fn verdict(operation: &OperationSummary) -> Option<OperationVerdict> {
    let Overall { severity, words } = Overall::of(&operation.checks)?;
    let (model, severity) = (operation.model.name(), severity.name());
    Some(OperationVerdict { model, operation: operation.operation.clone(), severity, words })
}

/// Solves a case by these models instead of its own. Nothing is written; frames, which are taken of
/// dynamic runs alone, are not asked for.
///
/// # Errors
/// A cancellation. What has no answer says so in its operation.
pub fn answer(
    mut case: Case,
    models: Vec<ModelKind>,
    set_points: SetPoints,
    cancellation: &CancellationToken,
) -> Result<Answer, Error> {
    case.models = models;
    case.records.frame_interval_s = None;
    let begun = Instant::now();
    let solved = run::answer(&case, None, &Silent, cancellation)?;
    let by_soft = case.models.contains(&ModelKind::Soft);
    let limits = if by_soft { limits::of_operations(&case) } else { Vec::new() };
    let took_s = begun.elapsed().as_secs_f64();
    if cancellation.is_cancelled() {
        return Err(Error::Interrupted);
    }
    let summary = solved.answers.summary();
    let verdicts = summary.operations.iter().filter_map(verdict).collect();
    let operations = serde_json::to_value(&summary.operations);
    let tables = solved.answers.tables();
    let nodes = tables.iter().find(|(name, _)| *name == "nodes");
    Ok(Answer {
        operations: operations.map_err(|error| Error::Failed(error.to_string()))?,
        tracks: nodes.map_or_else(Vec::new, |(_, table)| tracks(table)),
        well: WellView::of(&case),
        verdicts,
        limits,
        set_points,
        took_s,
    })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use wholestring_case::load;

    use super::*;

    fn points(case: &Case) -> SetPoints {
        SetPoints::of(case, "")
    }

    fn np13() -> Case {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/np13-x1042.toml");
        load(&file, &[]).expect("a valid case")
    }

    /// The numbers are those of a run: hook load to every digit, tracks to a float's.
    #[test]
    fn an_answer_is_what_a_run_comes_to() {
        let models = vec![ModelKind::Soft, ModelKind::Stiff];
        let token = CancellationToken::new();
        let found = answer(np13(), models.clone(), points(&np13()), &token).expect("an answer");
        let run = run::answer(&Case { models, ..np13() }, None, &Silent, &token).expect("a run");
        let summary = run.answers.summary();
        assert_eq!(summary.operations.len(), 2);
        for (shown, solved) in
            found.operations.as_array().expect("a list").iter().zip(&summary.operations)
        {
            assert_eq!(shown["hook_load_N"].as_f64(), Some(solved.scalars.hook_load_N));
            assert_eq!(shown["model"], solved.model.name());
        }
        let tables = run.answers.tables();
        let nodes = tables.iter().find(|(name, _)| *name == "nodes").expect("nodes").1;
        let rows: usize = found.tracks.iter().map(Track::rows).sum();
        assert_eq!(rows, nodes.rows());
        assert_eq!(found.tracks.len(), 2);
    }

    #[test]
    fn a_cancelled_answer_is_none() {
        let token = CancellationToken::new();
        token.cancel();
        let found = answer(np13(), vec![ModelKind::Soft], points(&np13()), &token);
        assert!(matches!(found, Err(Error::Interrupted)));
    }
}
