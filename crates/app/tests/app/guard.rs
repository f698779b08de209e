//! Admission of requests.

use crate::common::Served;

/// The response to `GET` of a path with these headers and no others.
fn get(served: &Served, path: &str, headers: &str) -> crate::common::Answer {
    served.send(&format!("GET {path} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n"), b"")
}

#[test]
fn without_the_cookie_nothing_is_answered() {
    let served = Served::new();
    let host = format!("Host: {}\r\n", served.host());
    let wrong = "0".repeat(52);
    for path in ["/", "/api/session", "/api/openapi.json", "/nothing", "/app.js", "/?code=x"] {
        let answer = get(&served, path, &host);
        assert_eq!(answer.status, 401, "{path}");
        assert!(answer.text().contains("Use the link that it printed"));
        assert_eq!(answer.header("set-cookie"), None);
        // Whoever is not admitted keeps no connection.
        assert_eq!(answer.header("connection"), Some("close"));
    }
    let value = served.cookie.split_once('=').unwrap().1;
    for cookie in [&wrong, "", &value[..51]] {
        let cookie = format!("{host}Cookie: wholestring_{}={cookie}\r\n", served.port);
        assert_eq!(get(&served, "/api/session", &cookie).status, 401);
    }
    let other_port = format!("{host}Cookie: wholestring_1={value}\r\n");
    assert_eq!(get(&served, "/api/session", &other_port).status, 401);
}

/// The cookie of an admitted page.
fn cookie(served: &Served) -> String {
    format!("Cookie: {}\r\n", served.cookie)
}

#[test]
fn a_foreign_host_is_refused() {
    let served = Served::new();
    let cookie = cookie(&served);
    let (host, port) = (served.host(), served.port);
    let own = format!("Host: {host}\r\n{cookie}");
    assert_eq!(get(&served, "/api/session", &own).status, 200);
    let name = host.split(':').next().unwrap();
    let two = format!("{host}\r\nHost: evil.example:{port}");
    for host in [
        &format!("evil.example:{port}"),
        &format!("127.0.0.1:{port}"),
        &format!("localhost:{port}"),
        &format!("[::1]:{port}"),
        name,
        &format!("{name}:1"),
        &format!("{name}.evil.example:{port}"),
        &format!("a.{host}"),
        &format!("user@{host}"),
        &format!("{}.:{port}", name.to_uppercase()),
        "",
        &two,
    ] {
        let answer = get(&served, "/api/session", &format!("Host: {host}\r\n{cookie}"));
        assert_eq!(answer.error(421), "foreign_host", "{host}");
        // The name is not revealed.
        assert!(!answer.text().contains(name), "{}", answer.text());
    }
    assert_eq!(get(&served, "/api/session", &cookie).status, 421);
    // An absolute address in the request line counts as well.
    let foreign = get(&served, &format!("http://evil.example:{port}/api/session"), &own);
    assert_eq!(foreign.status, 421);
}

#[test]
fn what_changes_something_comes_from_our_own_page() {
    let served = Served::new();
    let (host, cookie) = (served.host(), cookie(&served));
    let post = |headers: &str| {
        let head = format!(
            "POST /api/cases HTTP/1.1\r\nHost: {host}\r\n{cookie}{headers}Content-Length: 2\r\n\
             Content-Type: application/json\r\nConnection: close\r\n\r\n"
        );
        served.send(&head, b"{}").status
    };
    let own = format!("Origin: http://{host}\r\n");
    assert_eq!(post(&own), 422);
    assert_eq!(post("Sec-Fetch-Site: same-origin\r\n"), 422);
    for headers in [
        "",
        "Origin: null\r\n",
        "Origin: http://evil.example\r\n",
        "Origin: http://127.0.0.1:1\r\n",
        &format!("Origin: https://{host}\r\n"),
        &format!("Origin: http://{host}.evil.example\r\n"),
        &format!("Origin: http://localhost:{}\r\n", served.port),
        &format!("Origin: http://127.0.0.1:{}\r\n", served.port),
        &format!("{own}Origin: http://evil.example\r\n"),
        "Sec-Fetch-Site: same-site\r\n",
        "Sec-Fetch-Site: cross-site\r\n",
        "Sec-Fetch-Site: none\r\n",
        "Origin: http://evil.example\r\nSec-Fetch-Site: same-origin\r\n",
    ] {
        assert_eq!(post(headers), 403, "{headers}");
    }
    // A page of another origin whose requests have the cookie gets no response.
    let head = format!("Host: {host}\r\n{cookie}");
    for site in ["same-site", "cross-site"] {
        let answer = get(&served, "/api/session", &format!("{head}Sec-Fetch-Site: {site}\r\n"));
        assert_eq!(answer.error(403), "foreign_origin");
    }
    let upgrade = format!("{head}Connection: upgrade\r\nUpgrade: websocket\r\n");
    assert_eq!(get(&served, "/api/live/0/socket", &upgrade).status, 403);
    let foreign = format!("{upgrade}Origin: http://evil.example\r\n");
    assert_eq!(get(&served, "/api/live/0/socket", &foreign).status, 403);
}

#[test]
fn every_answer_has_the_headers() {
    let served = Served::new();
    let no_cookie = format!("Host: {}\r\n", served.host());
    let answers = [
        served.get("/"),
        served.get("/api/session"),
        served.get("/nothing"),
        get(&served, "/", &no_cookie),
        get(&served, "/", "Host: evil.example\r\n"),
    ];
    for answer in answers {
        assert_eq!(answer.header("x-content-type-options"), Some("nosniff"));
        assert_eq!(answer.header("referrer-policy"), Some("no-referrer"));
        assert_eq!(answer.header("cross-origin-opener-policy"), Some("same-origin"));
        assert_eq!(answer.header("cross-origin-resource-policy"), Some("same-origin"));
        let policy = answer.header("content-security-policy").unwrap();
        // Public pages may even less.
        let is_strict = ["default-src 'self';", "default-src 'none';"];
        assert!(is_strict.iter().any(|begin| policy.starts_with(begin)), "{policy}");
        assert!(policy.contains("frame-ancestors 'none'") && !policy.contains("unsafe"));
        let allowed = answer.headers.iter().any(|(key, _)| key.starts_with("access-control"));
        assert!(!allowed);
        assert!(answer.header("cache-control").is_some());
    }
    assert_eq!(served.get("/api/session").header("cache-control"), Some("no-store"));
}
