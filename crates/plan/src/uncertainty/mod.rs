//! Effect of uncertain inputs on results: samples of the inputs, bands of the results, and the
//! contributions of the inputs to the bands.
//!
//! Inputs are independent, each with a [`Distribution`]. [`latin_hypercube`] draws points; the
//! caller solves them and passes the results to [`Bands`] and to [`attribute`], which fits
//! polynomials to them and computes Sobol's indices from these: a few hundred points suffice where
//! the result is smooth. [`sampled_indices`] estimates the indices from samples alone, for results
//! that are cheap to compute. Theory: `docs/src/theory/uncertainty.md`.

mod bands;
mod chaos;
mod distribution;
mod latin;
mod normal;
mod polynomials;

pub use bands::Bands;
pub use chaos::{Attribution, Indices, attribute, sampled_indices};
pub use distribution::{Distribution, DistributionError};
pub use latin::latin_hypercube;
