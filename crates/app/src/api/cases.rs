//! Case files of the folder: their texts, names and unsaved drafts.

use std::{sync::Arc, time::Duration};

use axum::{
    extract::{Path, Query, State},
    http::StatusCode,
};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_case::parse;
use wholestring_units::UnitSet;

use super::{Json, blocking, error::ApiError};
use crate::{
    app::App,
    overview::{CaseOverview, Known, Silhouette},
    results::{CaseVerdict, NewestVerdicts},
    workspace::{CaseFile, Draft, NewFile, Workspace, millis},
};

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(list, create))
        .routes(routes!(open, save))
        .routes(routes!(rename))
        .routes(routes!(copy))
        .routes(routes!(delete))
        .routes(routes!(keep, discard))
}

/// A case of the folder.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct CaseEntry {
    /// Identifier in requests.
    id: String,
    /// Path within the folder, for display.
    path: String,
    /// Its name in results.
    name: String,
    /// Its first mistake; null if there is none, or if it is not yet checked.
    problem: Option<String>,
    /// The well; null for an invalid case, or if it is not yet read.
    silhouette: Option<Silhouette>,
    /// The verdict of the soft string; null without an answer, or if it is not yet solved.
    overview: Option<CaseOverview>,
    /// Whether `problem`, `silhouette` or `overview` is still computed: a later list has them.
    is_pending: bool,
    /// The verdict on it from its newest results; null if it has none yet.
    verdict: Option<CaseVerdict>,
    /// Whether it has an unsaved draft.
    has_draft: bool,
    /// Time of its last change, milliseconds since 1970.
    modified_ms: u64,
}

/// Units of the sentences.
#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(crate) struct Units {
    /// `si`, `metric` or `field`; by default those of each case.
    units: Option<String>,
}

/// Time limit for reading results; those not read by then are listed later.
const READING_TIME: Duration = Duration::from_millis(150);

/// The case files of the folder, by path. Overviews are computed in the background: a list has
/// those that are complete.
#[utoipa::path(
    get,
    path = "/api/cases",
    params(Units),
    responses((status = 200, body = Vec<CaseEntry>), (status = 422, body = ApiError))
)]
async fn list(
    State(app): State<App>,
    Query(Units { units }): Query<Units>,
) -> Result<Json<Vec<CaseEntry>>, ApiError> {
    blocking(move || {
        let units = units.map(|units| units.parse::<UnitSet>()).transpose();
        let units = units.map_err(|error| ApiError::bad_input(error.to_string()))?;
        let verdicts = app.verdicts.newest(&app.workspace, READING_TIME);
        let cases = app.workspace.cases();
        let revision =
            |case: &CaseFile| case.read().map_or_else(|_| String::new(), |read| read.revision);
        let revised: Vec<_> = cases.iter().map(|case| (case, revision(case))).collect();
        let known = app.overviews.of(&revised);
        let entries = cases.into_iter().zip(known);
        let entry = |(case, known)| entry(&app.workspace, case, known, &verdicts, units);
        Ok(Json(entries.map(entry).collect()))
    })
    .await
}

fn entry(
    workspace: &Workspace,
    case: CaseFile,
    known: Option<Arc<Known>>,
    verdicts: &NewestVerdicts,
    units: Option<UnitSet>,
) -> CaseEntry {
    let stem = case.path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let known = known.as_deref();
    let title = known.map(|known| &known.title);
    let name = title.and_then(|title| title.name.clone());
    let settings = title.and_then(|title| title.settings.as_ref());
    CaseEntry {
        problem: title.and_then(|title| title.problem.clone()),
        silhouette: known.and_then(|known| known.silhouette.clone()),
        overview: known.and_then(|known| known.overview(units)),
        is_pending: known.is_none_or(Known::is_pending),
        verdict: settings.and_then(|settings| verdicts.on(name.as_deref()?, settings)),
        name: name.or(stem).unwrap_or_default(),
        has_draft: workspace.draft(&case).is_some(),
        modified_ms: millis(case.modified),
        path: case.shown,
        id: case.id,
    }
}

/// A file to create.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct GivenFile {
    /// Its name, without a path.
    file_name: String,
    /// Its contents.
    text: String,
}

impl GivenFile {
    fn new_file(&self) -> NewFile<'_> {
        NewFile { name: &self.file_name, text: &self.text }
    }
}

/// A case to create.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewCase {
    /// The name of its file, which ends in `.toml`.
    file_name: String,
    /// Its text.
    text: String,
    /// Files that it names. An existing one must have the same contents.
    #[serde(default)]
    beside: Vec<GivenFile>,
}

/// A created case.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Created {
    /// Identifier in requests.
    id: String,
}

