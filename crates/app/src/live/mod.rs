//! Strings in motion: a thread for each, which takes it forward.
//!
//! What a string is and does is in `wholestring_screens::live`; [`EngineRoom`] holds all of them,
//! few at a time, and keeps in the folder what is to be continued.

pub(crate) mod kept;
mod room;
mod thread;

pub(crate) use room::EngineRoom;
