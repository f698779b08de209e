//! What the screens of the app ask, noun by noun: plain functions and the JSON that goes in and out.
//!
//! The server of the local app and the engine in a browser answer with the same functions. Nothing
//! here opens a socket or a file, or starts a thread: a case is a name, a text and the files that it
//! names, and a live string is taken forward by who holds its engine, a turn at a time.
#![warn(missing_docs)]

pub mod answers;
pub mod cases;
pub mod catalogue;
pub mod check;
pub mod diagnostic;
pub mod edit;
pub mod examples;
pub mod layout;
pub mod live;
mod quantities;
pub mod refusal;
pub mod survey;
pub mod trial;
pub mod units;
mod values;
