//! Every instruction set moves the string alike.

mod body;
mod contact_map;
mod handed_over;
mod imbalance;
mod in_hand;
mod initialise;
mod regions;
mod top;

use super::*;
use crate::{
    common::{self, article_hole, mud_with_drag, np13::tool, operation, path_in_rad},
    dynamics::{
        boundary::executor::RockExecutor,
        kernel::step::Laws,
        settings::{FrictionLaw, mesh::MeshSettings},
    },
    operation::OperationKind,
    string::ComponentLength,
    wall::contact::ContactLaw,
    well::{Friction, Interpolation},
};

const DEPTH_M: f64 = 300.0;

/// Nothing at the bit.
const REAM: Operation =
    operation(OperationKind::Ream, DEPTH_M).rotary_speed_rad_per_s(7.0).trip_speed_m_per_s(0.2);

/// Pipe in a hole that builds to 50 deg and turns.
fn model(at_rest: f64) -> Model {
    let stations =
        [0.0, 0.5, 1.0].map(|part: f64| [DEPTH_M * part, (50.0 * part).to_radians(), 0.4 * part]);
    let friction = Friction { kinetic: 0.25, at_rest, around: 1.0 };
    common::model(
        path_in_rad(&stations, Interpolation::Spline),
        article_hole(0.2159, friction, DEPTH_M + 10.0),
        vec![tool("pipe", ComponentLength::ToSurface, 0.1397, 0.1186)],
        mud_with_drag(),
        DEPTH_M,
    )
}

/// A run from its start, in double precision.
fn new_run(model: &Model, operation: &Operation, settings: &DynamicsSettings) -> Run<f64> {
    Run::new(model, operation, settings, RockExecutor::default()).expect("a valid case")
}

/// Whatever the processor, the string moves the same to the last bit of all that it is.
#[test]
fn every_instruction_set_moves_the_string_alike() {
    for (hertz, friction_law, at_rest) in [
        (true, FrictionLaw::Vector, 0.25),
        (true, FrictionLaw::Independent, 0.3),
        (false, FrictionLaw::Vector, 0.3),
        (false, FrictionLaw::Independent, 0.25),
    ] {
        let model = model(at_rest);
        let mut settings =
            DynamicsSettings { settle_s: 3.0, duration_s: 2.0, friction_law, ..Default::default() };
        if !hertz {
            settings.contact_law =
                ContactLaw::Linear { stiffness_N_per_m: 1e8, damping_ratio: 0.05 };
        }
        let initial = new_run(&model, &REAM, &settings);
        let vector = friction_law == FrictionLaw::Vector;
        let outcomes: Vec<_> =
            Stepper::all(Abilities { laws: Laws { hertz, vector }, full: at_rest > 0.25 })
                .into_iter()
                .map(|stepper| {
                    let instructions = stepper.instructions;
                    let mut simulation = Run { stepper, ..initial.clone() };
                    simulation.advance(5.0).unwrap();
                    let state = postcard::to_allocvec(&simulation.chain).expect("plain data");
                    (instructions, simulation.outcome(), state)
                })
                .collect();
        let (_, first, whole_state) = &outcomes[0];
        assert_eq!(first.numerics.instructions, initial.stepper.instructions);
        for (name, outcome, state) in &outcomes[1..] {
            assert!(state == whole_state, "{name}");
            assert_eq!(outcome.scalars.hook_load_N, first.scalars.hook_load_N, "{name}");
            let torque = outcome.scalars.friction_torque_N_m;
            assert_eq!(torque, first.scalars.friction_torque_N_m, "{name}");
        }
    }
}

/// The same in single precision, which has twice as many lanes, where products are rounded alike.
#[test]
fn every_width_moves_singles_alike() {
    let settings = DynamicsSettings { settle_s: 1.0, duration_s: 1.0, ..Default::default() };
    let executor = RockExecutor::default();
    let initial: Run<f32> =
        Run::new(&model(0.3), &REAM, &settings, executor).expect("a valid case");
    let moved = |stepper: Stepper<f32>| {
        let name = stepper.instructions;
        let mut run = Run { stepper, ..initial.clone() };
        run.advance(2.0).expect("no divergence");
        (name, run.is_fused(), postcard::to_allocvec(&run.chain).expect("plain data"))
    };
    let moved: Vec<_> = Stepper::all(initial.abilities).into_iter().map(moved).collect();
    let (_, is_fused, first) = &moved[0];
    for (name, fuses, state) in &moved {
        assert!(fuses != is_fused || state == first, "{name}");
    }
}

