//! A study: a set of cases and sweeps, with the figures and tables to make of them.

mod answers;
mod cases;
mod columns;
mod curve;
mod data;
mod figure;
mod frames;
mod looks;
mod map;
mod numbers;
mod page;
mod picture;
mod request;
mod texts;

pub use request::{Request, load, run};
