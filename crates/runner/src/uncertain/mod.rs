//! Samples of uncertain inputs, for plans and reaches.

mod quantity;
mod sampled;
mod sampler;
mod sentences;
mod summary;
mod tables;

pub(crate) use quantity::Quantity;
pub(crate) use sampled::Sampled;
pub(crate) use sampler::Sampler;
pub use sentences::scatter;
pub(crate) use summary::summary;
pub(crate) use tables::{samples_table, write, write_picture_numbers};
pub use wholestring_report::uncertain_notes as notes;
