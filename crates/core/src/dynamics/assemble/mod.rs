//! Builds the parts of a run from model, operation and settings.

pub mod basis;
pub mod chain;
pub mod error;
pub mod foreseen;
pub mod hoisting;
pub mod numbers;
