//! The requests of the app's screens, one module for each noun: plain functions, with their JSON
//! input and output.
//!
//! The server of the local app and the engine in a browser use the same functions. This crate opens
//! no socket or file, and starts no thread: a case is a name, a text and the files that it names,
//! and a live string is advanced by the owner of its engine, one turn at a time.
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
pub mod refusal;
pub mod survey;
pub mod trial;
pub mod units;
mod values;
pub mod words;
