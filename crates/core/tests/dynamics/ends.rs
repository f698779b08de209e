//! Constraints of the ends, pulls at the bit, pushes at the top and lateral forces, for strings
//! brought to rest, against the stiff string.

use wholestring::{
    dynamics::{HoistControl, RodDamping, Start},
    ends::{BitEnd, Ends, TopEnd},
    operation::OperationKind,
    prelude::*,
    rig::Rig,
    sizing::ElementLength,
    statics::stiff::{self, StiffProfile, StiffSettings},
};

use crate::{
    common::{
        self, assert_close,
        beam::{self, LENGTH_M, WEIGHT_N_PER_M, beam},
        operation, pressing, verify,
    },
    wells::{Case, each, moderate, straight},
};

/// Elements, m.
const ELEMENT_M: f64 = 0.5;

fn at_rest(case: &Case) -> StiffProfile {
    let settings = StiffSettings {
        element_length: case.settings.mesh.element_length,
        contact_law: case.settings.contact_law,
        bit_lateral_stiffness_N_per_m: case.settings.bit.lateral_stiffness_N_per_m,
        lumped_weight: true,
        ..StiffSettings::default()
    };
    stiff::solve(&case.model, &case.operation, &settings).expect("an equilibrium")
}

/// Forces of hole and rock on the bit at the end of a run, N, towards the high side and to the
/// right.
fn bit_forces_N(moving: &DynamicOutcome) -> [f64; 2] {
    let last = |samples: &[f64]| *samples.last().expect("a sample");
    let series = &moving.series;
    [last(&series.bit_force_high_N), last(&series.bit_force_right_N)]
}

/// A beam, damped to rest: at 4/s nothing is left of its first swing, of some Hz, after 8 s.
fn beam_at_rest(model: Model, operation: Operation) -> Case {
    let mut case = Case::new(model, operation);
    case.settings.mesh.element_length = ElementLength::Uniform(ELEMENT_M);
    case.settings.damping = RodDamping { mass_per_s: 8.0, stiffness_s: 1e-5 };
    case.settings.hoist_control = Some(HoistControl::BlockVelocity(0.0));
    // Laid on its wall it would be bent beyond its strength.
    case.settings.start = Start::Centred;
    case.lasts(8.0, 1.0);
    case
}

/// Beams whose ends are held in every way, with a lateral force to the right, while they turn or
/// not: the force is fixed in space. Deflections, side forces of the bit and moments are those of
/// the stiff string within 1e-4 of the largest: found 1e-13, for the elements are the same.
#[test]
fn beams_with_ends_of_every_kind() {
    let mut cases = Vec::new();
    for beam_case in &beam::CASES {
        for kind in [OperationKind::TripOut, OperationKind::RotateOffBottom] {
            let model = beam(beam_case.ends, Some([4.0, 900.0, 1.2]));
            cases.push((beam_case.name, beam_at_rest(model, operation(kind, LENGTH_M))));
        }
    }
    each(&cases, |(name, case)| {
        let (stiff, moving) = (at_rest(case), case.run());
        let nodes = moving.nodes.md_m.len();
        let apart = |profile: fn(&wholestring::outcome::Profile) -> &Vec<f64>| {
            let (a, b) = (profile(&stiff), profile(&moving.nodes));
            let largest = b.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            (0..nodes).fold(0.0_f64, |worst, i| worst.max((a[i] - b[i]).abs() / largest))
        };
        let offsets = apart(|profile| &profile.lateral_offset_m);
        let moments = apart(|profile| &profile.bending_moment_N_m);
        let weight_N = WEIGHT_N_PER_M * LENGTH_M;
        let [high, right] = bit_forces_N(&moving);
        let side = [high + stiff.bit_side_force_N[0], right + stiff.bit_side_force_N[1]];
        let sides = side.map(|side| side.abs() / weight_N);
        println!("{name}: offsets {offsets:.1e}, moments {moments:.1e}, sides {sides:?}");
        assert!(offsets < 1e-4 && moments < 1e-4, "{name}");
        assert!(sides.iter().all(|side| *side < 1e-4), "{name}");
    });
}

/// The bit's share of a lateral force on a propped beam, `b² (3L − b)/(2 L³)`: thin beams, as of
/// the stiff string.
#[test]
fn a_lateral_force_presses_the_bit() {
    const FORCE_N: f64 = 2000.0;
    let ends = Ends { top: TopEnd::Clamped, bit: BitEnd::Pinned };
    let b = (LENGTH_M - 4.0) / LENGTH_M;
    let model = beam(ends, Some([4.0, FORCE_N, std::f64::consts::FRAC_PI_2]));
    let case = beam_at_rest(model, operation(OperationKind::TripOut, LENGTH_M));
    let found_N = -bit_forces_N(&case.run())[1];
    verify("ends", "the bit's share of a lateral force to the right in the dynamics")
        .absolute(1e-3, "thin beams; shear and slopes")
        .report(0.5 * b * b * (3.0 - b), found_N / FORCE_N);
}

