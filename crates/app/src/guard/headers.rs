//! Security headers of every response.

use axum::{
    http::{HeaderName, HeaderValue, header},
    response::Response,
};

/// Default headers of every response.
const EVERYWHERE: [(HeaderName, &str); 5] = [
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (header::CACHE_CONTROL, "no-store"),
];

/// Only scripts, styles and requests of the app itself; no embedding, nothing inline.
const POLICY: &str = "default-src 'self'; img-src 'self' data: blob:; object-src 'none'; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Adds the headers. `host` is the server's name in the browser: the scheme of a socket differs
/// from the page's, and not every browser treats them as the same origin.
pub(crate) fn put_headers(mut response: Response, host: Option<&HeaderValue>) -> Response {
    let headers = response.headers_mut();
    for (name, value) in EVERYWHERE {
        headers.entry(name).or_insert(HeaderValue::from_static(value));
    }
    let host = host.and_then(|host| host.to_str().ok()).filter(|host| is_plain(host));
    let sockets = host.map_or_else(String::new, |host| format!(" ws://{host}"));
    let policy = format!("{POLICY}; connect-src 'self'{sockets}");
    if let Ok(policy) = HeaderValue::try_from(policy) {
        headers.entry(header::CONTENT_SECURITY_POLICY).or_insert(policy);
    }
    response
}

/// Whether it contains only a host and a port.
fn is_plain(host: &str) -> bool {
    host.bytes().all(|byte| byte.is_ascii_alphanumeric() || b".:[]-".contains(&byte))
}
