//! The checks of a summary of any command.

use serde::Deserialize;
use serde_json::Value;
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_judge::Check;

use crate::PlanOperation;

/// A check and the operation that it concerns.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedCheck {
    /// The operation and the model, `trip in (soft)`; empty where it concerns the whole result.
    pub name: String,
    /// The check.
    pub check: Check,
}

/// Keys of a summary that contain checks. Every command has some of them.
#[derive(Deserialize)]
struct Holder {
    #[serde(default)]
    operations: Option<Value>,
    #[serde(default, alias = "worst_limits")]
    checks: Vec<Row>,
}

/// An operation of a run.
#[derive(Deserialize)]
struct Operation {
    operation: OperationKind,
    model: ModelKind,
    #[serde(default, alias = "findings")]
    checks: Vec<Check>,
}

/// A check of a plan or of another command, with its operation.
#[derive(Deserialize)]
struct Row {
    #[serde(default)]
    operation: Option<PlanOperation>,
    #[serde(default)]
    model: Option<ModelKind>,
    #[serde(flatten)]
    check: Check,
}

/// Returns the checks of a `summary.json`, the most severe first; none for a text that is not a
/// summary.
pub fn checks_of(summary: &Value) -> Vec<NamedCheck> {
    let Ok(holder) = Holder::deserialize(summary) else { return Vec::new() };
    let operations = holder.operations.and_then(|value| Vec::<Operation>::deserialize(value).ok());
    let of_operations = operations.into_iter().flatten().flat_map(|operation| {
        let name = name(Some(operation.operation.words()), Some(operation.model));
        operation.checks.into_iter().map(move |check| NamedCheck { name: name.clone(), check })
    });
    let rows = holder.checks.into_iter().map(|row| NamedCheck {
        name: name(row.operation.map(PlanOperation::words), row.model),
        check: row.check,
    });
    let mut all: Vec<NamedCheck> = of_operations.chain(rows).collect();
    all.sort_by_key(|named| std::cmp::Reverse(named.check.severity));
    all
}

/// Name of a check: the words of an operation, and its model.
fn name(operation: Option<&str>, model: Option<ModelKind>) -> String {
    match (operation, model) {
        (Some(operation), Some(model)) => format!("{operation} ({})", model.name()),
        (Some(operation), None) => operation.to_owned(),
        (None, Some(model)) => model.name().to_owned(),
        (None, None) => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use wholestring_judge::{CheckKind, Severity, Verdict};

    use super::*;

    #[test]
    fn checks_of_runs_and_plans_of_every_version_are_found() {
        let run = json!({"settings": {"checks": 1}, "operations": [
            {"model": "soft", "operation": "trip_in", "findings": [
                {"kind": "hook_load_negative", "level": "error", "message": "Slack"}]},
            {"model": "stiff", "operation": "slide", "checks": [
                {"kind": "tension", "severity": "ok", "verdict": "OK", "sentence": "Tension"}]},
        ]});
        let found = checks_of(&run);
        assert_eq!(found.len(), 2);
        let (first, second) = (&found[0], &found[1]);
        assert_eq!(
            (first.name.as_str(), first.check.kind),
            ("trip in (soft)", CheckKind::GoesDown)
        );
        assert_eq!(
            (first.check.severity, first.check.sentence.as_str()),
            (Severity::Error, "Slack")
        );
        assert_eq!(second.name, "slide (stiff)");
        let plan = json!({"operations": ["slide"], "worst_limits": [
            {"model": "soft", "operation": "slide", "friction": "low", "kind": "hoist",
             "load": 2.0, "capacity": 1.0, "factor": 0.5, "required": 1.0, "standing": "passed"}]});
        let found = checks_of(&plan);
        assert_eq!(found[0].name, "slide (soft)");
        assert_eq!(found[0].check.verdict, Verdict::Exceeded);
        assert_eq!((found[0].check.severity, found[0].check.value), (Severity::Error, Some(2.0)));
        let events = json!({"checks": [{"model": "dynamic", "operation": "pick_up_from_slips",
            "friction": "low", "kind": "tension", "severity": "ok", "verdict": "OK",
            "sentence": "Tension"}]});
        assert_eq!(checks_of(&events)[0].name, "pick up from slips (dynamic)");
        assert_eq!(checks_of(&json!([1])), []);
    }
}
