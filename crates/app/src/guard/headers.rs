//! What a browser is told about every answer.

use axum::{
    http::{HeaderName, HeaderValue, header},
    response::Response,
};

/// The headers that are the same for every answer, where it has none of its own.
const EVERYWHERE: [(HeaderName, &str); 5] = [
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (header::CACHE_CONTROL, "no-store"),
];

/// Scripts, styles and requests of our own alone; no frames around us, nothing inline.
const POLICY: &str = "default-src 'self'; img-src 'self' data: blob:; object-src 'none'; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Puts them on. `host` is what the browser calls us: a socket's scheme is another than the
/// page's, and not every browser takes it for the same.
pub(crate) fn put(mut response: Response, host: Option<&HeaderValue>) -> Response {
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

/// Whether it can be no more than a host and a port.
fn is_plain(host: &str) -> bool {
    host.bytes().all(|byte| byte.is_ascii_alphanumeric() || b".:[]-".contains(&byte))
}
