//! Verification of the dynamics as a whole: what a run of a string in its well must show.
//!
//! "Quiet" means constant speed, smooth wall, vector friction, nothing that excites: what such a
//! run settles to is known from statics.

#[path = "../common/mod.rs"]
mod common;
mod wells;

mod bending;
mod bit;
mod borehole;
mod break_away;
mod buckling;
mod centred;
mod checkpoint;
mod climb;
mod control;
mod ends;
mod energy;
mod friction;
mod hold;
mod hook_load;
mod independent;
mod live_friction;
mod mesh;
mod mud;
mod np13;
mod numerics;
mod operations;
mod precision;
mod probes;
mod rock_string;
mod rough;
mod schedule;
mod steadiness;
mod stiff_string;