/// A string that is pulled out with 150 kN on its bit, and one that hangs stuck in a vertical hole.
/// Hook loads within 0.05 % of the stiff string, as without a pull.
#[test]
fn a_pull_on_the_bit_comes_up() {
    let mut case = moderate(OperationKind::TripOut, 0.3);
    case.operation.bit_pull_N = 150e3;
    let (stiff, moving) = (at_rest(&case), case.run());
    let soft = case.soft();
    let found_N = moving.scalars.hook_load_N;
    println!("{found_N} {} {}", stiff.scalars.hook_load_N, soft.scalars.hook_load_N);
    assert_close("stiff", stiff.scalars.hook_load_N, found_N, 5e-4);
    assert_close("soft", soft.scalars.hook_load_N, found_N, 1e-2);
    assert_eq!(moving.nodes.tension_N.last(), Some(&150e3));
    assert_eq!(moving.scalars.weight_on_bit_N, 0.0);
    let balance = moving.numerics.energy.expect("a balance");
    println!("bit work {} J", balance.bit_work_J);
    // The bit is drawn up 0.3 m/s against the pull.
    assert_close("work", balance.bit_work_J, -150e3 * 0.3 * 10.0, 1e-2);
}

/// The free point: a stuck string in a vertical hole is `F L/EA` longer, 1e-5 of it left of its
/// start.
#[test]
fn a_stuck_string_stretches_by_its_free_length() {
    const DEPTH_M: f64 = 600.0;
    const PULL_N: f64 = 150e3;
    let cases = [0.0, PULL_N].map(|pull_N| {
        let model = common::straight_model(0.0, DEPTH_M, 250.0, 0.0635, 0.0);
        let operation = operation(OperationKind::TripOut, DEPTH_M).bit_pull_N(pull_N);
        let mut case = Case::new(model, operation);
        case.settings.damping.mass_per_s = 2.0;
        case.settings.hoist_control = Some(HoistControl::BlockVelocity(0.0));
        case
    });
    let steel_N = cases[0].model.string.components()[0].axial_stiffness_N();
    let found = each(&cases, |case| case.run().scalars);
    verify("ends", "stretch of the dynamics under a pull on the bit, m")
        .relative(1e-4, "remainder of the start")
        .report(PULL_N * DEPTH_M / steel_N, found[1].stretch_m - found[0].stretch_m);
    assert_close("hook load", found[1].hook_load_N - found[0].hook_load_N, PULL_N, 1e-4);
}

/// A rig that snubs brings the weight to the bit of a level hole, with the force of the stiff
/// string; one that only carries does not, and its hook is slack.
#[test]
fn a_level_hole_asks_for_a_push() {
    const LENGTH_M: f64 = 300.0;
    const WOB_N: f64 = 20e3;
    let case = |snubbing_force_N| {
        let mut model = straight(LENGTH_M, 0.25);
        model.well.path = common::arcs(&[[0.0, 90.0, 0.0], [LENGTH_M, 90.0, 0.0]]);
        model.rig = Rig { snubbing_force_N, ..Rig::default() };
        let slide = pressing(OperationKind::Slide, LENGTH_M, WOB_N)
            .rate_of_penetration_m_per_s(0.01)
            .bit_torque_N_m(0.0);
        let mut case = Case::new(model, slide);
        case.settings.mesh.element_length = ElementLength::Uniform(3.0);
        case
    };
    let cases = [Some(100e3), Some(10e3), None].map(case);
    let found = each(&cases, |case| case.run().scalars);
    let stiff = at_rest(&cases[0]).scalars;
    let soft = cases[0].soft().scalars;
    for scalars in &found {
        println!("{} {}", scalars.hook_load_N, scalars.weight_on_bit_N);
    }
    println!("stiff {} soft {}", stiff.hook_load_N, soft.hook_load_N);
    assert_close("weight on bit", found[0].weight_on_bit_N, WOB_N, 1e-3);
    assert_close("push", found[0].hook_load_N, stiff.hook_load_N, 2e-3);
    assert_close("soft", found[0].hook_load_N, soft.hook_load_N, 5e-2);
    // At its limit it gives just that, and no rig that carries gives more than nothing.
    assert_close("limit", found[1].hook_load_N, -10e3, 1e-9);
    assert!(found[1].weight_on_bit_N < 0.2 * WOB_N, "{}", found[1].weight_on_bit_N);
    assert_eq!(found[2].hook_load_N, 0.0);
}
