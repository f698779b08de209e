//! Responses in place of the router's.

use axum::{
    http::{StatusCode, header},
    response::{Html, IntoResponse, Response},
};

use crate::api::error::ApiError;

/// Reason why a request does not reach the router.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// It was addressed to another host.
    ForeignHost,
    /// It comes from a page of another origin.
    ForeignOrigin,
    /// It has neither the cookie nor the token.
    NoToken,
    /// It has the token, and receives the cookie.
    LetIn {
        /// The cookie.
        cookie: String,
    },
}

const NO_TOKEN: &str = "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">\
    <title>wholestring</title><h1>wholestring</h1>\
    <p>This page belongs to whoever started the program. Use the address that it printed: \
    it ends in <code>/?token=</code> and a long number, and is new with every start.</p></html>";

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        match self {
            Self::ForeignHost => ApiError::new(
                StatusCode::MISDIRECTED_REQUEST,
                "foreign_host",
                "this server answers to 127.0.0.1 and localhost with its own port alone",
            )
            .into_response(),
            Self::ForeignOrigin => ApiError::new(
                StatusCode::FORBIDDEN,
                "foreign_origin",
                "only a page of this server may send this request",
            )
            .into_response(),
            Self::NoToken => (StatusCode::UNAUTHORIZED, Html(NO_TOKEN)).into_response(),
            Self::LetIn { cookie } => {
                let headers = [(header::LOCATION, "/".to_owned()), (header::SET_COOKIE, cookie)];
                (StatusCode::SEE_OTHER, headers).into_response()
            }
        }
    }
}
