//! The engine in a browser: a module of WebAssembly that a worker of the page loads.
//!
//! It answers the requests of the local app's server, except those that need a folder or the
//! program: [`requests`] has those about a text, [`seat`] those about a live string. [`page`] is
//! the interface to the page: numbers, and bytes in its memory. No tool generates that part, so
//! that nothing but the compiler is needed to build it; the other half is
//! `web/app/src/alone/engine.ts`.
#![warn(missing_docs)]

pub mod page;
pub mod requests;
pub mod seat;
