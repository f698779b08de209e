//! What a text answers while it is written.

use std::collections::BTreeMap;

use axum::extract::{Path, State};
use serde::Deserialize;
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case, Override, parse};
use wholestring_runner::{CancellationToken, Error};

use super::{Json, blocking, error::ApiError};
use crate::{
    answers::{self, Answer, AssemblyView, Broomstick},
    app::App,
};

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(answer))
        .routes(routes!(broomstick))
        .routes(routes!(assembly))
}

/// A text, with some values of it replaced.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Asked {
    /// The text.
    text: String,
    /// Values by keys, as `--set KEY=VALUE` has them.
    #[serde(default)]
    set: BTreeMap<String, String>,
}

/// The same, and by which models.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AskedOfModels {
    /// The text.
    text: String,
    /// Values by keys, as `--set KEY=VALUE` has them.
    #[serde(default)]
    set: BTreeMap<String, String>,
    /// The models: `soft`, `stiff`. Both where nothing is said.
    #[serde(default)]
    models: Vec<String>,
}

/// The same, and in which operation.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AskedOfOperation {
    /// The text.
    text: String,
    /// Values by keys, as `--set KEY=VALUE` has them.
    #[serde(default)]
    set: BTreeMap<String, String>,
    /// The operation: `drill`, ...; the first that drills, or the first, where nothing is said.
    #[serde(default)]
    operation: Option<String>,
}

impl Asked {
    /// The case that it makes.
    fn case(&self, app: &App, id: &str) -> Result<Case, ApiError> {
        let file = app.workspace.case(id)?;
        let set = self.set.iter().map(|(key, value)| {
            let text = format!("{key}={value}");
            text.parse::<Override>().map_err(|error| ApiError::bad_input(error.to_string()))
        });
        let set: Vec<Override> = set.collect::<Result<_, _>>()?;
        Ok(parse(&file.shown, self.text.as_bytes(), &app.workspace.beside(&file), &set)?)
    }
}

fn models(names: &[String]) -> Result<Vec<ModelKind>, ApiError> {
    let statics = || ModelKind::ALL.iter().copied().filter(|of| !of.method().in_time);
    if names.is_empty() {
        return Ok(statics().collect());
    }
    let named = |name: &String| {
        statics().find(|of| of.name() == name).ok_or_else(|| {
            let names: Vec<&str> = statics().map(ModelKind::name).collect();
            let names = names.join(", ");
            ApiError::bad_input(format!("no model `{name}` answers at once: {names} do"))
        })
    };
    names.iter().map(named).collect()
}

fn operation(name: &str) -> Result<OperationKind, ApiError> {
    let found = OperationKind::ALL.iter().copied().find(|of| of.name() == name);
    found.ok_or_else(|| {
        let names: Vec<&str> = OperationKind::ALL.iter().map(|of| of.name()).collect();
        ApiError::bad_input(format!("no operation is called `{name}`: {} are", names.join(", ")))
    })
}

/// Ends the work whose answer nobody waits for any more: a page that has asked anew closes the
/// connection.
struct Waiting(CancellationToken);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// Does the work for as long as somebody waits for it, when its turn comes.
async fn while_waited_for<T: Send + 'static>(
    app: App,
    work: impl FnOnce(&App, &CancellationToken) -> Result<T, ApiError> + Send + 'static,
) -> Result<T, ApiError> {
    let waiting = Waiting(CancellationToken::new());
    let turn = app.solving.clone().acquire_owned().await.map_err(ApiError::failed)?;
    let token = waiting.0.clone();
    blocking(move || {
        let _turn = turn;
        work(&app, &token)
    })
    .await
}

fn refused(error: Error) -> ApiError {
    match error {
        Error::BadInput(message) => ApiError::bad_input(message),
        error => ApiError::failed(error),
    }
}

/// What the text comes to by soft and stiff string. Nothing is written.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/answer",
    request_body = AskedOfModels,
    responses((status = 200, body = Answer), (status = 422, body = ApiError))
)]
async fn answer(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(AskedOfModels { text, set, models: names }): Json<AskedOfModels>,
) -> Result<Json<Answer>, ApiError> {
    while_waited_for(app, move |app, cancellation| {
        let models = models(&names)?;
        let case = Asked { text, set }.case(app, &id)?;
        answers::answer(case, models, cancellation).map(Json).map_err(refused)
    })
    .await
}

/// Hook load and torque against the depth of the bit, with low, expected and high friction, by the
/// soft string.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/broomstick",
    request_body = Asked,
    responses((status = 200, body = Broomstick), (status = 422, body = ApiError))
)]
async fn broomstick(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(asked): Json<Asked>,
) -> Result<Json<Broomstick>, ApiError> {
    while_waited_for(app, move |app, cancellation| {
        let case = asked.case(app, &id)?;
        answers::broomstick(&case, cancellation).map(Json).map_err(refused)
    })
    .await
}

/// The bottom-hole assembly at rest: how it lies in its hole, what it does to the bit.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/assembly",
    request_body = AskedOfOperation,
    responses((status = 200, body = AssemblyView), (status = 422, body = ApiError))
)]
async fn assembly(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(AskedOfOperation { text, set, operation: name }): Json<AskedOfOperation>,
) -> Result<Json<AssemblyView>, ApiError> {
    while_waited_for(app, move |app, cancellation| {
        let kind = name.as_deref().map(operation).transpose()?;
        let case = Asked { text, set }.case(app, &id)?;
        answers::assembly(&case, kind, cancellation).map(Json).map_err(refused)
    })
    .await
}
