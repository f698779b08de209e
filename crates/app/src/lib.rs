//! The local web app: a server on the loopback address, and the page that it serves.
//!
//! [`Server::bind`] opens a folder of cases and a port of the loopback addresses; [`Links`] let one
//! browser in each, and [`Server::run`] serves until a [`Stop`] ends it. This crate prints nothing.
//!
//! A request takes one path: the `guard` admits it or not, the router finds its module in `api`,
//! and that calls the `workspace`, which reads and writes nothing outside its folder. Requests that
//! need neither are answered by `wholestring-screens`.
#![warn(missing_docs)]

mod api;
mod app;
mod assets;
mod connections;
mod guard;
mod import;
mod jobs;
mod limits;
mod link_file;
mod listeners;
mod live;
mod overview;
mod places;
mod results;
mod server;
mod workspace;

pub use connections::Stop;
pub use guard::{Address, Links};
pub use server::{Options, Server, ServerError};
