//! Responses in place of the router's.

use axum::{
    http::StatusCode,
    response::{IntoResponse, Response},
};

use super::entrance;
use crate::api::error::ApiError;

/// Reason why a request does not reach the router.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// It was addressed to another host.
    ForeignHost,
    /// It comes from a page of another origin.
    ForeignOrigin,
    /// It has no cookie of this session.
    NoCookie,
    /// It is for the page of a link, which is public.
    Entrance,
    /// It is for the script of that page.
    Script,
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        match self {
            Self::ForeignHost => ApiError::new(
                StatusCode::MISDIRECTED_REQUEST,
                "foreign_host",
                "this server answers to its own name and port alone, which the link of the \
                 program begins with",
            )
            .into_response(),
            Self::ForeignOrigin => ApiError::new(
                StatusCode::FORBIDDEN,
                "foreign_origin",
                "only a page of this server may send this request",
            )
            .into_response(),
            Self::NoCookie => entrance::stranger(),
            Self::Entrance => entrance::page(),
            Self::Script => entrance::script(),
        }
    }
}
