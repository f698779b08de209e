//! Case files of the folder.

use std::time::{Duration, Instant};

use axum::extract::{Path, State};
use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_case::parse;
use wholestring_screens::cases::Title;

use super::{Json, blocking, error::ApiError};
use crate::{
    app::App,
    results::{CaseVerdict, Verdicts},
    workspace::{CaseFile, Draft, NewFile, Workspace, millis},
};

/// The requests of this noun.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new().routes(routes!(list, create)).routes(routes!(open, save))
}

/// A case of the folder.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct CaseEntry {
    /// What requests call it.
    id: String,
    /// Its place in the folder, for the eye.
    path: String,
    /// What it is called in results.
    name: String,
    /// The first that is wrong with it; null where nothing is, or where there was no time to look.
    problem: Option<String>,
    /// The verdict on it, of its newest results; null where it was not computed yet.
    verdict: Option<CaseVerdict>,
    /// Whether there is a text of it that was not saved.
    has_draft: bool,
    /// When it was changed, milliseconds since 1970.
    modified_ms: u64,
}

/// Cases are read for so long; those that come later are listed without.
const READING_TIME: Duration = Duration::from_secs(2);

/// The case files of the folder, by their places.
#[utoipa::path(get, path = "/api/cases", responses((status = 200, body = Vec<CaseEntry>)))]
async fn list(State(app): State<App>) -> Result<Json<Vec<CaseEntry>>, ApiError> {
    blocking(move || {
        let verdicts = Verdicts::of(&app.workspace, READING_TIME);
        let begin = Instant::now();
        let is_read = || begin.elapsed() < READING_TIME;
        let entry = |case: CaseFile| entry(&app.workspace, case, &verdicts, is_read());
        Ok(Json(app.workspace.cases().into_iter().map(entry).collect()))
    })
    .await
}

fn entry(workspace: &Workspace, case: CaseFile, verdicts: &Verdicts, is_read: bool) -> CaseEntry {
    let stem = case.path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    let title = match case.read() {
        Err(error) => Title { problem: Some(error.to_string()), ..Title::default() },
        Ok(_) if !is_read => Title::default(),
        Ok(read) => Title::of(&case.shown, &read.text, &workspace.beside(&case)),
    };
    let Title { name, problem, settings } = title;
    let verdict = settings.and_then(|settings| verdicts.on(name.as_deref()?, &settings));
    CaseEntry {
        name: name.or(stem).unwrap_or_default(),
        problem,
        verdict,
        has_draft: workspace.draft(&case).is_some(),
        modified_ms: millis(case.modified),
        path: case.shown,
        id: case.id,
    }
}

/// A file that is to be made.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct GivenFile {
    /// Its name, no path.
    file_name: String,
    /// What it holds.
    text: String,
}

impl GivenFile {
    fn new_file(&self) -> NewFile<'_> {
        NewFile { name: &self.file_name, text: &self.text }
    }
}

/// A case that is to be made.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewCase {
    /// The name of its file, which ends in `.toml`.
    file_name: String,
    /// Its text.
    text: String,
    /// Files that it names. One that is there already must hold the same.
    #[serde(default)]
    beside: Vec<GivenFile>,
}

/// A case that was made.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Created {
    /// What requests call it.
    id: String,
}

/// Makes a case file, never over one that is there.
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
    /// What requests call it.
    id: String,
    /// Its place in the folder, for the eye.
    path: String,
    /// What stands in the file.
    text: String,
    /// What the file is at this time: another text has another.
    revision: String,
    /// What was typed and not saved.
    #[schema(value_type = Option<OpenDraft>)]
    draft: Option<Draft>,
    /// The files that it names and that are there.
    beside: Vec<String>,
}

/// What was typed and not saved.
#[derive(ToSchema)]
#[allow(dead_code, reason = "the document describes by it what the workspace keeps")]
pub(crate) struct OpenDraft {
    /// The text.
    text: String,
    /// The revision of the file when it was opened.
    base_revision: String,
    /// When it was kept, milliseconds since 1970.
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
        // What is wrong with it, `check` says; here it names its files.
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

/// A text, and what the file was when it was opened.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Revised {
    /// The text.
    pub(super) text: String,
    /// What the file was when it was opened.
    pub(super) revision: String,
}

/// A case that was saved.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Saved {
    /// What the file is now.
    revision: String,
}

/// Saves a text in the place of the file's, unless that is another by now. Its draft goes.
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
