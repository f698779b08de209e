//! Live strings: one thread for each, which advances it.
//!
//! The strings themselves are in `wholestring_screens::live`; [`EngineRoom`] owns all of them, a
//! few at a time, and saves those to be continued in the folder.

pub(crate) mod kept;
mod room;
mod thread;

pub(crate) use room::EngineRoom;
