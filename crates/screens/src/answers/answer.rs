//! Results of a case by the static models, which take milliseconds.

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
    solved::Solved,
    tracks::{Track, tracks},
    well::WellView,
};
use crate::words::{Severity, StaticModel};

/// Results of a case.
#[derive(Debug, Serialize, ToSchema)]
pub struct Answer {
    /// Each operation by each model, with its checks, as in `summary.json`.
    #[schema(value_type = Vec<Solved>)]
    operations: serde_json::Value,
    /// Values along the string, one track for each operation and model.
    tracks: Vec<Track>,
    /// Path, hole and string.
    well: WellView,
    /// The verdict on each operation by each model.
    verdicts: Vec<OperationVerdict>,
    /// Loads of its operations against the capacities of pipe and rig, by the soft string, if that
    /// model was requested.
    limits: Vec<OperationLimits>,
    /// Values that can be replaced without editing the text, and the units of the case.
    set_points: SetPoints,
    /// Wall-clock time of the solving, s.
    took_s: f64,
}

/// The verdict on an operation by a model.
#[derive(Debug, Serialize, ToSchema)]
pub struct OperationVerdict {
    /// The model.
    #[schema(value_type = StaticModel)]
    model: &'static str,
    /// The operation: `drill`, ...
    operation: &'static str,
    /// Its severity.
    #[schema(value_type = Severity)]
    severity: &'static str,
    /// The verdict in words.
    words: String,
}

fn verdict(operation: &OperationSummary) -> Option<OperationVerdict> {
    let Overall { severity, words } = Overall::of(&operation.checks)?;
    let (model, operation) = (operation.model.name(), operation.operation.name());
    Some(OperationVerdict { model, operation, severity: severity.name(), words })
}

/// Solves a case by these models instead of its own. Nothing is written, and no frames are taken,
/// which only dynamic runs have.
///
/// # Errors
/// A cancellation. An operation without a result contains the reason.
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
    use std::{collections::BTreeSet, path::Path};

    use utoipa::{
        PartialSchema,
        openapi::{RefOr, Schema},
    };
    use wholestring_case::load;
    use wholestring_judge::Check;

    use super::*;
    use crate::answers::solved::SolvedScalars;

    fn points(case: &Case) -> SetPoints {
        SetPoints::of(case, "")
    }

    fn np13() -> Case {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/np13-x1042.toml");
        load(&file, &[]).expect("a valid case")
    }

    /// The numbers are those of a run: hook load to every digit, tracks to single precision.
    #[test]
    fn an_answer_is_what_a_run_comes_to() {
        let models = vec![ModelKind::Soft, ModelKind::Stiff];
        let token = CancellationToken::new();
        let found = answer(np13(), models.clone(), points(&np13()), &token).expect("an answer");
        let run = run::answer(&Case { models, ..np13() }, None, &Silent, &token).expect("a run");
        let summary = run.answers.summary();
        assert_eq!(summary.operations.len(), 2);
        for (row, solved) in
            found.operations.as_array().expect("a list").iter().zip(&summary.operations)
        {
            assert_eq!(row["hook_load_N"].as_f64(), Some(solved.scalars.hook_load_N));
            assert_eq!(row["model"], solved.model.name());
        }
        let tables = run.answers.tables();
        let nodes = tables.iter().find(|(name, _)| *name == "nodes").expect("nodes").1;
        let rows: usize = found.tracks.iter().map(Track::rows).sum();
        assert_eq!(rows, nodes.rows());
        assert_eq!(found.tracks.len(), 2);
    }

    /// The described operations and checks have the properties of an answer's.
    #[test]
    fn operations_are_as_described() {
        let models = vec![ModelKind::Soft];
        let token = CancellationToken::new();
        let found = answer(np13(), models, points(&np13()), &token).expect("an answer");
        let described = |schema: RefOr<Schema>| serde_json::to_value(schema).expect("JSON");
        let names = |value: &serde_json::Value| -> BTreeSet<String> {
            value.as_object().into_iter().flat_map(|entries| entries.keys().cloned()).collect()
        };
        let operation = &found.operations[0];
        let check = described(Check::schema());
        assert_eq!(names(&check["properties"]), names(&operation["checks"][0]));
        let scalars = names(&described(SolvedScalars::schema())["properties"]);
        assert!(scalars.len() > 8 && scalars.is_subset(&names(operation)));
    }

    #[test]
    fn a_cancelled_answer_is_none() {
        let token = CancellationToken::new();
        token.cancel();
        let found = answer(np13(), vec![ModelKind::Soft], points(&np13()), &token);
        assert!(matches!(found, Err(Error::Interrupted)));
    }
}
