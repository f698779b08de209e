//! Results in the folder.

use std::{
    fs::{self, File},
    io::{self, Read},
};

use axum::{
    body::{Body, Bytes},
    extract::{Path, State},
    http::{HeaderValue, StatusCode, header},
    response::{IntoResponse, Response},
};
use futures_util::stream;
use serde::Serialize;
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};

use super::{Json, blocking, error::ApiError};
use crate::{
    app::App,
    results::{self, Found, ResultsEntry},
    workspace::{ResultsFile, ResultsPlace},
};

/// The requests of this module.
pub(crate) fn routes() -> OpenApiRouter<App> {
    OpenApiRouter::new()
        .routes(routes!(list))
        .routes(routes!(of))
        .routes(routes!(file))
        .routes(routes!(page))
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
