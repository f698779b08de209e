//! Ctrl-C: the first asks to stop, the second stops at once.

use std::{
    process,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

/// Whether the user asked to stop.
#[derive(Debug, Clone)]
pub(crate) struct Interrupt {
    asked: Arc<AtomicBool>,
}

impl Interrupt {
    /// Listens for Ctrl-C from now on. Where the system allows no listening, Ctrl-C ends the program
    /// as it does any other.
    pub(crate) fn listen() -> Self {
        let asked = Arc::new(AtomicBool::new(false));
        let told = Arc::clone(&asked);
        let _ = ctrlc::set_handler(move || {
            if told.swap(true, Ordering::Relaxed) {
                process::exit(130);
            }
        });
        Self { asked }
    }

    /// A user who asked before anything began.
    #[cfg(test)]
    pub(crate) fn already_asked() -> Self {
        Self {
            asked: Arc::new(AtomicBool::new(true)),
        }
    }

    /// A user who never asks.
    #[cfg(test)]
    pub(crate) fn never() -> Self {
        Self {
            asked: Arc::default(),
        }
    }

    /// Whether the user asked to stop.
    pub(crate) fn asked(&self) -> bool {
        self.asked.load(Ordering::Relaxed)
    }
}
