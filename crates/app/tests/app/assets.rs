//! The page and its files.

use crate::common::Served;

#[test]
fn the_page_is_served_and_kept_by_its_tag() {
    let served = Served::new();
    let page = served.get("/");
    assert_eq!(page.status, 200);
    assert_eq!(page.header("content-type"), Some("text/html; charset=utf-8"));
    assert_eq!(page.header("cache-control"), Some("no-cache"));
    assert_eq!(page.body, std::fs::read("assets/index.html").unwrap());
    let script = served.get("/app.js");
    assert_eq!(script.header("content-type"), Some("text/javascript; charset=utf-8"));
    let tag = script.header("etag").unwrap();
    let headers = format!("{}If-None-Match: {tag}\r\n", served.headers());
    let head = format!("GET /app.js HTTP/1.1\r\n{headers}Connection: close\r\n\r\n");
    let response = served.send(&head, b"");
    assert_eq!((response.status, response.body.len()), (304, 0));
    for path in ["/index.html", "/../Cargo.toml", "/..%2fCargo.toml", "/assets/app.js", "//app.js"]
    {
        assert_eq!(served.get(path).status, 404, "{path}");
    }
}
