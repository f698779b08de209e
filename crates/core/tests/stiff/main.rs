//! The stiff string against closed forms, collocated solutions and the other methods.

#[path = "../common/mod.rs"]
mod common;

mod assemblies;
mod buckled;
mod circulation;
mod compression;
mod criteria;

mod ends;
mod forced_straight;
mod friction;
mod inside_of_bends;
mod joints;
mod mesh;
mod motor;
mod motor_in_turn;
mod transition;
mod vertical;
mod wall;

use serde_json::Value;
use wholestring::{
    prelude::*,
    statics::stiff::{self, StiffProfile, StiffSettings},
    string::{ComponentLength, ComponentSpec, Material},
};

use common::{number, rigid::rigid as settings};

/// Solves, and checks that the equilibrium has a small residual and is stable.
#[track_caller]
fn solve(model: &Model, operation: &Operation, settings: &StiffSettings) -> StiffProfile {
    let found = stiff::solve(model, operation, settings).expect("an equilibrium");
    assert!(found.convergence.residual < 1e-8, "{:?}", found.convergence);
    assert!(found.convergence.stable, "{:?}", found.convergence);
    found
}

/// A plain piece of a file's pipe or collar with the buoyed weight of the file.
fn piece(section: &Value, length: ComponentLength) -> ComponentSpec {
    let value = |key: &str| number(&section[key]);
    let steel =
        Material { youngs_modulus_Pa: value("E"), shear_modulus_Pa: value("G"), ..common::steel() };
    ComponentSpec {
        mass_per_length_kg_per_m: value("w") / wholestring::GRAVITY_M_PER_S2,
        ..ComponentSpec::uniform("pipe", value("od"), value("id"), length, steel)
    }
}

/// Sliding down with a compression at the bit, N; a negative one pulls.
fn pressed(bit_depth_m: f64, compression_N: f64) -> Operation {
    Operation { weight_on_bit_N: compression_N, ..Operation::slide(bit_depth_m) }
}

/// The node nearest to a depth.
fn nearest(profile: &StiffProfile, md_m: f64) -> usize {
    let off = |index: &usize| (profile.md_m[*index] - md_m).abs();
    (0..profile.md_m.len()).min_by(|a, b| off(a).total_cmp(&off(b))).expect("nodes")
}

/// Contact force of a node, N, positive on the high side.
fn force_N(profile: &StiffProfile, index: usize) -> f64 {
    profile.contact_force_N[index].copysign(profile.side_force_N_per_m[index])
}
