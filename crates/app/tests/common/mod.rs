//! A served app on a temporary folder, and a client that can send anything over a socket.

#![allow(dead_code, reason = "not every test binary needs all of it")]

mod client;
pub mod link;

use std::{fs, path::Path, thread::JoinHandle};

use serde_json::Value;
use wholestring_app::{Address, Links, Options, Server, Stop};

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

/// Host and code of a link.
pub fn parts(link: &str) -> (String, String) {
    let (host, code) = link.strip_prefix("http://").unwrap().split_once("/enter#").unwrap();
    (host.to_owned(), code.to_owned())
}

/// Sends the form of a link.
pub fn enter(port: u16, host: &str, code: &str) -> Answer {
    let form = format!("code={code}");
    let head = format!(
        "POST /enter HTTP/1.1\r\nHost: {host}\r\nOrigin: null\r\nContent-Length: {}\r\n\
         Content-Type: application/x-www-form-urlencoded\r\n\r\n",
        form.len()
    );
    exchange(port, &head, form.as_bytes())
}

/// The cookie of a response: `name=value`.
pub fn cookie(answer: &Answer) -> Option<String> {
    let cookie = answer.header("set-cookie")?.split(';').next()?;
    Some(cookie.to_owned())
}

/// A served folder; the server ends when this is dropped.
pub struct Served {
    pub folder: tempfile::TempDir,
    pub port: u16,
    /// The server's name and port.
    host: String,
    /// The cookie of an admitted browser: `name=value`.
    pub cookie: String,
    pub links: Links,
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
        Self::at(folder, Address::Automatic)
    }

    /// An existing folder at an address of this kind.
    pub fn at(folder: tempfile::TempDir, address: Address) -> Self {
        let options = Options { folder: folder.path().to_owned(), port: 0, address };
        let server = Server::bind(&options).unwrap();
        let (links, stop) = (server.links(), server.stop());
        let thread = std::thread::spawn(move || server.run().unwrap());
        let (host, code) = parts(&links.address(|| {}).unwrap());
        let port = host.rsplit(':').next().unwrap().parse().unwrap();
        let cookie = cookie(&enter(port, &host, &code)).unwrap();
        Self { folder, port, host, cookie, links, stop, thread: Some(thread) }
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
        self.host.clone()
    }

    /// A new link, as the code that it ends in.
    pub fn code(&self) -> String {
        parts(&self.links.address(|| {}).unwrap()).1
    }

    /// The exchange of a code for a cookie.
    pub fn enter(&self, code: &str) -> Answer {
        enter(self.port, &self.host, code)
    }

    /// The headers of an admitted page.
    pub fn headers(&self) -> String {
        let Self { host, cookie, .. } = self;
        format!("Host: {host}\r\nOrigin: http://{host}\r\nCookie: {cookie}\r\n")
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
