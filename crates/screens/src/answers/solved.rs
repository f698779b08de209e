//! Description of an operation in an answer, as in the `summary.json` of a run.

use serde::Serialize;
use utoipa::{
    PartialSchema, ToSchema,
    openapi::{ObjectBuilder, RefOr, Schema, Type, schema::SchemaType},
};
use wholestring::outcome::SCALARS;
use wholestring_judge::Check;

use crate::words::StaticModel;

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
    pub checks: Vec<Check>,
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
