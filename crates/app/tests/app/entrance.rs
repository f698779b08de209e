//! Links that let one browser in, once, and the name under which the server is reached.

use std::{
    fs,
    sync::mpsc,
    time::{Duration, Instant},
};

use wholestring_app::Address;

use crate::common::{Answer, Served, cookie, enter, exchange, parts};

fn get(served: &Served, path: &str, headers: &str) -> Answer {
    served.send(&format!("GET {path} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n"), b"")
}

#[test]
fn a_link_becomes_a_cookie_once() {
    let served = Served::new();
    let (used, uses) = mpsc::channel();
    let link = served.links.address(move || used.send(()).unwrap()).unwrap();
    let (host, code) = parts(&link);
    assert_eq!(host, served.host());
    let answer = served.enter(&code);
    assert_eq!(answer.status, 200, "{}", answer.text());
    let set = answer.header("set-cookie").unwrap();
    assert!(set.ends_with("; Path=/; HttpOnly; SameSite=Strict"), "{set}");
    assert!(!set.contains("Domain") && !set.contains(&code));
    let host = format!("Host: {host}\r\n");
    let page = get(&served, "/", &format!("{host}Cookie: other=1; {}\r\n", served.cookie));
    assert_eq!(page.status, 200);
    assert_eq!(page.header("content-type"), Some("text/html; charset=utf-8"));
    // The program is notified, and makes the next link.
    uses.recv_timeout(Duration::from_secs(10)).unwrap();

    // The second use of the same link, by another browser.
    let again = served.enter(&code);
    assert_eq!((again.status, again.header("set-cookie")), (403, None));
    assert!(again.text().contains("This link is used up: each link lets in one browser, once"));
    assert!(again.text().contains("The terminal of the program shows a new link"));
    assert!(!again.text().contains(&code));
    // The next link lets that browser in.
    assert_eq!(served.enter(&served.code()).status, 200);
    assert!(uses.try_recv().is_err());
}

#[test]
fn a_browser_that_is_in_may_use_its_link_again() {
    let served = Served::new();
    let headers = served.headers();
    let head = format!("POST /enter HTTP/1.1\r\n{headers}Content-Length: 6\r\n\r\n");
    let answer = served.send(&head, b"code=x");
    assert_eq!((answer.status, answer.header("set-cookie")), (200, None));
}

#[test]
fn wrong_codes_admit_nobody() {
    let served = Served::new();
    let code = served.code();
    let long = "x".repeat(5000);
    let upper = code.to_uppercase();
    let session = served.cookie.split_once('=').unwrap().1;
    for wrong in ["", "0", &code[1..], &format!("{code}0"), &upper, "%00", session, &long] {
        let answer = served.enter(wrong);
        assert_eq!((answer.status, answer.header("set-cookie")), (403, None), "{wrong}");
        assert!(!answer.text().contains(&code));
    }
    let other = Served::new();
    assert_eq!(enter(other.port, &other.host(), &code).status, 403);
    // None of these attempts has used it up.
    assert_eq!(served.enter(&code).status, 200);
    served.links.close();
    assert_eq!(served.enter(&served.code()).status, 200);
}

/// The public page of a link, its script, and the way on to the app keep the code out of addresses.
#[test]
fn no_address_and_no_answer_has_the_code() {
    let served = Served::new();
    let link = served.links.address(|| {}).unwrap();
    let (host, code) = parts(&link);
    // In the fragment, which a browser does not send.
    assert!(link.ends_with(&format!("/enter#{code}")));
    let headers = format!("Host: {host}\r\n");
    let page = get(&served, "/enter", &headers);
    assert_eq!((page.status, page.header("set-cookie")), (200, None));
    assert!(page.text().contains("<script src=\"/enter.js\">") && !page.text().contains(&code));
    let policy = page.header("content-security-policy").unwrap();
    assert!(policy.contains("script-src 'self'") && policy.contains("form-action 'self'"));
    let script = get(&served, "/enter.js", &headers);
    assert_eq!(script.header("content-type"), Some("text/javascript; charset=utf-8"));
    let script = script.text();
    let replaced = script.find("history.replaceState(null, \"\", location.pathname)").unwrap();
    assert!(replaced < script.find("submit()").unwrap());
    let answers = [
        get(&served, &format!("/?token={code}"), &headers),
        get(&served, &format!("/enter?code={code}"), &headers),
        get(&served, "/", "Host: evil.example\r\n"),
        get(&served, "/api/session", &headers),
        served.enter("wrong"),
        served.send("nonsense\r\n\r\n", b""),
    ];
    for answer in answers {
        assert!(!answer.text().contains(&code), "{}", answer.text());
        assert_eq!(answer.header("set-cookie"), None);
        assert_eq!(answer.header("location"), None);
    }
    let entered = served.enter(&code);
    assert!(entered.text().contains("http-equiv=\"refresh\" content=\"0;url=/\""));
    let debugged = format!("{:?}", served.links);
    assert!(!debugged.contains(&code), "{debugged}");
}

