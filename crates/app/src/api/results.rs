//! Results in the folder, one by one and side by side.

use std::{
    fs::{self, File},
    io::{self, Read},
};

use axum::{
    body::{Body, Bytes},
    extract::{Path, Query, State},
    http::{HeaderValue, StatusCode, header},
    response::{IntoResponse, Response},
};
use futures_util::stream;
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};
use utoipa_axum::{router::OpenApiRouter, routes};
use wholestring_units::UnitSet;

use super::{Json, blocking, error::ApiError};
use crate::{
    app::App,
    results::{self, Compared, Found, ResultsEntry, compare},
    workspace::{ResultsFile, ResultsPlace},
};

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(list))
        .routes(routes!(of))
        .routes(routes!(file))
        .routes(routes!(page))
        .routes(routes!(compared))
}

/// Results with their files.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct ResultsView {
    #[serde(flatten)]
    entry: ResultsEntry,
    /// Checks, the most severe first.
    checks: Vec<Found>,
    /// The files, by path.
    files: Vec<FileView>,
}

/// A file of results.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct FileView {
    /// Identifier in requests.
    id: String,
    /// Path within the results folder, for display.
    path: String,
    /// Size, bytes.
    bytes: u64,
    /// Whether it is a page, which is shown inside the app.
    is_page: bool,
}

/// All results of the folder, by path.
#[utoipa::path(get, path = "/api/results", responses((status = 200, body = Vec<ResultsEntry>)))]
async fn list(State(app): State<App>) -> Result<Json<Vec<ResultsEntry>>, ApiError> {
    blocking(move || Ok(Json(app.workspace.results().iter().map(ResultsEntry::of).collect()))).await
}

/// Results with their files.
#[utoipa::path(
    get,
    path = "/api/results/{id}",
    responses((status = 200, body = ResultsView), (status = 404, body = ApiError))
)]
async fn of(State(app): State<App>, Path(id): Path<String>) -> Result<Json<ResultsView>, ApiError> {
    blocking(move || {
        let place = app.workspace.results_of(&id)?;
        let files = app.workspace.files_of(&place).into_iter().map(|file| FileView {
            is_page: is_page(&file),
            id: file.id,
            path: file.shown,
            bytes: file.bytes,
        });
        Ok(Json(ResultsView {
            entry: ResultsEntry::of(&place),
            checks: results::checks(&place.path),
            files: files.collect(),
        }))
    })
    .await
}

fn is_page(file: &ResultsFile) -> bool {
    file.shown.ends_with(".html")
}

/// Opens the file with an id: inside the folder, and not a link.
fn open(app: &App, id: &str, name: &str) -> Result<(ResultsFile, File), ApiError> {
    let place: ResultsPlace = app.workspace.results_of(id)?;
    let mut files = app.workspace.files_of(&place).into_iter();
    let file = files.find(|file| file.id == name);
    let file = file.ok_or_else(|| ApiError::not_found("there is no such file in the results"))?;
    let path = app.workspace.inside(&file.path).map_err(ApiError::failed)?;
    let opened = File::open(path).map_err(ApiError::failed)?;
    Ok((file, opened))
}

/// Policy of a file that is nevertheless displayed by a browser: nothing is allowed.
const NOTHING: &str = "sandbox; default-src 'none'; frame-ancestors 'none'";

/// Bytes that are read at once.
const PIECE: usize = 256 << 10;

/// Downloads a file of results.
#[utoipa::path(
    get,
    path = "/api/results/{id}/files/{name}",
    params(
        ("id" = String, Path, description = "The id of the results"),
        ("name" = String, Path, description = "The id of the file")
    ),
    responses(
        (status = 200, body = Vec<u8>, content_type = "application/octet-stream"),
        (status = 404, body = ApiError)
    )
)]
async fn file(
    State(app): State<App>,
    Path((id, name)): Path<(String, String)>,
) -> Result<Response, ApiError> {
    let (file, opened) = blocking(move || open(&app, &id, &name)).await?;
    let name = file.shown.rsplit('/').next().unwrap_or_default();
    let headers = [
        (header::CONTENT_TYPE, HeaderValue::from_static("application/octet-stream")),
        (header::CONTENT_SECURITY_POLICY, HeaderValue::from_static(NOTHING)),
        (header::CONTENT_DISPOSITION, attachment(name)),
    ];
    let pieces = stream::try_unfold(opened, |mut opened| async {
        let read = blocking_read(move || {
            let mut bytes = Vec::new();
            opened.by_ref().take(PIECE as u64).read_to_end(&mut bytes)?;
            Ok((bytes, opened))
        });
        let (bytes, opened) = read.await?;
        Ok::<_, io::Error>((!bytes.is_empty()).then(|| (Bytes::from(bytes), opened)))
    });
    Ok((headers, Body::from_stream(pieces)).into_response())
}

