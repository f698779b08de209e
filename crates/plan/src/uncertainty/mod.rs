//! What answers owe to inputs that are not known exactly: samples of these, bands of the answers, and
//! the inputs that the bands are owed to.
//!
//! Inputs are independent, each with a [`Distribution`]. [`latin_hypercube`] draws points; whoever has
//! solved them gives the answers to [`Bands`] and to [`attribute`], which fits polynomials to them and
//! reads Sobol's indices from these: a few hundred points suffice where the answer is smooth.
//! [`sampled_indices`] estimates the indices by samples alone, for answers that cost nothing. Theory:
//! `docs/src/theory/uncertainty.md`.

mod bands;
mod chaos;
mod distribution;
mod indices;
mod latin;
mod normal;
mod polynomials;

pub use bands::Bands;
pub use chaos::{Attribution, attribute};
pub use distribution::{Distribution, DistributionError};
pub use indices::{Indices, sampled_indices};
pub use latin::latin_hypercube;
