//! The embedded page and its files.

use std::future::ready;

use axum::{
    Router,
    http::{HeaderMap, StatusCode, header},
    response::{IntoResponse, Response},
    routing::get,
};

use crate::{app::App, workspace::fingerprint};

/// The files of `assets/`, by name: `build.rs` lists them.
const FILES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/assets.rs"));

/// The page itself, which is returned for the root path.
const PAGE: &str = "index.html";

/// A file with its response headers.
#[derive(Debug, Clone)]
struct Asset {
    content_type: &'static str,
    bytes: &'static [u8],
    /// The entity tag.
    tag: String,
}

/// A route for each file.
pub(crate) fn routes() -> Router<App> {
    FILES.iter().fold(Router::new(), |router, (name, bytes)| {
        let tag = format!("\"{}\"", fingerprint(bytes));
        let asset = Asset { content_type: content_type(name), bytes, tag };
        let path = if *name == PAGE { "/".to_owned() } else { format!("/{name}") };
        router.route(&path, get(move |headers: HeaderMap| ready(asset.answer(&headers))))
    })
}

impl Asset {
    /// The file, unless the browser has it.
    fn answer(&self, headers: &HeaderMap) -> Response {
        let known_tags = headers.get(header::IF_NONE_MATCH).and_then(|tags| tags.to_str().ok());
        let described = [
            (header::CONTENT_TYPE, self.content_type),
            (header::ETAG, self.tag.as_str()),
            (header::CACHE_CONTROL, "no-cache"),
        ];
        if known_tags.is_some_and(|tags| tags.split(',').any(|one| one.trim() == self.tag)) {
            return (StatusCode::NOT_MODIFIED, described).into_response();
        }
        (described, self.bytes).into_response()
    }
}

/// The content type of a file by its name.
fn content_type(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("json" | "map") => "application/json",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("woff2") => "font/woff2",
        Some("wasm") => "application/wasm",
        Some("txt") => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_the_bundle_has_a_type() {
        assert!(FILES.iter().any(|(name, _)| *name == PAGE));
        for (name, _) in FILES {
            assert_ne!(content_type(name), "application/octet-stream", "{name}");
        }
    }
}
