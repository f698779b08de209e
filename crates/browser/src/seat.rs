//! A live string: the driller's seat.

use std::{
    pin::pin,
    sync::Arc,
    task::{Context, Poll, Waker},
    time::Duration,
};

use serde::Serialize;
use tokio::sync::watch;
use wholestring_case::parse;
use wholestring_runner::Instant;
use wholestring_screens::{
    live::{
        At, Back, Beginning, Engine, FrameNow, Keeps, KeptEntry, KeptString, LiveEntry, LiveError,
        LiveString, NewString, Start, Status, TextOfCase, Told, Viewing, frame_packet, schedule,
    },
    refusal::Refusal,
};

use crate::requests::{Request, json};

/// Limits of the memory of a string.
const KEEPS: Keeps = Keeps { samples: 1 << 16, checkpoint_bytes: 48 << 20 };

/// A message for the page.
#[derive(Debug)]
pub enum Message {
    /// JSON.
    Text(String),
    /// Samples, or a frame.
    Binary(Vec<u8>),
}

/// A live string and the page that views it.
pub struct Seat {
    engine: Engine,
    string: Arc<LiveString>,
    viewing: Viewing,
    frames: watch::Receiver<Arc<FrameNow>>,
    status: watch::Receiver<Arc<Status>>,
    is_told: bool,
}

/// Description of a saved moment.
#[derive(Debug, Serialize)]
struct KeptMoment<'a> {
    #[serde(flatten)]
    entry: KeptEntry,
    text: &'a str,
}

impl Seat {
    /// Starts a string at time zero, or continues a saved one.
    ///
    /// # Errors
    /// An invalid case, a string that cannot be solved, and bytes that are no saved moment.
    pub fn begin(request: &Request, moment: Option<&[u8]>) -> Result<Self, Refusal> {
        let (case_id, text, start) = match moment {
            Some(bytes) => {
                let string = KeptString::of_bytes(bytes);
                let string =
                    string.ok_or_else(|| Refusal::bad_input("the saved string is damaged"))?;
                let start = Start::At { bytes: Arc::new(string.checkpoint), events: string.events };
                (string.case_id, string.text, start)
            }
            None => {
                let new: NewString = request.body()?;
                let text = new.text.unwrap_or_default();
                (new.case, text, Start::New { operation: new.operation })
            }
        };
        let case = Arc::new(parse(&request.file, text.as_bytes(), &request.files(), &[])?);
        let from = Beginning { case_id, text, case, start };
        let engine = Engine::begin(&request.id, from, &KEEPS)?;
        let string = engine.string();
        let (frames, status) = (string.frames(), string.status());
        let viewing = Viewing::of(&string);
        let mut seat = Self { engine, string, viewing, frames, status, is_told: false };
        seat.attend();
        Ok(seat)
    }

    /// Attaches a page without any state of the string, so that everything is sent to it.
    pub fn attend(&mut self) {
        self.frames.mark_changed();
        self.status.mark_changed();
        (self.viewing, self.is_told) = (Viewing::of(&self.string), false);
    }

    /// Its list entry.
    ///
    /// # Errors
    /// None for a valid string.
    pub fn entry(&self) -> Result<String, Refusal> {
        json(&LiveEntry::of_string(&self.string))
    }

    /// Advances for at most this long; returns the time until the next turn.
    pub fn go_on(&mut self, budget: Duration) -> Duration {
        let begun = Instant::now();
        loop {
            let wait = self.engine.turn(self.string.wanted_now());
            if !wait.is_zero() || begun.elapsed() >= budget {
                return wait;
            }
        }
    }

    /// Handles a message of the page; returns the reason of a refusal.
    pub fn hear(&mut self, text: &str) -> Option<Message> {
        let message = self.viewing.hear(text)?;
        Some(Message::Text(Told::Refused { message }.text()))
    }

    /// The next message for the page; none if nothing is new.
    pub fn news(&mut self) -> Option<Message> {
        if !self.is_told {
            self.is_told = true;
            return Some(Message::Text(Told::Layout(&self.string.layout).text()));
        }
        if self.status.has_changed().unwrap_or(false) {
            let now = self.viewing.status(&self.status.borrow_and_update().clone());
            return Some(Message::Text(Told::Status(&now).text()));
        }
        if let Some((bytes, _)) = self.viewing.samples() {
            return Some(Message::Binary(bytes));
        }
        if self.frames.has_changed().unwrap_or(false) {
            let frame = self.frames.borrow_and_update().clone();
            return Some(Message::Binary(frame_packet(frame.epoch, frame.time_s, &frame.columns)));
        }
        None
    }

