//! Interface of the page to the engine: it writes bytes into [`room`], calls, and reads the result
//! at [`left`]. The page provides the clock and the reporting of errors.

use std::{
    cell::{Cell, RefCell},
    panic,
    time::Duration,
};

use crate::{
    requests::{Request, json},
    seat::{Message, Seat, kept_moment},
};
use wholestring_screens::refusal::Refusal;

thread_local! {
    /// Bytes written by the page.
    static GIVEN: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    /// Bytes to be read by the page.
    static LEFT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    /// The live string of this worker.
    static SEAT: RefCell<Option<Seat>> = const { RefCell::new(None) };
    static COMPLAINS: Cell<bool> = const { Cell::new(false) };
}

#[cfg(target_family = "wasm")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Receives a message about an internal error.
    fn complain(sentence: *const u8, bytes: usize);
}

/// Reports a panic to the page, after which the program cannot continue.
fn complain_of_panics() {
    if COMPLAINS.replace(true) {
        return;
    }
    panic::set_hook(Box::new(|about| {
        let sentence = about.to_string();
        #[cfg(target_family = "wasm")]
        // SAFETY: the page reads this many bytes there, and nothing else.
        unsafe {
            complain(sentence.as_ptr(), sentence.len());
        }
        #[cfg(not(target_family = "wasm"))]
        eprintln!("{sentence}");
    }));
}

/// A buffer for the bytes of a request, valid until the next call.
#[unsafe(no_mangle)]
pub extern "C" fn room(bytes: usize) -> *mut u8 {
    complain_of_panics();
    GIVEN.with_borrow_mut(|input| {
        input.clear();
        input.resize(bytes, 0);
        input.as_mut_ptr()
    })
}

/// Start of the bytes for the page.
#[unsafe(no_mangle)]
pub extern "C" fn left() -> *const u8 {
    LEFT.with_borrow(Vec::as_ptr)
}

/// Number of bytes for the page.
#[unsafe(no_mangle)]
pub extern "C" fn left_bytes() -> usize {
    LEFT.with_borrow(Vec::len)
}

fn leave(bytes: Vec<u8>) {
    LEFT.set(bytes);
}

/// Stores a response, and returns its HTTP status.
fn answered(with: Result<Vec<u8>, Refusal>) -> u32 {
    let (status, bytes) = match with {
        Ok(bytes) => (200, bytes),
        Err(refusal) => {
            (u32::from(refusal.status), json(&refusal).unwrap_or_default().into_bytes())
        }
    };
    leave(bytes);
    status
}

fn request(bytes: &[u8]) -> Result<Request, Refusal> {
    serde_json::from_slice(bytes).map_err(|error| Refusal::new(400, "bad_json", error.to_string()))
}

fn with_seat<T>(once: impl FnOnce(&mut Seat) -> Result<T, Refusal>) -> Result<T, Refusal> {
    SEAT.with_borrow_mut(|seat| match seat {
        Some(seat) => once(seat),
        None => Err(Refusal::not_found("there is no live string")),
    })
}

/// Answers a JSON request; one about the live string if there is one.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> u32 {
    let input = GIVEN.take();
    answered(request(&input).and_then(|request| {
        let answer = SEAT.with_borrow_mut(|seat| match seat {
            Some(seat) => seat.answer(&request),
            None => request.answer(),
        });
        answer.map(String::into_bytes)
    }))
}

/// Starts a live string from a request of this many bytes; if more bytes follow, they are a saved
/// moment of the string. Stores its list entry.
#[unsafe(no_mangle)]
pub extern "C" fn begin(request_bytes: usize) -> u32 {
    let input = GIVEN.take();
    let (head, moment) = input.split_at(request_bytes.min(input.len()));
    answered(request(head).and_then(|request| {
        let seat = Seat::begin(&request, (!moment.is_empty()).then_some(moment))?;
        let entry = seat.entry()?;
        SEAT.set(Some(seat));
        Ok(entry.into_bytes())
    }))
}

/// Stores a moment of the live string, in the saved form.
#[unsafe(no_mangle)]
pub extern "C" fn keep() -> u32 {
    let input = GIVEN.take();
    answered(request(&input).and_then(|request| with_seat(|seat| seat.kept(&request))))
}

/// Stores the description of a saved moment, as JSON.
#[unsafe(no_mangle)]
pub extern "C" fn kept() -> u32 {
    let input = GIVEN.take();
    answered(kept_moment(&input).map(String::into_bytes))
}

/// Attaches a page without any state of the live string, so that everything is sent to it.
#[unsafe(no_mangle)]
pub extern "C" fn attend() {
    SEAT.with_borrow_mut(|seat| {
        if let Some(seat) = seat {
            seat.attend();
        }
    });
}

/// Handles a message of the page for the live string; stores the reason of a refusal, else nothing.
#[unsafe(no_mangle)]
pub extern "C" fn hear() {
    let input = GIVEN.take();
    let text = String::from_utf8_lossy(&input);
    let refused = SEAT.with_borrow_mut(|seat| seat.as_mut().and_then(|seat| seat.hear(&text)));
    leave(match refused {
        Some(Message::Text(text)) => text.into_bytes(),
        Some(Message::Binary(bytes)) => bytes,
        None => Vec::new(),
    });
}

/// Advances the live string for at most this many milliseconds; returns the milliseconds until the
/// next turn.
#[unsafe(no_mangle)]
pub extern "C" fn go_on(budget_ms: f64) -> f64 {
    let budget = Duration::try_from_secs_f64(1e-3 * budget_ms).unwrap_or_default();
    let wait = SEAT.with_borrow_mut(|seat| seat.as_mut().map(|seat| seat.go_on(budget)));
    wait.map_or(f64::INFINITY, |wait| 1e3 * wait.as_secs_f64())
}

/// Stores the next message of the live string: 1 for JSON, 2 for samples or a frame, 0 for none.
#[unsafe(no_mangle)]
pub extern "C" fn news() -> u32 {
    match SEAT.with_borrow_mut(|seat| seat.as_mut().and_then(Seat::news)) {
        Some(Message::Text(text)) => {
            leave(text.into_bytes());
            1
        }
        Some(Message::Binary(bytes)) => {
            leave(bytes);
            2
        }
        None => 0,
    }
}
