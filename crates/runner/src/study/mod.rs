//! A study: a set of cases and sweeps, with the figures and tables to make of them.

mod cases;
mod columns;
mod figure;
mod frames;
mod numbers;
mod page;
mod request;
mod results;

pub use cases::case_files;
pub use request::{Request, load, parse, run};
pub use wholestring_study::Study;