    /// Answers a request about the string.
    ///
    /// # Errors
    /// An invalid request, and one that is not supported in a browser.
    pub fn answer(&mut self, request: &Request) -> Result<String, Refusal> {
        match request.asks.as_str() {
            "entry" => self.entry(),
            "layout" => json(&self.string.layout),
            "recording" => json(&self.string.events()),
            "rewind" => {
                let Back { checkpoint, replay } = request.body()?;
                let string = self.string.clone();
                self.done(string.rewind(checkpoint, replay))?;
                json(&())
            }
            "schedule" => {
                let TextOfCase { text } = request.body()?;
                let events = self.string.events();
                json(&schedule(&text, &events, &request.file, &request.files())?)
            }
            other => request.answer().map_err(|_| {
                Refusal::not_found(format!("`{other}` is not a request to a live string"))
            }),
        }
    }

    /// A moment in the saved form, at a checkpoint or now.
    ///
    /// # Errors
    /// An unknown checkpoint.
    pub fn kept(&mut self, request: &Request) -> Result<Vec<u8>, Refusal> {
        let At { checkpoint } = request.body()?;
        let string = self.string.clone();
        self.done(string.kept_at(checkpoint))?.bytes().map_err(Refusal::failed)
    }

    /// The result of a request to the string, once its engine has had its turn.
    fn done<T>(
        &mut self,
        future: impl Future<Output = Result<T, LiveError>>,
    ) -> Result<T, Refusal> {
        let (mut pinned, mut context) = (pin!(future), Context::from_waker(Waker::noop()));
        for _ in 0..2 {
            if let Poll::Ready(done) = pinned.as_mut().poll(&mut context) {
                return Ok(done?);
            }
            self.engine.turn(self.string.wanted_now());
        }
        match pinned.as_mut().poll(&mut context) {
            Poll::Ready(done) => Ok(done?),
            Poll::Pending => Err(Refusal::failed("the string does not answer")),
        }
    }
}

/// List entry of a saved string, and the text of its case.
///
/// # Errors
/// Bytes that are no saved moment.
pub fn kept_moment(bytes: &[u8]) -> Result<String, Refusal> {
    let string = KeptString::of_bytes(bytes);
    let string = string.ok_or_else(|| Refusal::bad_input("the saved string is damaged"))?;
    let KeptString { case_id, name, operation, time_s, text, .. } = string;
    let (case, title) = (case_id, name);
    let name = String::new();
    let entry = KeptEntry { name, case, title, operation, time_s, modified_ms: 0 };
    json(&KeptMoment { entry, text: &text })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use serde_json::{Value, json};

    use super::*;

    const TEXT: &str = wholestring_cases::SLANT.text;

    fn request(asks: &str, body: Value) -> Request {
        let (asks, file) = (asks.to_owned(), "slant.toml".to_owned());
        Request { asks, id: "1".to_owned(), file, beside: BTreeMap::new(), body }
    }

    fn told(seat: &mut Seat, kind: &str) -> Value {
        loop {
            match seat.news() {
                Some(Message::Text(text)) => {
                    let message: Value = serde_json::from_str(&text).expect("JSON");
                    if message["type"] == kind {
                        return message;
                    }
                }
                Some(Message::Binary(bytes)) => assert!(bytes.len() >= 24),
                None => panic!("no message of type {kind}"),
            }
        }
    }

    /// A string runs, is rewound, and continues elsewhere from a saved moment.
    #[test]
    fn a_string_is_driven_and_kept() {
        let body = json!({ "case": "slant.toml", "text": TEXT, "operation": "drill" });
        let mut seat = Seat::begin(&request("begin", body), None).expect("a live string");
        let layout = told(&mut seat, "layout");
        assert_eq!((&layout["operation"], &layout["id"]), (&json!("drill"), &json!("1")));
        assert!(
            seat.hear(r#"{"pace": "max"}"#).is_none() && seat.hear(r#"{"run": true}"#).is_none()
        );
        while seat.engine.string().status().borrow().time_s < 0.5 {
            seat.go_on(Duration::from_millis(20));
        }
        assert_eq!(told(&mut seat, "status")["state"], "running");
        assert!(seat.hear(r#"{"pace": 0}"#).is_some());
        seat.answer(&request("rewind", json!({ "checkpoint": 1 }))).expect("a way back");
        seat.go_on(Duration::ZERO);
        let moment = seat.kept(&request("keep", json!({ "checkpoint": 1 }))).expect("a moment");
        let known: Value =
            serde_json::from_str(&kept_moment(&moment).expect("known")).expect("JSON");
        assert_eq!((&known["operation"], &known["text"]), (&json!("drill"), &json!(TEXT)));
        let again = Seat::begin(&request("begin", Value::Null), Some(&moment));
        assert!(again.is_ok());
        let damaged = Seat::begin(&request("begin", Value::Null), Some(&moment[..40]));
        assert!(damaged.is_err_and(|refusal| refusal.status == 422));
    }

    #[test]
    fn what_needs_the_program_is_refused() {
        let refused = request("jobs", Value::Null).answer().expect_err("a refusal");
        assert_eq!(refused.status, 404);
    }
}
