//! The page and what belongs to it, embedded.

use axum::{
    Router,
    http::{HeaderMap, StatusCode, header},
    response::{IntoResponse, Response},
    routing::get,
};

use crate::{app::App, fingerprint::fingerprint};

/// A file of the bundle.
#[derive(Debug)]
struct Asset {
    /// Where it is asked for.
    path: &'static str,
    content_type: &'static str,
    bytes: &'static [u8],
}

/// Names the files of `assets/`, each with its path on the server and its type.
macro_rules! assets {
    ($($path:literal = $file:literal as $content_type:literal),* $(,)?) => {
        &[$(Asset {
            path: $path,
            content_type: $content_type,
            bytes: include_bytes!(concat!("../assets/", $file)),
        }),*]
    };
}

const ASSETS: &[Asset] = assets! {
    "/" = "index.html" as "text/html; charset=utf-8",
};

/// A route for each file.
pub(crate) fn routes() -> Router<App> {
    ASSETS.iter().fold(Router::new(), |router, asset| {
        let tag = format!("\"{}\"", fingerprint(asset.bytes));
        router.route(asset.path, get(async move |headers: HeaderMap| answer(asset, &tag, &headers)))
    })
}

/// The file, unless the browser has it.
fn answer(asset: &Asset, tag: &str, headers: &HeaderMap) -> Response {
    let kept = headers.get(header::IF_NONE_MATCH).and_then(|tags| tags.to_str().ok());
    let describes = [
        (header::CONTENT_TYPE, asset.content_type.to_owned()),
        (header::ETAG, tag.to_owned()),
        (header::CACHE_CONTROL, "no-cache".to_owned()),
    ];
    if kept.is_some_and(|tags| tags.split(',').any(|one| one.trim() == tag)) {
        return (StatusCode::NOT_MODIFIED, describes).into_response();
    }
    (describes, asset.bytes).into_response()
}
