//! Origin of a request: the page that made the browser send it.

use axum::http::{HeaderMap, header};

use super::refusal::Refusal;

/// The header in which a browser gives the relation of the requesting page to the server.
const FETCH_SITE: &str = "sec-fetch-site";

/// Refuses requests that do not come from the app's own page.
pub(super) fn ours(headers: &HeaderMap, host: &str) -> Result<(), Refusal> {
    let mut origins = headers.get_all(header::ORIGIN).iter();
    let is_ours = match (origins.next(), origins.next()) {
        (Some(origin), None) => {
            let origin = origin.to_str().ok().and_then(|origin| origin.strip_prefix("http://"));
            origin == Some(host)
        }
        (None, _) => site(headers) == Some("same-origin"),
        _ => false,
    };
    if is_ours { Ok(()) } else { Err(Refusal::ForeignOrigin) }
}

/// Refuses requests that a browser sends for a page of another origin, including other ports of
/// this machine, because they carry the app's cookie.
pub(super) fn not_foreign(headers: &HeaderMap) -> Result<(), Refusal> {
    match site(headers) {
        None | Some("same-origin" | "none") => Ok(()),
        Some(_) => Err(Refusal::ForeignOrigin),
    }
}

fn site(headers: &HeaderMap) -> Option<&str> {
    headers.get(FETCH_SITE).map(|site| site.to_str().unwrap_or("cross-site"))
}
