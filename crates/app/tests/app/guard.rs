//! Who is let in.

use crate::common::Served;

/// The answer to `GET` of a path with these headers and no others.
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
