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

/// Sends a gigabyte in chunks, as far as it is accepted. Returns the status of the response; 0 if
/// the connection was closed before the end.
fn upload(served: &Served, path: &str, content_type: &str, begin: &[u8]) -> (u16, u64) {
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
    let mut chunk = b"100000\r\n".to_vec();
    chunk.resize(chunk.len() + (1 << 20), b' ');
    chunk.extend_from_slice(b"\r\n");
    let taken = (0..1024).take_while(|_| stream.write_all(&chunk).is_ok()).count();
    (read_answer(&mut stream).status, taken as u64)
}

#[test]
#[cfg(target_os = "linux")]
fn it_stays_below_300_MB() {
    let served = Served::new();
    // A gigabyte each, by as many clients as are admitted.
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                let (status, taken_MB) = upload(&served, "/api/cases", "application/json", b"");
                assert!(matches!(status, 413 | 0), "{status}");
                assert!(taken_MB < 100, "{taken_MB} MB were taken");
            });
        }
    });
    // The same as an imported file, which is stored on disk.
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                let form = "multipart/form-data; boundary=X";
                let begin = b"--X\r\nContent-Disposition: form-data; name=\"file\"; \
                    filename=\"log.las\"\r\n\r\n";
                let (status, taken_MB) = upload(&served, "/api/import", form, begin);
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
