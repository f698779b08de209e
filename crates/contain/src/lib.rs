//! Calls of third-party code that may panic on a damaged file, contained in one place.
//!
//! A reader of a foreign format is third-party code, and an unexpected byte may make it panic.
//! [`contain`] turns that into an error, and nothing is printed, because the cause is a damaged
//! file and not a fault of the program.
#![warn(missing_docs)]

use std::{
    any::Any,
    cell::Cell,
    panic::{self, AssertUnwindSafe},
    sync::Once,
};

thread_local! {
    /// Number of nested calls of [`contain`] in this thread.
    static DEPTH: Cell<usize> = const { Cell::new(0) };
}

/// The message of a contained panic.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Panicked(pub String);

/// Calls `once`; a panic in it, on this thread, is an error and prints nothing.
///
/// State that `once` modifies may be inconsistent after a panic, so it should be state that is
/// dropped afterwards. Exhausted memory and a stack overflow end the program nevertheless.
///
/// # Errors
/// The message of the panic.
///
/// ```
/// use wholestring_contain::{Panicked, contain};
///
/// assert_eq!(contain(|| 6 * 7), Ok(42));
/// assert_eq!(contain(|| -> u8 { panic!("no") }), Err(Panicked("no".into())));
/// ```
pub fn contain<T>(once: impl FnOnce() -> T) -> Result<T, Panicked> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let previous_hook = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            // The count of a thread that is ending no longer exists; its panics are reported.
            if DEPTH.try_with(Cell::get).unwrap_or(0) == 0 {
                previous_hook(info);
            }
        }));
    });
    DEPTH.set(DEPTH.get() + 1);
    let done = panic::catch_unwind(AssertUnwindSafe(once));
    DEPTH.set(DEPTH.get() - 1);
    done.map_err(|payload| Panicked(message(&*payload)))
}

fn message(payload: &(dyn Any + Send)) -> String {
    match (payload.downcast_ref::<&str>(), payload.downcast_ref::<String>()) {
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
