//! The first parts that a program uses: constructors, a run to its end, laws of its own, the
//! examples.

// Every example has the well and the string that they share as a module of its own.
#![allow(clippy::duplicate_mod)]

mod bit_law;
mod builders;
mod examples;
mod excitation;
mod friction;
mod setup;
mod top_drive;
mod whole_run;
