//! The books of energy through failure and removal.

use wholestring_rock::{Alone, Block, Stepper};
use wholestring_verification::verify;

use crate::drill::{self, Ball};

/// Drags a ball through a block.
fn dragged(steps: usize) -> Block {
    let (mut block, mut ball, stepper) = (drill::block(), Ball::new(), Stepper::default());
    for _ in 0..steps {
        ball.drag(&mut block, &stepper, &Alone);
    }
    block
}

#[test]
fn energy_balances_through_failure_and_removal() {
    let block = dragged(6000);
    let energies = block.energies();
    let (removed, _) = block.removed();
    assert!(removed > 50, "only {removed} elements were removed");
    verify(
        "rock",
        "energy that is unaccounted for after a ball has cut a groove as a part of its work",
    )
    .absolute(0.01, "required")
    .report(0.0, energies.residual_J() / energies.pushed_J);
}

#[test]
fn a_block_under_pressure_rests() {
    let stepper = Stepper::default();
    let mut block = drill::block();
    for _ in 0..500 {
        block.step(&stepper, &Alone);
    }
    let fastest =
        block.exposed().flat_map(|node| node.velocity_m_per_s).fold(0.0_f64, |a, v| a.max(v.abs()));
    // The initial stress over the impedance of the rock would be 1 m/s.
    assert!(fastest < 1e-10, "{fastest} m/s");
}

#[test]
fn a_block_follows_what_drills_it() {
    let stepper = Stepper::default();
    let mut block = drill::block();
    for _ in 0..100 {
        block.step(&stepper, &Alone);
    }
    let layer: Vec<_> = block.grid().each_element().filter(|element| element[2] < 2).collect();
    for element in layer {
        block.remove(element);
    }
    assert_eq!(block.spent_layers(), 2);
    for _ in 0..100 {
        block.step(&stepper, &Alone);
    }
    let last = block.grid().node([7, 5, 6]);
    let before = block.position_m(last);
    let below = block.velocity_m_per_s(block.grid().node([7, 5, 8]));
    assert_eq!(block.follow(), 2);
    let moved = block.grid().node([7, 5, 4]);
    assert_eq!(block.position_m(moved), before);
    assert_eq!(block.velocity_m_per_s(block.grid().node([7, 5, 8])), below);
    assert_eq!(block.exposed().count(), 22 * 13);
    for _ in 0..500 {
        block.step(&stepper, &Alone);
    }
    let energies = block.energies();
    let scale = energies.absorbed_J + energies.removed_J;
    assert!(energies.residual_J().abs() < 1e-3 * scale, "{energies:?}");
    // The rock is still loaded by the fluid's pressure: the only motion is that from the release of
    // the confinement.
    let fastest =
        block.exposed().flat_map(|node| node.velocity_m_per_s).fold(0.0_f64, |a, v| a.max(v.abs()));
    assert!(fastest < 0.05, "{fastest} m/s");
}
