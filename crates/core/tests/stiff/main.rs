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

/// Solves and holds the equilibrium to what every one must be.
#[track_caller]
fn solve(model: &Model, operation: &Operation, settings: &StiffSettings) -> StiffProfile {
    let found = stiff::solve(model, operation, settings).expect("an equilibrium");
    assert!(found.convergence.residual < 1e-8, "{:?}", found.convergence);
    assert!(found.convergence.stable, "{:?}", found.convergence);
    found
}

/// A plain piece of a file's pipe or collar, whose buoyed weight is given.
fn piece(of: &Value, length: ComponentLength) -> ComponentSpec {
    let of = |key: &str| number(&of[key]);
    let steel =
        Material { youngs_modulus_Pa: of("E"), shear_modulus_Pa: of("G"), ..common::steel() };
    ComponentSpec {
        mass_per_length_kg_per_m: of("w") / wholestring::GRAVITY_M_PER_S2,
        ..ComponentSpec::uniform("pipe", of("od"), of("id"), length, steel)
    }
}

/// Sliding down with a compression at the bit, N; a negative one pulls.
fn pressed(bit_depth_m: f64, compression_N: f64) -> Operation {
    Operation { weight_on_bit_N: compression_N, ..Operation::slide(bit_depth_m) }
}

/// The node nearest to a depth.
fn nearest(of: &StiffProfile, md_m: f64) -> usize {
    let off = |index: &usize| (of.md_m[*index] - md_m).abs();
    (0..of.md_m.len()).min_by(|a, b| off(a).total_cmp(&off(b))).expect("nodes")
}

/// Contact force of a node, N, positive on the high side.
fn force_N(of: &StiffProfile, index: usize) -> f64 {
    of.contact_force_N[index].copysign(of.side_force_N_per_m[index])
}