/// Creates a case file, never over an existing one.
#[utoipa::path(
    post,
    path = "/api/cases",
    request_body = NewCase,
    responses(
        (status = 200, body = Created),
        (status = 409, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn create(
    State(app): State<App>,
    Json(new): Json<NewCase>,
) -> Result<Json<Created>, ApiError> {
    blocking(move || {
        let beside: Vec<NewFile<'_>> = new.beside.iter().map(GivenFile::new_file).collect();
        let case = NewFile { name: &new.file_name, text: &new.text };
        Ok(Json(Created { id: app.workspace.create(case, &beside)? }))
    })
    .await
}

/// A case with its text.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct OpenCase {
    /// Identifier in requests.
    id: String,
    /// Path within the folder, for display.
    path: String,
    /// Contents of the file.
    text: String,
    /// Fingerprint of the current contents.
    revision: String,
    /// The unsaved draft.
    #[schema(value_type = Option<OpenDraft>)]
    draft: Option<Draft>,
    /// The existing files that it names.
    beside: Vec<String>,
}

/// An unsaved draft.
#[derive(ToSchema)]
#[allow(dead_code, reason = "it describes the drafts of the workspace in the API document")]
pub(crate) struct OpenDraft {
    /// The text.
    text: String,
    /// The revision of the file when it was opened.
    base_revision: String,
    /// Time when it was saved, milliseconds since 1970.
    modified_ms: u64,
}

/// A case with its text.
#[utoipa::path(
    get,
    path = "/api/cases/{id}",
    responses((status = 200, body = OpenCase), (status = 404, body = ApiError))
)]
async fn open(State(app): State<App>, Path(id): Path<String>) -> Result<Json<OpenCase>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        let read = case.read()?;
        let files = app.workspace.beside(&case);
        // Mistakes are reported by `check`; this call only collects the named files.
        let _ = parse(&case.shown, read.text.as_bytes(), &files, &[]);
        Ok(Json(OpenCase {
            beside: files.into_files().into_keys().collect(),
            draft: app.workspace.draft(&case),
            text: read.text,
            revision: read.revision,
            path: case.shown,
            id,
        }))
    })
    .await
}

/// A text, with the revision of the file when it was opened.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Revised {
    /// The text.
    pub(super) text: String,
    /// The revision of the file when it was opened.
    pub(super) revision: String,
}

/// A saved case.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Saved {
    /// The new revision of the file.
    revision: String,
}

/// Replaces the text of the file, unless it has changed since. Its draft is removed.
#[utoipa::path(
    put,
    path = "/api/cases/{id}",
    request_body = Revised,
    responses(
        (status = 200, body = Saved),
        (status = 404, body = ApiError),
        (status = 409, body = ApiError)
    )
)]
async fn save(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(new): Json<Revised>,
) -> Result<Json<Saved>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        Ok(Json(Saved { revision: app.workspace.save(&case, &new.text, &new.revision)? }))
    })
    .await
}

// Renaming, copying and deleting case files.

/// The new name of a case file within its folder.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Named {
    /// The name, which ends in `.toml`.
    file_name: String,
}

/// A renamed or copied case file.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Arranged {
    /// Identifier in requests.
    id: String,
}

/// Renames a case file within its folder, never over an existing one.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/rename",
    request_body = Named,
    responses((status = 200, body = Arranged), (status = 409, body = ApiError))
)]
async fn rename(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(new): Json<Named>,
) -> Result<Json<Arranged>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        Ok(Json(Arranged { id: app.workspace.rename(&case, &new.file_name)? }))
    })
    .await
}

/// Copies a case file within its folder, never over an existing one.
#[utoipa::path(
    post,
    path = "/api/cases/{id}/copy",
    request_body = Named,
    responses((status = 200, body = Arranged), (status = 409, body = ApiError))
)]
async fn copy(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(new): Json<Named>,
) -> Result<Json<Arranged>, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        Ok(Json(Arranged { id: app.workspace.copy(&case, &new.file_name)? }))
    })
    .await
}

/// The revision of a file at the time of the decision to delete it.
#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(crate) struct Seen {
    /// Its revision.
    revision: String,
}

/// Deletes a case file and its draft, unless the file has changed since.
#[utoipa::path(
    delete,
    path = "/api/cases/{id}",
    params(Seen),
    responses((status = 204), (status = 404, body = ApiError), (status = 409, body = ApiError))
)]
async fn delete(
    State(app): State<App>,
    Path(id): Path<String>,
    Query(seen): Query<Seen>,
) -> Result<StatusCode, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        app.workspace.remove(&case, &seen.revision)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

// Unsaved drafts.

/// Saves a draft.
#[utoipa::path(
    put,
    path = "/api/cases/{id}/draft",
    request_body = Revised,
    responses((status = 204), (status = 404, body = ApiError))
)]
async fn keep(
    State(app): State<App>,
    Path(id): Path<String>,
    Json(typed): Json<Revised>,
) -> Result<StatusCode, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        app.workspace.keep_draft(&case, typed.text, typed.revision)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}

/// Removes a draft.
#[utoipa::path(
    delete,
    path = "/api/cases/{id}/draft",
    responses((status = 204), (status = 404, body = ApiError))
)]
async fn discard(State(app): State<App>, Path(id): Path<String>) -> Result<StatusCode, ApiError> {
    blocking(move || {
        let case = app.workspace.case(&id)?;
        app.workspace.remove_draft(&case)?;
        Ok(StatusCode::NO_CONTENT)
    })
    .await
}
