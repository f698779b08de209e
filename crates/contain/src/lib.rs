//! Calls of other people's code that may panic on a damaged file, contained in one place.
//!
//! A reader of a foreign format is somebody else's, and a byte that nobody thought of can make it
//! panic. [`contain`] turns that into an error, and nothing is printed: to whoever gave the file it
//! is a damaged file and no fault of the program.
#![warn(missing_docs)]

use std::{
    any::Any,
    cell::Cell,
    panic::{self, AssertUnwindSafe},
    sync::Once,
};

thread_local! {
    /// How many calls of [`contain`] this thread is in.
    static DEPTH: Cell<usize> = const { Cell::new(0) };
}

/// What a contained panic said.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Panicked(pub String);

/// Calls `of`; a panic in it, on this thread, is an error and prints nothing.
///
/// What `of` was changing when it panicked may be half changed: give it what is dropped afterwards.
/// Memory that runs out and a stack that overflows end the program all the same.
///
/// # Errors
/// What the panic said.
///
/// ```
/// use wholestring_contain::{Panicked, contain};
///
/// assert_eq!(contain(|| 6 * 7), Ok(42));
/// assert_eq!(contain(|| -> u8 { panic!("no") }), Err(Panicked("no".into())));
/// ```
pub fn contain<T>(of: impl FnOnce() -> T) -> Result<T, Panicked> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let previous_hook = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            // A thread that is ending has no such count any more: its panics are reported.
            if DEPTH.try_with(Cell::get).unwrap_or(0) == 0 {
                previous_hook(info);
            }
        }));
    });
    DEPTH.set(DEPTH.get() + 1);
    let done = panic::catch_unwind(AssertUnwindSafe(of));
    DEPTH.set(DEPTH.get() - 1);
    done.map_err(|said| Panicked(message(&*said)))
}

fn message(said: &(dyn Any + Send)) -> String {
    match (said.downcast_ref::<&str>(), said.downcast_ref::<String>()) {
        (Some(text), _) => (*text).to_owned(),
        (_, Some(text)) => text.clone(),
        _ => "it panicked".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_inside_another_call_is_the_inner_ones() {
        let outer = contain(|| {
            let inner = contain(|| -> () { panic!("inner {}", 1) });
            assert_eq!(inner, Err(Panicked("inner 1".into())));
            7
        });
        assert_eq!(outer, Ok(7));
        assert_eq!(DEPTH.get(), 0);
    }
}
