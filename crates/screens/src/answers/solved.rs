//! Description of an operation in an answer, as in the `summary.json` of a run.

use serde::Serialize;
use utoipa::{
    PartialSchema, ToSchema,
    openapi::{ObjectBuilder, RefOr, Schema, Type, schema::SchemaType},
};
use wholestring::outcome::SCALARS;

use crate::words::{CheckKind, Severity, StaticModel};

/// An operation by a model, as in the `summary.json` of a run, which has more.
#[derive(Debug, Serialize, ToSchema)]
pub struct Solved {
    /// The model.
    pub model: StaticModel,
    /// The operation: `drill`, ...
    pub operation: String,
    /// Progress of the solution.
    pub status: SolvedStatus,
    /// Reason why there is no answer.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub message: Option<String>,
    /// The checks, the most severe first.
    pub checks: Vec<SolvedCheck>,
    /// The scalars.
    #[serde(flatten)]
    pub scalars: SolvedScalars,
}

/// Progress of the solution of an operation.
#[derive(Debug, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum SolvedStatus {
    /// To its end.
    Complete,
    /// Stopped by the user.
    Interrupted,
    /// Without an answer.
    Failed,
}

/// A check of an operation: a load against its limit, or a state.
#[derive(Debug, Serialize, ToSchema)]
pub struct SolvedCheck {
    /// Its kind.
    pub kind: CheckKind,
    /// Its severity.
    pub severity: Severity,
    /// The verdict in words.
    pub verdict: String,
    /// The component; null for the rig and the whole string.
    pub component: Option<String>,
    /// Measured depth of the place, or of the upper end of its interval, m; null without a place.
    pub md_m: Option<f64>,
    /// Measured depth of the lower end of its interval, m; null for a point.
    pub to_md_m: Option<f64>,
    /// The value, for a limit the load, in `unit`.
    pub value: Option<f64>,
    /// The number that the value is compared with, in `unit`.
    pub limit: Option<f64>,
    /// Capacity over load; null where it is not a limit.
    pub factor: Option<f64>,
    /// The required factor; null where it is not a limit.
    pub required: Option<f64>,
    /// SI unit of value and limit; empty for a ratio.
    pub unit: String,
    /// The check as a sentence.
    pub sentence: String,
    /// The sentence with its quantities, from which it is rendered in other units.
    pub parts: Vec<serde_json::Value>,
}

/// Description of the scalars that every method reports.
#[derive(Debug, Serialize)]
pub enum SolvedScalars {}

impl PartialSchema for SolvedScalars {
    fn schema() -> RefOr<Schema> {
        let about = "Torque and drag; null where there is no number.";
        let object = ObjectBuilder::new().description(Some(about));
        let number = |meaning: &str| {
            let kinds = SchemaType::from_iter([Type::Number, Type::Null]);
            ObjectBuilder::new().schema_type(kinds).description(Some(meaning))
        };
        let scalars = SCALARS.iter().map(|scalar| &scalar.quantity);
        scalars
            .fold(object, |object, scalar| {
                object.property(scalar.name, number(scalar.meaning)).required(scalar.name)
            })
            .into()
    }
}

impl ToSchema for SolvedScalars {}
