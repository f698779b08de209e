//! Every operation in the dynamics, against the soft string.
//!
//! The dynamics and the soft string differ in ways that are predictable. A turning pipe climbs the
//! wall until friction carries it: pressed by the load `q` at the angle `ψ` from its direction,
//! `tan ψ` the part of the friction that acts around, its wall load is `q cos ψ`. So the soft
//! string is solved with `μ cos ψ`. The rest, 1 to 2 % of friction and torque and up to 0.35 % of
//! the hook load, is due to the bit, which its hole holds to the axis: it carries the collars up to
//! where they touch, `½ q (24 EI c/q)^¼` = 3.5 kN or 1 % of all side force, without friction; and
//! from the bending stiffness that bridges the place where the string changes sides.

use wholestring::{
    dynamics::{ContactLaw, DynamicOutcome, DynamicsSettings, FrictionLaw, Precision},
    operation::OperationKind::{self, *},
    outcome::Scalars,
    statics::soft,
};

use crate::{
    common::{assert_close, operation, relative_error},
    wells::{Case, each, moderate, straight},
};

const MU: f64 = 0.25;

/// Radius of the tool joints, which carry most of the side force, m.
const RADIUS_M: f64 = 0.0889;

/// Friction and torque: the part of the bit and the bridging by stiffness, see above.
const FRICTION_TOLERANCE: f64 = 0.02;

/// Hook load: 2 % of at most 106 kN of friction, of 530 kN.
const HOOK_TOLERANCE: f64 = 0.004;

fn contact_laws() -> [ContactLaw; 2] {
    [
        DynamicsSettings::default().contact_law,
        ContactLaw::Linear { stiffness_N_per_m: 2e8, damping_ratio: 0.05 },
    ]
}

/// Every operation with both contact laws.
fn run_all(law: FrictionLaw) -> Vec<(Case, DynamicOutcome)> {
    let cases: Vec<Case> = OperationKind::ALL
        .into_iter()
        .flat_map(|kind| contact_laws().map(|contact| (kind, contact)))
        .map(|(kind, contact_law)| {
            let mut case = moderate(kind, MU);
            case.settings.friction_law = law;
            case.settings.contact_law = contact_law;
            case
        })
        .collect();
    let outcomes = each(&cases, Case::run);
    cases.into_iter().zip(outcomes).collect()
}

/// The soft string of `kind` with `μ cos ψ`.
fn climbed_soft_string(case: &Case, kind: OperationKind, tan_psi: f64) -> Scalars {
    let mut model = case.model.clone();
    let mu = MU / tan_psi.hypot(1.0);
    model.well.hole = model.well.hole.with_friction(mu).expect("a coefficient");
    let mut operation = case.operation;
    operation.kind = kind;
    soft::solve(&model, &operation, &soft::SoftSettings::default()).expect("a valid case").scalars
}

#[track_caller]
fn assert_drag_agrees(case: &Case, found: &Scalars, expected: &Scalars) {
    let what = |quantity| format!("{quantity} of {}", case.operation.kind.name());
    assert_close(&what("hook load"), found.hook_load_N, expected.hook_load_N, HOOK_TOLERANCE);
    if expected.axial_friction_N == 0.0 {
        assert!(found.axial_friction_N.abs() < 1e-3 * found.hook_load_N);
    } else {
        assert_close(
            &what("axial friction"),
            found.axial_friction_N,
            expected.axial_friction_N,
            FRICTION_TOLERANCE,
        );
    }
}

/// Friction is split by the ratio of the axial to the circumferential speed: each operation has the
/// hook load, the axial friction (sign and size) and the torque of the soft string with `μ cos ψ`,
/// `tan ψ = μ Ωr/V`; whichever the contact law.
#[test]
fn vector_friction_agrees_with_the_soft_string_in_every_operation() {
    for (case, outcome) in run_all(FrictionLaw::Vector) {
        let (kind, found) = (case.operation.kind, outcome.scalars);
        let around = RADIUS_M * case.operation.rotation_rad_per_s();
        let speed = around.hypot(case.operation.axial_velocity_m_per_s());
        let expected = climbed_soft_string(&case, kind, MU * around / speed);
        assert_drag_agrees(&case, &found, &expected);
        if kind.rotates() {
            assert_close(
                &format!("friction torque of {}", kind.name()),
                found.friction_torque_N_m,
                expected.friction_torque_N_m,
                FRICTION_TOLERANCE,
            );
        } else {
            // Axial sliding takes all friction: none is left around.
            let most = 0.005 * MU * RADIUS_M * found.side_force_total_N;
            assert!(found.friction_torque_N_m.abs() < most, "{}: {found:?}", kind.name());
        }
        if kind.on_bottom() {
            let (bit, target) = (found.weight_on_bit_N, case.operation.weight_on_bit_N);
            assert!(relative_error(bit, target) < 0.03, "{}: {bit} N", kind.name());
        }
    }
}

