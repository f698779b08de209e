//! A study: a set of cases and sweeps, with the figures and tables to make of them.

mod cases;
mod columns;
mod curve;
mod data;
mod figure;
mod formats;
mod frames;
mod map;
mod numbers;
mod page;
mod picture;
mod request;
mod results;
mod styles;

pub use cases::case_files;
pub use request::{Request, load, parse, run};
pub use wholestring_study::Study;
