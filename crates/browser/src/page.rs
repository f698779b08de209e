//! How the page calls the engine: it writes bytes into [`room`], calls, and reads what is left at
//! [`left`]. The clock, and where complaints go, are the page's.

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
    /// What the page has written.
    static GIVEN: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    /// What it is to read.
    static LEFT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    /// The live string of this worker.
    static SEAT: RefCell<Option<Seat>> = const { RefCell::new(None) };
    static COMPLAINS: Cell<bool> = const { Cell::new(false) };
}

#[cfg(target_family = "wasm")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Takes a sentence about a mistake of the program's own.
    fn complain(sentence: *const u8, bytes: usize);
}

/// Tells the page why the program ends: it cannot go on after that.
fn complain_of_panics() {
    if COMPLAINS.replace(true) {
        return;
    }
    panic::set_hook(Box::new(|about| {
        let sentence = about.to_string();
        #[cfg(target_family = "wasm")]
        // SAFETY: the page reads so many bytes there, and nothing else.
        unsafe {
            complain(sentence.as_ptr(), sentence.len());
        }
        #[cfg(not(target_family = "wasm"))]
        eprintln!("{sentence}");
    }));
}

/// Room for so many bytes of what is asked. It holds until the next call.
#[unsafe(no_mangle)]
pub extern "C" fn room(bytes: usize) -> *mut u8 {
    complain_of_panics();
    GIVEN.with_borrow_mut(|given| {
        given.clear();
        given.resize(bytes, 0);
        given.as_mut_ptr()
    })
}

/// Where what was left for the page begins.
#[unsafe(no_mangle)]
pub extern "C" fn left() -> *const u8 {
    LEFT.with_borrow(Vec::as_ptr)
}

/// How many bytes were left for the page.
#[unsafe(no_mangle)]
pub extern "C" fn left_bytes() -> usize {
    LEFT.with_borrow(Vec::len)
}

fn leave(bytes: Vec<u8>) {
    LEFT.set(bytes);
}

/// Leaves an answer, and gives the status that HTTP has for it.
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

fn with_seat<T>(of: impl FnOnce(&mut Seat) -> Result<T, Refusal>) -> Result<T, Refusal> {
    SEAT.with_borrow_mut(|seat| match seat {
        Some(seat) => of(seat),
        None => Err(Refusal::not_found("there is no live string")),
    })
}

/// Answers a request, as JSON; of the live string where there is one.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> u32 {
    let given = GIVEN.take();
    answered(request(&given).and_then(|request| {
        let answer = SEAT.with_borrow_mut(|seat| match seat {
            Some(seat) => seat.answer(&request),
            None => request.answer(),
        });
        answer.map(String::into_bytes)
    }))
}

/// Begins a live string as a request of so many bytes says; where more bytes follow, it is the
/// string of a moment that was kept. Leaves what a list says of it.
#[unsafe(no_mangle)]
pub extern "C" fn begin(request_bytes: usize) -> u32 {
    let given = GIVEN.take();
    let (head, kept) = given.split_at(request_bytes.min(given.len()));
    answered(request(head).and_then(|request| {
        let seat = Seat::begin(&request, (!kept.is_empty()).then_some(kept))?;
        let entry = seat.entry()?;
        SEAT.set(Some(seat));
        Ok(entry.into_bytes())
    }))
}

/// Leaves a moment of the live string, as it is kept.
#[unsafe(no_mangle)]
pub extern "C" fn keep() -> u32 {
    let given = GIVEN.take();
    answered(request(&given).and_then(|request| with_seat(|seat| seat.kept(&request))))
}

/// Leaves what is known of a moment that was kept, as JSON.
#[unsafe(no_mangle)]
pub extern "C" fn kept() -> u32 {
    let given = GIVEN.take();
    answered(kept_moment(&given).map(String::into_bytes))
}

/// Takes in a page that knows nothing of the live string: all that is there is news to it.
#[unsafe(no_mangle)]
pub extern "C" fn attend() {
    SEAT.with_borrow_mut(|seat| {
        if let Some(seat) = seat {
            seat.attend();
        }
    });
}

/// Does what the page says to the live string; leaves why not, where it cannot be, else nothing.
#[unsafe(no_mangle)]
pub extern "C" fn hear() {
    let given = GIVEN.take();
    let text = String::from_utf8_lossy(&given);
    let refused = SEAT.with_borrow_mut(|seat| seat.as_mut().and_then(|seat| seat.hear(&text)));
    leave(match refused {
        Some(Message::Text(text)) => text.into_bytes(),
        Some(Message::Binary(bytes)) => bytes,
        None => Vec::new(),
    });
}

/// Takes the live string forward for so many milliseconds at most; how many of them nothing is due
/// then.
#[unsafe(no_mangle)]
pub extern "C" fn go_on(budget_ms: f64) -> f64 {
    let budget = Duration::try_from_secs_f64(1e-3 * budget_ms).unwrap_or_default();
    let wait = SEAT.with_borrow_mut(|seat| seat.as_mut().map(|seat| seat.go_on(budget)));
    wait.map_or(f64::INFINITY, |wait| 1e3 * wait.as_secs_f64())
}

/// Leaves the next message of the live string: 1 for JSON, 2 for samples or a frame, 0 for none.
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