/// The article's independent law drags in full along the hole however fast the string turns:
/// drilling as sliding, reaming as tripping, with `tan ψ = μ` where it turns. Off bottom without
/// axial motion, its axial friction is at rest, and carries nothing that the start has not given
/// it.
#[test]
fn independent_friction_drags_as_a_sliding_string() {
    for (case, outcome) in run_all(FrictionLaw::Independent) {
        let kind = case.operation.kind;
        let sliding = match kind {
            Drill => Slide,
            Ream => TripIn,
            BackReam => TripOut,
            same => same,
        };
        let tan_psi = if kind.rotates() { MU } else { 0.0 };
        let expected = climbed_soft_string(&case, sliding, tan_psi);
        assert_drag_agrees(&case, &outcome.scalars, &expected);
        if kind.rotates() {
            let (found, side) = (outcome.scalars, outcome.scalars.side_force_total_N);
            let torque = found.friction_torque_N_m;
            // All contacts rub around in full; those of the collars with a smaller radius.
            let most = MU * RADIUS_M * side;
            assert!(torque < most && torque > 0.98 * most, "{torque} for {most} N·m");
        }
    }
}

/// Twist and stretch of the nodes are summed from the bit up, sample by sample: at the bit they are
/// nothing, at the top the scalars but for the rounding of the means (1e-9 of sums of some hundred
/// samples). Friction works at its mean rate. In both kinds of number, and where the string moves
/// so far that the hole is found anew.
#[test]
fn twist_and_stretch_of_the_nodes_end_in_the_scalars() {
    let kinds = [TripOut, TripIn, RotateOffBottom, Drill, Slide, Ream, BackReam];
    let case = |kind: OperationKind, precision: Precision| {
        let operation = operation(kind, 300.0)
            .trip_speed_m_per_s(5.0)
            .weight_on_bit_N(10e3)
            .bit_torque_N_m(500.0)
            .rate_of_penetration_m_per_s(0.01);
        let mut case = Case::new(straight(300.0, 0.25), operation);
        case.settings.precision = precision;
        case.lasts(0.3, 0.4);
        case
    };
    // Single precision is refused where the string does not turn.
    let single = kinds.iter().filter(|kind| kind.rotates());
    let single = single.map(|kind| case(*kind, Precision::Single));
    let cases = kinds.iter().map(|kind| case(*kind, Precision::Double));
    for case in cases.chain(single) {
        let outcome = case.run();
        let (nodes, scalars) = (&outcome.nodes, &outcome.scalars);
        let name = format!("{:?} {:?}", case.operation.kind, case.settings.precision);
        let last = nodes.md_m.len() - 1;
        assert_eq!([nodes.twist_rad[last], nodes.stretch_m[last]], [0.0; 2]);
        let close = |what: &str, found: f64, expected: f64, scale: f64| {
            let error = (found - expected).abs();
            assert!(error <= 1e-9 * scale, "{name}: {what} {found} for {expected}");
        };
        let size =
            |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        close("twist", nodes.twist_rad[0], scalars.twist_rad, size(&nodes.twist_rad));
        close("stretch", nodes.stretch_m[0], scalars.stretch_m, size(&nodes.stretch_m));
        assert!(size(&nodes.stretch_m) > 1e-4, "{name}");
        assert!(size(&nodes.wear_work_J_per_m) > 0.0, "{name}");
        let times_s = &outcome.series.time_s;
        let first = times_s.partition_point(|time| *time < case.settings.settle_s);
        let window_s = times_s[times_s.len() - 1] - times_s[first - 1];
        for (work, power) in nodes.wear_work_J_per_m.iter().zip(&nodes.wear_power_W_per_m) {
            close("power", window_s * power, *work, size(&nodes.wear_work_J_per_m));
        }
    }
}
