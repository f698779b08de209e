//! A served app on a temporary folder, and a client that can send anything over a socket.

#![allow(dead_code, reason = "not every test binary needs all of it")]

mod client;
pub mod link;

use std::{fs, path::Path, thread::JoinHandle};

use serde_json::Value;
use wholestring_app::{Options, Server, Stop};

pub use client::{Answer, exchange, read_answer};

/// A case that is valid.
pub const CASE: &str = r#"# A slant well.
name = "slant"

[well]
stations = [["0 m", "0 deg", "0 deg"], ["1000 m", "30 deg", "0 deg"]]

[[well.hole]]
kind = "open"
to = "1000 m"
diameter = "8-1/2 in"
friction = 0.3  # a guess

[mud]
density = "1.2 sg"

[[string]]
component = "drill pipe"
od = "127 mm"
id = "108.6 mm"
mass_per_length = "30 kg/m"
length = "to surface"

[operation]
kind = "trip_out"
"#;

/// A served folder; the server ends when this is dropped.
pub struct Served {
    pub folder: tempfile::TempDir,
    pub port: u16,
    pub token: String,
    stop: Stop,
    thread: Option<JoinHandle<()>>,
}

impl Served {
    /// An empty folder.
    pub fn new() -> Self {
        Self::with(&[])
    }

    /// A folder with these files.
    pub fn with(files: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        Self::of(folder)
    }

    /// An existing folder.
    pub fn of(folder: tempfile::TempDir) -> Self {
        let options = Options { folder: folder.path().to_owned(), port: 0 };
        let server = Server::bind(&options).unwrap();
        let url = server.url();
        let (host, token) = url.split_once("/?token=").unwrap();
        let port = host.rsplit(':').next().unwrap().parse().unwrap();
        let stop = server.stop();
        let thread = std::thread::spawn(move || server.run().unwrap());
        Self { folder, port, token: token.to_owned(), stop, thread: Some(thread) }
    }

    /// Ends the server, and starts another on the same folder after `between`.
    pub fn restart(&mut self, between: impl FnOnce(&Path)) {
        self.end();
        between(self.folder.path());
        let folder = std::mem::replace(&mut self.folder, tempfile::tempdir().unwrap());
        *self = Self::of(folder);
    }

    fn end(&mut self) {
        self.stop.stop();
        if let Some(thread) = self.thread.take() {
            let ended = thread.join();
            assert!(ended.is_ok() || std::thread::panicking(), "the server panicked");
        }
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    pub fn host(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }

    /// The headers of an admitted page.
    pub fn headers(&self) -> String {
        let Self { port, token, .. } = self;
        format!(
            "Host: 127.0.0.1:{port}\r\nOrigin: http://127.0.0.1:{port}\r\n\
             Cookie: wholestring_{port}={token}\r\n"
        )
    }

    /// Sends a head and a body as they are, and reads the response.
    pub fn send(&self, head: &str, body: &[u8]) -> Answer {
        exchange(self.port, head, body)
    }

    /// A request with a body, as the page sends it.
    pub fn ask(&self, method: &str, path: &str, content_type: &str, body: &[u8]) -> Answer {
        let headers = self.headers();
        let length = body.len();
        let head = format!(
            "{method} {path} HTTP/1.1\r\n{headers}Content-Type: {content_type}\r\n\
             Content-Length: {length}\r\nConnection: close\r\n\r\n"
        );
        self.send(&head, body)
    }

    pub fn get(&self, path: &str) -> Answer {
        let headers = self.headers();
        self.send(&format!("GET {path} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n"), b"")
    }

    /// A request with JSON.
    pub fn json(&self, method: &str, path: &str, body: &Value) -> Answer {
        self.ask(method, path, "application/json", body.to_string().as_bytes())
    }

    pub fn post(&self, path: &str, body: &Value) -> Answer {
        self.json("POST", path, body)
    }

    pub fn put(&self, path: &str, body: &Value) -> Answer {
        self.json("PUT", path, body)
    }

    pub fn delete(&self, path: &str) -> Answer {
        self.ask("DELETE", path, "application/json", b"")
    }

    /// The id of the case at a path of the folder.
    pub fn id(&self, place: &str) -> String {
        let cases = self.get("/api/cases").json();
        let found = cases.as_array().unwrap().iter().find(|case| case["path"] == place);
        found.unwrap()["id"].as_str().unwrap().to_owned()
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.end();
    }
}
