//! Samples of uncertain inputs, for plans and reaches.

mod quantity;
mod sampled;
mod sampler;
mod sentences;
mod shown;
mod summary;
mod tables;

pub(crate) use quantity::Quantity;
pub(crate) use sampled::Sampled;
pub(crate) use sampler::Sampler;
pub use sentences::{notes, scatter};
pub(crate) use shown::shown;
pub(crate) use summary::summary;
pub(crate) use tables::{Names, samples_table, write, write_picture_numbers};
