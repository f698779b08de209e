//! The local web app: a server on the loopback address, and the page that it serves.
//!
//! [`Server::bind`] opens a folder of cases and a port of 127.0.0.1; [`Server::url`] is the address
//! with which a browser is let in, and [`Server::run`] serves until a [`Stop`] asks it to end.
//! Nothing here prints.
//!
//! A request goes one way: the `guard` decides whether it is answered at all, the router finds its
//! noun in `api`, and that asks the `workspace`, which reads and writes nothing outside its folder.
//! What needs neither is answered by `wholestring-screens`.
#![warn(missing_docs)]

mod api;
mod app;
mod assets;
mod connections;
mod fingerprint;
mod guard;
mod import;
mod jobs;
mod limits;
mod live;
mod results;
mod server;
mod stop;
mod workspace;

pub use server::{Options, Server, ServerError};
pub use stop::Stop;
