//! Admission of requests.

use crate::common::Served;

/// The response to `GET` of a path with these headers and no others.
fn get(served: &Served, path: &str, headers: &str) -> crate::common::Answer {
    served.send(&format!("GET {path} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n"), b"")
}

#[test]
fn the_token_becomes_a_cookie() {
    let served = Served::new();
    let host = format!("Host: {}\r\n", served.host());
    let answer = get(&served, &format!("/?token={}", served.token), &host);
    assert_eq!((answer.status, answer.header("location")), (303, Some("/")));
    let cookie = answer.header("set-cookie").unwrap();
    assert!(cookie.ends_with("; Path=/; HttpOnly; SameSite=Strict"), "{cookie}");
    let cookie = cookie.split(';').next().unwrap();
    assert_eq!(cookie, format!("wholestring_{}={}", served.port, served.token));
    let answer = get(&served, "/", &format!("{host}Cookie: other=1; {cookie}\r\n"));
    assert_eq!(answer.status, 200);
    assert_eq!(answer.header("content-type"), Some("text/html; charset=utf-8"));
}

#[test]
fn without_the_token_nothing_is_answered() {
    let served = Served::new();
    let host = format!("Host: {}\r\n", served.host());
    let wrong = "0".repeat(64);
    for path in ["/", "/api/session", "/api/openapi.json", "/nothing", &format!("/?token={wrong}")]
    {
        let answer = get(&served, path, &host);
        assert_eq!(answer.status, 401, "{path}");
        assert!(answer.text().contains("Use the address that it printed"));
        assert_eq!(answer.header("set-cookie"), None);
    }
    for cookie in [&wrong, "", &served.token[..63]] {
        let cookie = format!("{host}Cookie: wholestring_{}={cookie}\r\n", served.port);
        assert_eq!(get(&served, "/api/session", &cookie).status, 401);
    }
    let other_port = format!("{host}Cookie: wholestring_1={}\r\n", served.token);
    assert_eq!(get(&served, "/api/session", &other_port).status, 401);
}

/// The cookie of an admitted page.
fn cookie(served: &Served) -> String {
    format!("Cookie: wholestring_{}={}\r\n", served.port, served.token)
}

#[test]
fn a_foreign_host_is_refused() {
    let served = Served::new();
    let cookie = cookie(&served);
    let port = served.port;
    for host in ["127.0.0.1", "localhost", "[::1]"] {
        let headers = format!("Host: {host}:{port}\r\n{cookie}");
        assert_eq!(get(&served, "/api/session", &headers).status, 200, "{host}");
    }
    let two = format!("127.0.0.1:{port}\r\nHost: evil.example:{port}");
    for host in [
        &format!("evil.example:{port}"),
        "127.0.0.1",
        "localhost:1",
        &format!("127.0.0.1.evil.example:{port}"),
        &format!("127.0.0.2:{port}"),
        &format!("user@127.0.0.1:{port}"),
        &format!("LOCALHOST.:{port}"),
        "",
        &two,
    ] {
        let answer = get(&served, "/api/session", &format!("Host: {host}\r\n{cookie}"));
        assert_eq!(answer.error(421), "foreign_host", "{host}");
    }
    assert_eq!(get(&served, "/api/session", &cookie).status, 421);
    // An absolute address in the request line counts as well.
    let host = format!("Host: 127.0.0.1:{port}\r\n{cookie}");
    let foreign = get(&served, &format!("http://evil.example:{port}/api/session"), &host);
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
        &format!("{own}Origin: http://evil.example\r\n"),
        "Sec-Fetch-Site: same-site\r\n",
        "Sec-Fetch-Site: cross-site\r\n",
        "Sec-Fetch-Site: none\r\n",
        "Origin: http://evil.example\r\nSec-Fetch-Site: same-origin\r\n",
    ] {
        assert_eq!(post(headers), 403, "{headers}");
    }
    // A page of another port of this machine has the cookie; it gets no response.
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
        assert!(policy.starts_with("default-src 'self';"), "{policy}");
        assert!(policy.contains("frame-ancestors 'none'") && !policy.contains("unsafe"));
        let allowed = answer.headers.iter().any(|(key, _)| key.starts_with("access-control"));
        assert!(!allowed);
        assert!(answer.header("cache-control").is_some());
    }
    assert_eq!(served.get("/api/session").header("cache-control"), Some("no-store"));
}
