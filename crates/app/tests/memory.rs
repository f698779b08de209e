//! Memory under attack, as Linux counts it.
#![cfg(target_os = "linux")]

mod common;

use std::{fs, io::Write, net::TcpStream};

use common::{Served, read_answer};
use serde_json::json;

/// Peak memory of this process so far, MB: server and client.
fn most_memory_MB() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmHWM:")).unwrap();
    line.split_whitespace().nth(1).unwrap().parse::<u64>().unwrap() / 1024
}

/// Sends a gigabyte as `piece` in chunks, as far as it is accepted. Returns the status of the
/// response, 0 if the connection was closed before the end, and the accepted megabytes.
fn upload(
    served: &Served,
    path: &str,
    content_type: &str,
    begin: &[u8],
    piece: &[u8],
) -> (u16, u64) {
    let mut stream = TcpStream::connect(("127.0.0.1", served.port)).unwrap();
    let headers = served.headers();
    let head = format!(
        "POST {path} HTTP/1.1\r\n{headers}Content-Type: {content_type}\r\n\
         Transfer-Encoding: chunked\r\n\r\n"
    );
    stream.write_all(head.as_bytes()).unwrap();
    if !begin.is_empty() {
        stream.write_all(format!("{:x}\r\n", begin.len()).as_bytes()).unwrap();
        stream.write_all(&[begin, b"\r\n"].concat()).unwrap();
    }
    let mut chunk = format!("{:x}\r\n", piece.len()).into_bytes();
    chunk.extend_from_slice(piece);
    chunk.extend_from_slice(b"\r\n");
    let count = (1 << 30) / piece.len();
    let accepted = (0..count).take_while(|_| stream.write_all(&chunk).is_ok()).count();
    let answer = read_answer(&mut stream);
    (answer.status, (accepted * piece.len()) as u64 >> 20)
}

const FORM: &str = "multipart/form-data; boundary=X";
const FILE: &[u8] =
    b"--X\r\nContent-Disposition: form-data; name=\"file\"; filename=\"log.las\"\r\n\r\n";

/// A chunked body has no declared length: whatever it consists of, it is refused at the limit.
#[test]
fn a_chunked_body_is_bounded_whatever_it_consists_of() {
    let served = Served::new();
    let text = b"\r\n--X\r\nContent-Disposition: form-data; name=\"name\"\r\n\r\n";
    let spaces = vec![b' '; 1 << 20];
    let texts = [text.as_slice(), &vec![b'a'; 60 << 10]].concat();
    let empty =
        b"\r\n--X\r\nContent-Disposition: form-data; name=\"choices\"\r\n\r\n{}".repeat(500);
    let (none, json): (&[u8], _) = (b"", "application/json");
    for (name, path, content_type, begin, piece) in [
        ("one file", "/api/import", FORM, FILE, spaces.as_slice()),
        ("one file in small chunks", "/api/import", FORM, FILE, &spaces[..1000]),
        ("texts without end", "/api/import", FORM, none, &texts),
        ("empty texts without end", "/api/import", FORM, none, &empty),
        ("no part", "/api/import", FORM, none, &spaces),
        ("after the last part", "/api/import", FORM, b"--X--\r\n", &spaces),
        ("head of a part", "/api/import", FORM, b"--X\r\nA: ", &spaces),
        ("JSON", "/api/cases", json, none, &spaces),
        ("no body is read", "/api/nothing", json, none, &spaces),
        ("a link", "/enter", json, none, &spaces),
    ] {
        let (status, accepted_MB) = upload(&served, path, content_type, begin, piece);
        println!("{name}: status {status}, {accepted_MB} MB");
        assert!(matches!(status, 400..=422 | 200 | 0), "{name}: {status}");
        // The limit is 64 MB; the rest are buffers of both sides.
        assert!(accepted_MB < 100, "{name}: {accepted_MB} MB were taken");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn it_stays_below_300_MB() {
    let served = Served::new();
    // A gigabyte each, by as many clients as are admitted.
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                let (status, taken_MB) =
                    upload(&served, "/api/cases", "application/json", b"", &[b' '; 1 << 20]);
                assert!(matches!(status, 413 | 0), "{status}");
                assert!(taken_MB < 100, "{taken_MB} MB were taken");
            });
        }
    });
    // The same as an imported file, which is stored on disk.
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                let (status, taken_MB) =
                    upload(&served, "/api/import", FORM, FILE, &[b' '; 1 << 20]);
                assert!(matches!(status, 413 | 0), "{status}");
                assert!(taken_MB < 100, "{taken_MB} MB were taken");
            });
        }
    });
    // The largest accepted request, many times.
    let text = "x".repeat(15 << 20);
    let body = json!({"file_name": "a.txt", "text": text}).to_string();
    std::thread::scope(|scope| {
        for _ in 0..6 {
            scope.spawn(|| {
                let answer = served.ask("POST", "/api/cases", "application/json", body.as_bytes());
                assert_eq!(answer.error(422), "bad_input");
            });
        }
    });
    // Repeated responses.
    for _ in 0..200 {
        assert_eq!(served.get("/api/catalogue").status, 200);
    }
    let most = most_memory_MB();
    println!("{most} MB");
    assert!(most < 300, "{most} MB");
}
