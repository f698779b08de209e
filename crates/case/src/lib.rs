//! Case files, and the surveys that they name.

pub mod survey;
