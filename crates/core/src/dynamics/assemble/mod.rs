//! From model, operation and settings to what a run is made of.

pub mod basis;
pub mod chain;
pub mod error;
pub mod foreseen;
pub mod hoisting;
pub mod numbers;
