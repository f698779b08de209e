//! Overload of the server.

use std::{
    io::{Read, Write},
    net::TcpStream,
    time::{Duration, Instant},
};

use crate::common::{Served, exchange, read_answer};

#[test]
fn huge_and_many_headers_are_refused() {
    let served = Served::new();
    let host = served.host();
    let long = "x".repeat(200_000);
    let answer = served.send(&format!("GET / HTTP/1.1\r\nHost: {host}\r\nX: {long}\r\n\r\n"), b"");
    assert!(matches!(answer.status, 431 | 0), "{}", answer.status);
    let many = "X: y\r\n".repeat(1000);
    let answer = served.send(&format!("GET / HTTP/1.1\r\nHost: {host}\r\n{many}\r\n"), b"");
    assert!(matches!(answer.status, 431 | 400 | 0), "{}", answer.status);
    let answer = served.send(&format!("GET /{long} HTTP/1.1\r\nHost: {host}\r\n\r\n"), b"");
    assert!(matches!(answer.status, 414 | 431 | 0), "{}", answer.status);
    assert_eq!(served.get("/api/session").status, 200);
}

#[test]
fn deep_json_is_refused() {
    let served = Served::new();
    for (open, close) in [("[", "]"), ("{\"a\":", "}")] {
        let body = format!("{}1{}", open.repeat(100_000), close.repeat(100_000));
        let text = format!("{{\"file_name\":\"a.toml\",\"text\":\"\",\"beside\":{body}}}");
        let answer = served.ask("POST", "/api/cases", "application/json", text.as_bytes());
        assert!(matches!(answer.status, 400 | 422), "{}", answer.status);
        // Also where any JSON is allowed.
        let text = format!("{{\"text\":\"\",\"changes\":[{{\"set\":\"a\",\"to\":{body}}}]}}");
        let answer = served.ask("POST", "/api/cases/0/edit", "application/json", text.as_bytes());
        assert!(matches!(answer.status, 400 | 422), "{}", answer.status);
    }
}

#[test]
fn who_sends_no_request_is_cut_off() {
    let served = Served::new();
    let mut slow: Vec<TcpStream> = (0..3).map(|_| connect(&served)).collect();
    slow[1].write_all(b"GET / HTTP/1.1\r\n").unwrap();
    // The third has sent one request, and keeps its connection open idly.
    let head = format!("GET /api/session HTTP/1.1\r\n{}\r\n", served.headers());
    slow[2].write_all(head.as_bytes()).unwrap();
    assert_eq!(read_answer(&mut slow[2]).status, 200);
    let begin = Instant::now();
    while begin.elapsed() < Duration::from_secs(14) {
        // A byte now and then does not help.
        let _ = slow[1].write_all(b"X");
        std::thread::sleep(Duration::from_secs(1));
    }
    for (index, stream) in slow.iter_mut().enumerate() {
        stream.set_read_timeout(Some(Duration::from_millis(500))).unwrap();
        let mut rest = Vec::new();
        // Closed or reset; if the server still waited, the read would time out.
        let end = stream.read_to_end(&mut rest).map_err(|error| error.kind());
        assert_ne!(end, Err(std::io::ErrorKind::WouldBlock), "{index}");
    }
}

#[test]
fn a_thousand_connections_keep_nobody_out_for_long() {
    let served = Served::new();
    let port = served.port;
    // Clients without a permit wait in the system's queue, which is limited, too.
    let attempts = (0..50).map(|_| {
        std::thread::spawn(move || (0..20).filter_map(|_| try_connect(port)).collect::<Vec<_>>())
    });
    let attempts: Vec<_> = attempts.collect();
    let idle: Vec<TcpStream> =
        attempts.into_iter().flat_map(|attempt| attempt.join().unwrap()).collect();
    assert!(idle.len() >= 128, "{}", idle.len());
    // No permit is lost: half of those finish, the others are disconnected.
    let begin = Instant::now();
    drop(idle.into_iter().step_by(2));
    assert_eq!(served.get("/api/session").status, 200);
    assert!(begin.elapsed() < Duration::from_secs(40), "{:?}", begin.elapsed());
}

/// Connections that send nothing, or half a request, or one that is not admitted, delay nobody.
#[test]
fn five_hundred_silent_connections_delay_nobody() {
    let served = Served::new();
    let silent: Vec<TcpStream> = (0..500)
        .map(|number| {
            let mut stream = connect(&served);
            let sent: &[u8] = match number % 3 {
                0 => b"",
                1 => b"GET / HTTP/1.1\r\nX: ",
                _ => b"POST /enter HTTP/1.1\r\nHost: x\r\nContent-Length: 9\r\n\r\n",
            };
            let _ = stream.write_all(sent);
            stream
        })
        .collect();
    let begin = Instant::now();
    assert_eq!(served.get("/api/session").status, 200);
    let first = begin.elapsed();
    for _ in 0..5 {
        assert_eq!(served.get("/api/session").status, 200);
    }
    println!("{first:?}, and {:?} with five more", begin.elapsed());
    // On a loaded machine the system's queue may be full for a moment, and a client tries again
    // after one second, then after two.
    assert!(begin.elapsed() < Duration::from_secs(5), "{first:?}, {:?}", begin.elapsed());
    drop(silent);
}

/// An admitted connection is not replaced, however many others come.
#[test]
fn an_admitted_connection_keeps_its_place() {
    let served = Served::new();
    let mut admitted = connect(&served);
    let head = format!("GET /api/session HTTP/1.1\r\n{}\r\n", served.headers());
    admitted.write_all(head.as_bytes()).unwrap();
    assert_eq!(read_answer(&mut admitted).status, 200);
    let silent: Vec<TcpStream> = (0..200).map(|_| connect(&served)).collect();
    assert_eq!(served.get("/api/session").status, 200);
    admitted.write_all(head.as_bytes()).unwrap();
    assert_eq!(read_answer(&mut admitted).status, 200);
    drop(silent);
}

#[test]
fn a_body_that_is_too_long_is_refused_before_it_is_taken() {
    let served = Served::new();
    let headers = served.headers();
    let head = format!(
        "POST /api/cases HTTP/1.1\r\n{headers}Content-Type: application/json\r\n\
         Content-Length: {}\r\n\r\n",
        1_u64 << 30
    );
    assert_eq!(exchange(served.port, &head, b"{").status, 413);
}

fn connect(served: &Served) -> TcpStream {
    TcpStream::connect(("127.0.0.1", served.port)).unwrap()
}

fn try_connect(port: u16) -> Option<TcpStream> {
    let address = ([127, 0, 0, 1], port).into();
    TcpStream::connect_timeout(&address, Duration::from_millis(50)).ok()
}