/// A row that does not reach the wall leaves contact and friction out. Which nodes share a row is a
/// matter of the pieces' length, and it makes no difference to any of them: with pieces of other
/// lengths all bits are the same, those of the sums too.
#[test]
fn no_node_knows_who_shares_its_row() {
    let mut run = new_run(&model(0.3), &REAM, &DynamicsSettings::default());
    run.advance(1.0).unwrap();
    let (input, rows) = (run.step_input(), run.chain.node_blocks.len());
    let mut stepper = run.stepper.clone();
    let mut stepped = |mut chain: Chain| {
        for _ in 0..2000 {
            stepper.step(&mut chain, &input);
        }
        chain
    };
    let whole = stepped(run.chain.clone());
    for longer in [1, 2, 5] {
        let other = stepped(run.chain.in_rows(rows + longer));
        for i in 0..whole.nodes() {
            let bits = |chain: &Chain| {
                let (u, v) = (chain.displacement(i), chain.velocity(i));
                [
                    u.0,
                    u.1,
                    u.2,
                    v.0,
                    v.1,
                    v.2,
                    node!(chain, i, spin),
                    node!(chain, i, sum_normal),
                    node!(chain, i, sum_wear),
                ]
                .map(f64::to_bits)
            };
            assert_eq!(bits(&whole), bits(&other), "node {i}, {longer} rows more");
        }
    }
    let touched = (0..whole.nodes()).filter(|i| node!(whole, *i, sum_normal) > 0.0);
    let part = touched.count() as f64 / whole.nodes() as f64;
    assert!(part > 0.2 && part < 1.0, "{part} of the nodes touched");
}

/// The friction work of the nodes equals that on the hole, to rounding, with either law.
#[test]
fn wear_is_laid_on_the_hole() {
    for friction_law in [FrictionLaw::Vector, FrictionLaw::Independent] {
        let settings = DynamicsSettings { friction_law, ..Default::default() };
        let mut run = new_run(&model(0.3), &REAM, &settings);
        let input = run.step_input();
        run.chain.clear_sums();
        for _ in 0..2000 {
            run.stepper.step(&mut run.chain, &input);
        }
        let lost = run.state.wear.sample(&run.chain, |i| run.state.anchors[i].md_m);
        let nodes: f64 = (0..run.chain.nodes()).map(|i| run.state.wear.string_J(i)).sum();
        let hole: f64 = run.state.wear.hole_J_per_m(|i| run.state.anchors[i].md_m).iter().sum();
        assert!(lost > 1000.0, "{lost}");
        assert!((nodes / lost - 1.0).abs() < 1e-12, "{nodes} {lost}");
        let hole = hole * crate::outcome::HOLE_STEP_M;
        assert!((hole / lost - 1.0).abs() < 1e-12, "{hole} {lost}");
    }
}

/// The counting step gives the same results to the last bit. It has no branch, so every step and
/// every lane takes the same number of operations.
#[test]
fn counting_leaves_the_step_as_it_is() {
    let mut totals = Vec::new();
    for at_rest in [0.25, 0.3] {
        let settings = DynamicsSettings::default();
        let mut plain = new_run(&model(at_rest), &REAM, &settings);
        let mut counted = plain.clone();
        const STEPS: usize = 300;
        plain.step_kernel(STEPS);
        let first = counted.count_kernel();
        for _ in 1..STEPS {
            assert_eq!(counted.count_kernel(), first);
        }
        assert_eq!(plain.energy_J().to_bits(), counted.energy_J().to_bits());
        let lanes = <f64 as Real>::LANES as u64;
        assert!(first.total() > 0 && first.total().is_multiple_of(lanes));
        totals.push(first.total());
    }
    // More laws, more work.
    assert!(totals[0] < totals[1], "{totals:?}");
}
