//! The example programs run, and print their documented output.

use std::error::Error;

#[path = "../../examples/bit_law.rs"]
mod bit_law;
#[path = "../../examples/excitation.rs"]
mod excitation;
#[path = "../../examples/friction.rs"]
mod friction;
#[path = "../../examples/friction_law.rs"]
mod friction_law;
#[path = "../../examples/observer.rs"]
mod observer;
#[path = "../../examples/top_drive_controller.rs"]
mod top_drive_controller;

type Outcome = Result<(), Box<dyn Error>>;

#[test]
fn a_bit_law_of_ones_own() -> Outcome {
    bit_law::main()
}

#[test]
fn an_excitation_of_ones_own() -> Outcome {
    excitation::main()
}

#[test]
fn a_friction_of_ones_own() -> Outcome {
    friction::main()
}

#[test]
fn a_friction_law_of_ones_own() -> Outcome {
    friction_law::main()
}

#[test]
fn an_observer_of_samples() -> Outcome {
    observer::main()
}

#[test]
fn a_top_drive_controller_of_ones_own() -> Outcome {
    top_drive_controller::main()
}