/// The browser is started with the path of a file, because all users see command lines.
#[test]
fn the_file_of_a_link_is_private_and_deleted_after_use() {
    let mut served = Served::new();
    let path = served.links.file().unwrap();
    assert!(path.is_absolute());
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = |path: &std::path::Path| path.metadata().unwrap().permissions().mode() & 0o777;
        assert_eq!(mode(&path), 0o600);
        assert_eq!(mode(path.parent().unwrap()), 0o700);
    }
    let page = fs::read_to_string(&path).unwrap();
    let action = format!("action=\"http://{}/enter\"", served.host());
    assert!(page.contains("method=\"post\"") && page.contains(&action), "{page}");
    let code = page.split("name=\"code\" value=\"").nth(1).unwrap().split('"').next().unwrap();
    assert!(!path.to_str().unwrap().contains(code));
    let answer = served.enter(code);
    assert!(cookie(&answer).is_some(), "{}", answer.text());
    let begin = Instant::now();
    while path.parent().unwrap().exists() {
        assert!(begin.elapsed() < Duration::from_secs(10), "{}", path.display());
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_eq!(served.enter(code).status, 403);
    // A file that no browser has opened is deleted at the end.
    let unused = served.links.file().unwrap();
    assert!(unused.exists());
    served.restart(|_| ());
    assert!(!unused.parent().unwrap().exists());
}

#[test]
fn every_start_has_a_host_and_a_cookie_of_its_own() {
    let (one, other) = (Served::new(), Served::new());
    for served in [&one, &other] {
        let name = served.host();
        let name = name.strip_suffix(&format!(".localhost:{}", served.port)).unwrap();
        // Eighty bits: no other server can send the browser to its own port of this name.
        assert_eq!(name.len(), 16);
    }
    assert_ne!(one.host().split('.').next(), other.host().split('.').next());
    let value = |served: &Served| served.cookie.split_once('=').unwrap().1.to_owned();
    assert_ne!(value(&one), value(&other));
    // The cookie is worth nothing at a name that other ports share.
    for host in ["127.0.0.1", "localhost", "[::1]", "other.localhost"] {
        let headers = format!("Host: {host}:{}\r\nCookie: {}\r\n", one.port, one.cookie);
        assert_eq!(get(&one, "/api/session", &headers).error(421), "foreign_host", "{host}");
    }
}

/// Browsers try `::1` first for names under `localhost`: nobody else may have the port there.
#[test]
fn the_port_is_taken_on_both_loopback_addresses() {
    let served = Served::new();
    if std::net::TcpListener::bind("[::1]:0").is_err() {
        return;
    }
    let error = std::net::TcpListener::bind(("::1", served.port)).unwrap_err();
    assert_eq!(error.kind(), std::io::ErrorKind::AddrInUse);
    let mut stream = std::net::TcpStream::connect(("::1", served.port)).unwrap();
    let request = format!("GET /api/session HTTP/1.1\r\n{}\r\n", served.headers());
    std::io::Write::write_all(&mut stream, request.as_bytes()).unwrap();
    assert_eq!(crate::common::read_answer(&mut stream).status, 200);
}

/// For a browser that does not resolve names under `localhost`.
#[test]
fn a_plain_address_serves_too() {
    let served = Served::at(tempfile::tempdir().unwrap(), Address::Plain);
    assert_eq!(served.host(), format!("127.0.0.1:{}", served.port));
    assert_eq!(served.get("/api/session").status, 200);
    let head = format!("GET / HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", served.port);
    assert_eq!(exchange(served.port, &head, b"").status, 421);
}
