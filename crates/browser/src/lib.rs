//! The engine in a browser: a module of WebAssembly that a worker of the page loads.
//!
//! It answers what the server of the local app answers, but for what needs a folder or the program:
//! [`requests`] has what is asked of a text, [`seat`] a live string. [`page`] is how the page calls
//! it: numbers, and bytes in its memory. No tool writes that part, so that nothing but the compiler
//! is needed to build it; the other half is `web/app/src/alone/engine.ts`.
#![warn(missing_docs)]

pub mod page;
pub mod requests;
pub mod seat;
