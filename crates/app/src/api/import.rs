//! A case from the files of other programs.

use axum::{
    extract::{
        DefaultBodyLimit, FromRequest, Multipart, Request, State,
        multipart::{Field, MultipartError},
    },
    http::StatusCode,
};
use utoipa::ToSchema;
use utoipa_axum::{router::OpenApiRouter, routes};

use super::{Json, blocking, error::ApiError};
use crate::{
    app::App,
    import::{Reading, Said, Uploads, read},
    limits::Limits,
};

/// The requests of this module.
pub(crate) fn routes(limits: &Limits) -> OpenApiRouter<App> {
    // Files are stored on disk while they arrive. The limit is on the form as a whole, because
    // small parts, and bytes outside of them, can be repeated without end in a chunked body.
    OpenApiRouter::new()
        .routes(routes!(import))
        .layer(DefaultBodyLimit::max(limits.body_bytes + FORM_BYTES))
}

/// Space for the texts of a form and the heads of its parts, bytes.
const FORM_BYTES: usize = 1 << 20;

/// Maximum size of a text field of the form, bytes.
const LONGEST_TEXT: usize = 64 << 10;

/// An import, as a multipart form.
#[derive(ToSchema)]
#[allow(
    dead_code,
    reason = "it describes the form in the API document, which is read part by part"
)]
pub(crate) struct ImportForm {
    /// The files.
    #[schema(value_type = Vec<String>, format = Binary)]
    file: Vec<Vec<u8>>,
    /// Information that is missing in the files, as JSON.
    choices: Option<Said>,
    /// The name of the case file.
    name: String,
    /// `true` to write the case; nothing is written by default.
    write: Option<bool>,
}

/// The received parts of a form.
#[derive(Default)]
struct Form {
    uploads: Uploads,
    choices: Said,
    name: String,
    write: bool,
    /// Bytes so far.
    bytes: usize,
}

fn refused(error: &MultipartError, app: &App) -> ApiError {
    match error.status() {
        StatusCode::PAYLOAD_TOO_LARGE => too_long(app.limits.body_bytes),
        status => ApiError::new(status, "bad_form", error.body_text()),
    }
}

impl Form {
    async fn take(&mut self, mut field: Field<'_>, app: &App) -> Result<(), ApiError> {
        let name = field.name().unwrap_or_default().to_owned();
        if name == "file" {
            let file_name = field.file_name().unwrap_or_default().to_owned();
            let file = app.workspace.temporary_file()?;
            let upload = self.uploads.begin(&file_name, file).map_err(ApiError::bad_input)?;
            while let Some(bytes) = field.chunk().await.map_err(|error| refused(&error, app))? {
                self.bytes += bytes.len();
                most(self.bytes, app.limits.body_bytes)?;
                tokio::task::block_in_place(|| upload.write(&bytes)).map_err(ApiError::failed)?;
            }
            return Ok(());
        }
        let mut text = Vec::new();
        while let Some(bytes) = field.chunk().await.map_err(|error| refused(&error, app))? {
            text.extend_from_slice(&bytes);
            most(text.len(), LONGEST_TEXT)?;
        }
        let text =
            String::from_utf8(text).map_err(|error| ApiError::bad_input(error.to_string()))?;
        match name.as_str() {
            "choices" => {
                self.choices = serde_json::from_str(&text)
                    .map_err(|error| ApiError::bad_input(format!("choices: {error}")))?;
            }
            "name" => self.name = text,
            "write" => {
                self.write =
                    text.parse().map_err(|error| ApiError::bad_input(format!("write: {error}")))?;
            }
            _ => {
                let message = format!("`{}` is no part of an import", name.escape_debug());
                return Err(ApiError::bad_input(message));
            }
        }
        Ok(())
    }
}

fn most(bytes: usize, most: usize) -> Result<(), ApiError> {
    match bytes <= most {
        true => Ok(()),
        false => Err(too_long(most)),
    }
}

fn too_long(most: usize) -> ApiError {
    let message = format!(
        "more than {} MB are not imported by the page: `wholestring import` reads larger files",
        (most >> 20).max(1)
    );
    ApiError::new(StatusCode::PAYLOAD_TOO_LARGE, "too_long", message)
}

/// Returns the contents of the files and the case that they make, or the questions to answer first.
/// Nothing is written except by `write`, and never over an existing file.
#[utoipa::path(
    post,
    path = "/api/import",
    request_body(content = ImportForm, content_type = "multipart/form-data"),
    responses(
        (status = 200, body = Reading),
        (status = 409, body = ApiError),
        (status = 413, body = ApiError),
        (status = 422, body = ApiError)
    )
)]
async fn import(State(app): State<App>, request: Request) -> Result<Json<Reading>, ApiError> {
    let parts = Multipart::from_request(request, &app).await;
    let mut parts =
        parts.map_err(|error| ApiError::new(error.status(), "no_form", error.body_text()))?;
    let mut form = Form::default();
    while let Some(field) = parts.next_field().await.map_err(|error| refused(&error, &app))? {
        form.take(field, &app).await?;
    }
    if form.uploads.is_empty() {
        return Err(ApiError::bad_input("no file is given"));
    }
    if form.name.is_empty() {
        return Err(ApiError::bad_input("the case has no name"));
    }
    blocking(move || {
        let Form { uploads, choices, name, write, .. } = form;
        Ok(Json(read(&uploads, &choices, &name, write, &app.workspace)?))
    })
    .await
}
