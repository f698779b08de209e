//! The solid rock against closed forms.

mod bending;
mod break_away;
mod drill;
mod drilling;
mod element;
mod energy;
mod fracture;
mod hertz;
mod setup;
mod slabs;
mod specific_energy;
mod strength;
mod trial;
mod waves;
