//! Verification of the dynamics as a whole: the required results of a run of a string in its well.
//!
//! "Quiet" means constant speed, smooth wall, vector friction, no excitation: the state to which
//! such a run settles is known from statics.

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
