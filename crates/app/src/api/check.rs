//! Is a text a sound case?

use axum::extract::{Path, State};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_case::{Parts, parse};
use wholestring_config::node;

use super::{
    Json, blocking,
    diagnostic::{self, Diagnostic, Level},
    error::ApiError,
    layout::Layout,
    quantities::{self, Quantities},
    values,
};
use crate::app::App;

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(check))
}

/// A text that may stand in the file of a case.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Text {
    /// The text.
    text: String,
}

/// What is to be said about a text.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Checked {
    /// Errors, warnings and notes.
    diagnostics: Vec<Diagnostic>,
    /// The text as JSON, numbers and texts as they stand; null where it is no TOML.
    #[schema(value_type = Option<Object>)]
    values: Option<serde_json::Value>,
    /// What its texts are worth in SI, by dimension and text: `{"length": {"10 ft": 3.048}}`.
    #[schema(value_type = Object)]
    quantities: Quantities,
    /// What can be drawn of it.
    layout: Layout,
}

/// Says what the command line says of the text, as if it stood in the file of the case.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/check",
    request_body = Text,
    responses((status = 200, body = Checked), (status = 404, body = ApiError))
)]
async fn check(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(Text { text }): Json<Text>,
) -> Result<Json<Checked>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        let parsed = parse(&case.shown, text.as_bytes(), &app.workspace.beside(&case), &[]);
        let diagnostics = match &parsed {
            Err(report) => diagnostic::of_report(report),
            Ok(checked) => {
                let notes = checked.survey_notes.iter();
                let notes = notes.map(|note| Diagnostic {
                    level: Level::Note,
                    key: Some("well.survey".to_owned()),
                    ..Diagnostic::sentence(note)
                });
                diagnostic::of_report(&checked.warnings).into_iter().chain(notes).collect()
            }
        };
        let tree = node::parse_text(&text, 0).ok();
        let quantities = tree.as_ref().map(quantities::of_table).unwrap_or_default();
        let values = tree.map(|entries| values::of_table(&entries, &text));
        let parts = Parts::read(&case.shown, text.as_bytes(), &app.workspace.beside(&case));
        Ok(Json(Checked { diagnostics, values, quantities, layout: Layout::of(parts) }))
    })
    .await
}
