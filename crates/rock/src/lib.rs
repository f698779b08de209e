//! Solid rock: a block of elements that yield, soften, fail and go.
//!
//! A [`Rock`] is elastic up to Drucker and Prager's cone and brittle beyond it. A [`Block`] of it
//! is a grid of eight-node hexahedral elements with one point of integration each and is integrated
//! explicitly; a touching body gets the nodes of its surface from [`Block::exposed`] and pushes
//! them by [`Block::push`] between two steps; a bit's face does so by [`Block::press`]. Elements
//! that have failed are removed, and energy is accounted for throughout ([`Energies`]). A block
//! [follows](Block::follow) the bit that drills it.
//!
//! The touching body is the bit's [face](bit_face). [`Drilling`] combines the two; a [`Trial`]
//! measures the drilling of a bit under one weight at one speed.
//!
//! z points down the hole, x and y across it. Stresses are positive in tension.

#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod bit_face;

mod block;
mod constants;
mod drilling;
mod edges;
mod element;
mod energy;
mod erosion;
mod executor;
mod follow;
mod grid;
mod kernel;
mod material;
mod named_numbers;
mod plasticity;
mod press;
mod stored;
mod surface;
#[cfg(feature = "rayon")]
mod threads;
mod trial;

pub use block::{Block, BlockSpec, SurfaceNode};
pub use constants::Numerics;
pub use drilling::{
    Advance, Bit, BitMotion, BitShape, Drilling, DrillingEnergies, DrillingError, DrillingSpec,
    Driver, Inertia, Progress,
};
pub use edges::Edge;
pub use energy::Energies;
pub use executor::{Alone, Executor};
pub use grid::Grid;
pub use kernel::Stepper;
pub use material::{Cone, Rock, RockError, RockNumber};
pub use press::Pressed;
pub use trial::{DrillingResponse, Trial, TrialError, TrialOutcome, TrialSpec};