async fn blocking_read<T: Send + 'static>(
    read: impl FnOnce() -> io::Result<T> + Send + 'static,
) -> io::Result<T> {
    tokio::task::spawn_blocking(read).await.map_err(io::Error::other)?
}

/// `attachment` with a name in all letters (RFC 6266, RFC 8187).
fn attachment(name: &str) -> HeaderValue {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._".contains(&byte);
    let text: String = name
        .bytes()
        .map(|byte| match plain(byte) {
            true => char::from(byte).to_string(),
            false => format!("%{byte:02X}"),
        })
        .collect();
    HeaderValue::try_from(format!("attachment; filename*=UTF-8''{text}"))
        .unwrap_or(HeaderValue::from_static("attachment"))
}

/// Maximum size of pages that are shown inside the app, bytes.
const LONGEST_PAGE: u64 = 64 << 20;

/// A page of results, to be shown in a frame: it has an origin of its own and may send no requests
/// to this server. When the reader follows a link to a neighbouring file, it posts the message
/// `{file: PLACE}` to the app.
#[utoipa::path(
    get,
    path = "/api/results/{id}/pages/{name}",
    params(
        ("id" = String, Path, description = "The id of the results"),
        ("name" = String, Path, description = "The id of the file")
    ),
    responses(
        (status = 200, body = String, content_type = "text/html"),
        (status = 404, body = ApiError),
        (status = 413, body = ApiError)
    )
)]
async fn page(
    State(app): State<App>,
    Path((id, name)): Path<(String, String)>,
) -> Result<Response, ApiError> {
    blocking(move || {
        let (file, _) = open(&app, &id, &name)?;
        if !is_page(&file) {
            return Err(ApiError::not_found("this file is no page"));
        }
        if file.bytes > LONGEST_PAGE {
            let message = format!("the page is longer than {} MB: download it", LONGEST_PAGE >> 20);
            return Err(ApiError::new(StatusCode::PAYLOAD_TOO_LARGE, "too_long", message));
        }
        let html = fs::read(&file.path).map_err(ApiError::failed)?;
        let headers = [
            (header::CONTENT_TYPE, "text/html; charset=utf-8"),
            (header::CONTENT_SECURITY_POLICY, results::POLICY),
        ];
        Ok((headers, results::page(html)).into_response())
    })
    .await
}

// Results side by side.

/// Maximum number of compared results.
const MOST: usize = 6;

/// Parameters of a comparison.
#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(crate) struct Asked {
    /// Ids of results, separated by commas: two to six.
    ids: String,
    /// The units: `si`, `metric` or `field`.
    #[serde(default)]
    units: Option<String>,
}

/// Comparison of two to six results: differing inputs, numbers, and curves against depth.
#[utoipa::path(
    get,
    path = "/api/compare",
    params(Asked),
    responses(
        (status = 200, body = Compared),
        (status = 404, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn compared(
    State(app): State<App>,
    Query(query): Query<Asked>,
) -> Result<Json<Compared>, ApiError> {
    blocking(move || {
        let ids: Vec<&str> = query.ids.split(',').filter(|id| !id.is_empty()).collect();
        if !(2..=MOST).contains(&ids.len()) {
            let count = ids.len();
            return Err(ApiError::bad_input(format!(
                "two to {MOST} results are compared, not {count}"
            )));
        }
        let units = query.units.as_deref().unwrap_or("si").parse::<UnitSet>();
        let units = units.map_err(|error| ApiError::bad_input(error.to_string()))?;
        let places = ids.into_iter().map(|id| app.workspace.results_of(id));
        let places: Vec<_> = places.collect::<Result<_, _>>()?;
        Ok(Json(compare(&places, units)))
    })
    .await
}
