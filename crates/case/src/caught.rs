//! Panics that are told as mistakes, and not on the screen besides.

use std::{
    any::Any,
    cell::Cell,
    panic::{self, AssertUnwindSafe},
    sync::Once,
};

thread_local! {
    /// Whether a panic of this thread is caught, and told by whoever catches it.
    static IS_CAUGHT: Cell<bool> = const { Cell::new(false) };
}

/// Does work that may panic; what it said where it did.
///
/// Such a panic prints nothing; those of other threads, and of this one outside the work, print as ever.
///
/// # Errors
/// The message of the panic.
pub fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let told = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            if !IS_CAUGHT.get() {
                told(panic);
            }
        }));
    });
    let before = IS_CAUGHT.replace(true);
    let done = panic::catch_unwind(AssertUnwindSafe(work));
    IS_CAUGHT.set(before);
    done.map_err(|panic| message(&*panic))
}

fn message(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "it did not say what".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_panic_says_is_told() {
        assert_eq!(caught(|| 2), Ok(2));
        assert_eq!(caught(|| panic!("a word")), Err::<(), _>("a word".into()));
        let number = 7;
        assert_eq!(
            caught(|| panic!("number {number}")),
            Err::<(), _>("number 7".into())
        );
        let odd = caught(|| panic::panic_any(number));
        assert_eq!(odd, Err::<(), _>("it did not say what".into()));
    }

    #[test]
    fn one_within_another_leaves_the_outer_caught() {
        let outer = caught(|| {
            let inner = caught(|| panic!("inner"));
            assert!(IS_CAUGHT.get());
            inner
        });
        assert_eq!(outer, Ok(Err::<(), _>("inner".to_owned())));
        assert!(!IS_CAUGHT.get());
    }
}
