//! Findings in results of the dynamics.

use wholestring::{
    dynamics::{
        DeepestContact, HoistControl, SpeedController, Statistic, StickSlip, TableUse,
        TopDriveSettings, Whirl,
    },
    operation::OperationKind::*,
    prelude::*,
    rod::buckled_element::BuckledElement,
    sizing::SizeReason,
};

use wholestring_judge::{Check, CheckKind, Judge, Severity};

use crate::{common::pipe, judged::*};

/// A short run whose numbers are then set to values that are to be judged.
struct Ran {
    model: Model,
    operation: Operation,
    settings: DynamicsSettings,
    outcome: DynamicOutcome,
}

impl Ran {
    fn new(kind: OperationKind) -> Self {
        let model = five_inch(&[[0.0, 60.0, 0.0], [100.0, 60.0, 0.0]], 0.2159, 0.3, 260.0);
        let operation = at_full_depth(kind, &model, 2e3).rate_of_penetration_m_per_s(1e-3);
        let settings =
            DynamicsSettings { settle_s: 5.0, duration_s: 0.2, ..DynamicsSettings::default() };
        let mut simulation =
            wholestring::dynamics::Simulation::new(&model, &operation, &settings).unwrap();
        simulation.advance(5.2).unwrap();
        let outcome = simulation.outcome();
        Self { model, operation, settings, outcome }
    }

    fn found(&self) -> Vec<Check> {
        let Self { model, operation, settings, outcome } = self;
        let solution = outcome.into();
        open(Judge::default().dynamic(model, operation, settings, &solution).checks)
    }

    fn has(&self, kind: CheckKind) -> Option<Check> {
        only(&self.found(), kind)
    }

    fn severity(&self, kind: CheckKind) -> Option<Severity> {
        self.has(kind).map(|ha| ha.severity)
    }

    fn statistic(&mut self, name: &str) -> &mut Statistic {
        let mut all = self.outcome.statistics.iter_mut();
        &mut all.find(|(quantity, _)| *quantity == name).expect("a quantity").1
    }

    /// Sets a quantity to this mean and variation.
    fn set(&mut self, name: &str, mean: f64, by: f64) {
        *self.statistic(name) = Statistic {
            mean,
            std: by,
            min: mean - by,
            max: mean + by,
            p05: mean - by,
            p95: mean + by,
            std_error: 0.01 * by,
            drift: 0.0,
            drifts: false,
        };
    }
}

#[test]
fn a_quiet_run_has_nothing_to_tell() {
    for kind in OperationKind::ALL {
        assert_eq!(Ran::new(kind).found(), [], "{kind:?}");
    }
}

#[test]
fn a_slack_hook() {
    let mut ran = Ran::new(TripOut);
    ran.set("hook_load_N", 10e3, 9e3);
    assert_eq!(ran.severity(CheckKind::GoesDown), None);
    ran.set("hook_load_N", 10e3, 10e3);
    assert_eq!(ran.severity(CheckKind::GoesDown), Some(Severity::Warning));
    ran.set("hook_load_N", 0.0, 0.0);
    assert_eq!(ran.severity(CheckKind::GoesDown), Some(Severity::Error));
}

#[test]
fn a_string_that_stands_has_locked_up() {
    let mut ran = Ran::new(Slide);
    ran.set("hook_load_N", 0.0, 0.0);
    ran.set("weight_on_bit_N", 1.5e3, 0.0);
    let has = ran.has(CheckKind::LockUp).expect("a finding");
    // Friction is part of both sides.
    assert!((has.value.unwrap() - has.limit.unwrap() - 0.5e3).abs() < 1e-6, "{has:?}");
    ran.set("weight_on_bit_N", 1.9e3, 0.0);
    assert_eq!(ran.has(CheckKind::LockUp), None);
    let mut ran = Ran::new(TripIn);
    ran.set("hook_load_N", 0.0, 0.0);
    assert_eq!(ran.has(CheckKind::LockUp), None, "it follows the block");
    ran.outcome.series.bit_depth_m.fill(100.0);
    assert!(ran.has(CheckKind::LockUp).is_some());
}

#[test]
fn weight_on_bit_against_its_target() {
    use CheckKind::*;
    let mut ran = Ran::new(Drill);
    for (part, below, above) in [
        (0.96, None, None),
        (0.94, Some(Severity::Warning), None),
        (0.79, Some(Severity::Error), None),
        (1.04, None, None),
        (1.06, None, Some(Severity::Warning)),
        (1.21, None, Some(Severity::Error)),
    ] {
        ran.set("weight_on_bit_N", part * 2e3, 0.0);
        assert_eq!(ran.severity(WeightOnBitNotReached), below, "{part}");
        assert_eq!(ran.severity(WeightOnBitExceeded), above, "{part}");
    }
    // A given lift holds nothing: it is requested by the user.
    ran.outcome.series.weight_on_bit_set_N.fill(None);
    assert_eq!(ran.severity(WeightOnBitExceeded), None);
    ran.settings.hoist_control = Some(HoistControl::HookLoad(1e3));
    assert_eq!(ran.severity(WeightOnBitExceeded), Some(Severity::Warning));

    ran.set("weight_on_bit_N", 2e3, 0.49e3);
    assert_eq!(ran.severity(WeightOnBitUnsteady), None);
    ran.set("weight_on_bit_N", 2e3, 0.51e3);
    assert_eq!(ran.severity(WeightOnBitUnsteady), Some(Severity::Warning));

    assert_eq!(ran.severity(BitBounce), None);
    let weights = &mut ran.outcome.series.weight_on_bit_N;
    let last = weights.len() - 1;
    weights[last] = 0.0;
    let has = ran.has(BitBounce).expect("a finding");
    // One sample of the twenty or so of the window.
    assert!((has.value.unwrap() - 0.05).abs() < 0.005, "{has:?}");
}

#[test]
fn compression_of_nodes_buckles_too() {
    let mut ran = Ran::new(Slide);
    // Dawson and Paslay's load of the straight slant.
    let place = wholestring::statics::buckling::Place::of(&ran.model, 100.0, 50.0);
    let load = |part: f64| {
        -part * place.critical_loads_N(wholestring::statics::buckling::Shape::Sinusoidal)[0]
    };
    ran.outcome.nodes.tension_N.fill(load(0.99));
    assert_eq!(ran.has(CheckKind::SinusoidalBuckling), None);
    ran.outcome.nodes.tension_N.fill(load(1.01));
    let has = ran.has(CheckKind::SinusoidalBuckling).expect("a stretch");
    assert!(has.to_md_m.unwrap() - has.md_m.unwrap() > 99.0, "{has:?}");
    assert_eq!(ran.has(CheckKind::HelicalBuckling), None);
    ran.outcome.nodes.tension_N.fill(load(1.42));
    assert!(ran.has(CheckKind::HelicalBuckling).is_some());
}

#[test]
fn stress_near_and_beyond_yield() {
    const YIELD_PA: f64 = 1e9;
    let mut ran = Ran::new(RotateOffBottom);
    let mut graded = pipe(260.0, 0.0635, ComponentLength::ToSurface);
    graded.yield_strength_Pa = Some(YIELD_PA);
    let string = StringSpec { components: vec![graded] }.assemble(100.0);
    ran.model.string = string.expect("a string");
    let place = ran.outcome.nodes.md_m.len() / 2;
    for (part, level) in [
        (0.79, None),
        (0.81, Some(Severity::Warning)),
        (1.0, Some(Severity::Warning)),
        (1.01, Some(Severity::Error)),
    ] {
        ran.outcome.nodes.von_mises_stress_max_Pa[place] = part * YIELD_PA;
        assert_eq!(ran.severity(CheckKind::VonMises), level, "{part}");
    }
    let has = ran.has(CheckKind::VonMises).expect("a finding");
    assert_eq!(has.md_m, Some(ran.outcome.nodes.md_m[place]));
    assert_eq!((has.value, has.limit), (Some(1.01 * YIELD_PA), Some(YIELD_PA)));
}

fn driven(torque_limit_N_m: Option<f64>) -> TopDriveSettings {
    TopDriveSettings::Driven {
        inertia_kg_m2: 1000.0,
        controller: SpeedController::Pi { proportional_N_m_s: 1e4, integral_N_m: 1e4 },
        torque_limit_N_m,
    }
}

/// A stall is reported as a stall, whatever severity of stick-slip its speeds give.
#[test]
fn a_stalled_top_drive() {
    let mut ran = Ran::new(RotateOffBottom);
    let stick_slip = StickSlip {
        severity: Some(12.6),
        torque_severity: None,
        period_s: None,
        stuck_fraction: 0.9,
        bit_speed_max_rad_per_s: 3.0,
    };
    ran.outcome.indicators.stick_slip = Some(stick_slip);
    ran.outcome.series.rotary_speed_rad_per_s.fill(0.0);
    ran.outcome.series.surface_torque_N_m.fill(30e3);
    assert_eq!(ran.severity(CheckKind::StickSlip), Some(Severity::Warning));
    ran.settings.top_drive = driven(Some(30e3));
    let has = ran.has(CheckKind::TopDriveStalled).expect("a finding");
    assert_eq!((has.severity, has.limit), (Severity::Error, Some(30e3)));
    assert_eq!(ran.has(CheckKind::StickSlip), None);
    assert_eq!(ran.has(CheckKind::TopDriveAtLimit), None);
    // A top drive that turns, however slowly, works at its limit.
    for (part, level) in [(0.5, Severity::Error), (0.95, Severity::Warning)] {
        let set = ran.outcome.series.rotary_speed_set_rad_per_s.clone();
        ran.outcome.series.rotary_speed_rad_per_s = set.iter().map(|set| part * set).collect();
        assert_eq!(ran.severity(CheckKind::TopDriveAtLimit), Some(level));
        assert_eq!(ran.has(CheckKind::TopDriveStalled), None);
    }
    for limit in [Some(31e3), None] {
        ran.settings.top_drive = driven(limit);
        assert_eq!(ran.has(CheckKind::TopDriveAtLimit), None);
    }
}

#[test]
fn stick_slip_and_whirl() {
    let mut ran = Ran::new(RotateOffBottom);
    let stick_slip = |severity, stuck_fraction| StickSlip {
        severity,
        torque_severity: None,
        period_s: None,
        stuck_fraction,
        bit_speed_max_rad_per_s: 3.0,
    };
    for (stick_slip, level) in [
        (stick_slip(Some(0.49), 0.0), None),
        (stick_slip(Some(0.51), 0.0), Some(Severity::Note)),
        (stick_slip(Some(1.01), 0.2), Some(Severity::Warning)),
        (stick_slip(None, 0.9), None),
        (stick_slip(None, 1.0), Some(Severity::Warning)),
    ] {
        ran.outcome.indicators.stick_slip = Some(stick_slip);
        assert_eq!(ran.severity(CheckKind::StickSlip), level, "{stick_slip:?}");
    }
    assert_eq!(ran.has(CheckKind::BackwardWhirl), None);
    let whirl = Whirl { md_m: 90.0, rate_rad_per_s: -20.0, ratio: -2.7, length_fraction: 0.1 };
    ran.outcome.indicators.backward_whirl = Some(whirl);
    let has = ran.has(CheckKind::BackwardWhirl).expect("a finding");
    assert_eq!((has.severity, has.md_m), (Severity::Warning, Some(90.0)));
    assert_eq!(ran.has(CheckKind::ForwardWhirl), None);
    ran.outcome.indicators.forward_whirl = Some(whirl);
    assert_eq!(ran.severity(CheckKind::ForwardWhirl), Some(Severity::Note));
}

/// The clearance of 5 in pipe in an 8-1/2 in hole is 44.45 mm.
#[test]
fn numbers_that_are_not_to_be_trusted() {
    let mut ran = Ran::new(RotateOffBottom);
    for (penetration_m, level) in [
        (4.4e-3, None),
        (4.5e-3, Some(Severity::Warning)),
        (44.4e-3, Some(Severity::Warning)),
        (1.44, Some(Severity::Error)),
    ] {
        let numerics = &mut ran.outcome.numerics;
        numerics.max_penetration_m = penetration_m;
        numerics.deepest_contact = Some(DeepestContact { penetration_m, md_m: 42.0 });
        let check = ran.has(CheckKind::WallPenetration);
        assert_eq!(check.as_ref().map(|check| check.severity), level, "{penetration_m}");
        assert_eq!(check.and_then(|check| check.md_m), level.and(Some(42.0)));
        // A bit that its lateral spring lets off the axis: no wall acts on it.
        let numerics = &mut ran.outcome.numerics;
        numerics.deepest_contact = Some(DeepestContact { penetration_m: 1e-4, md_m: 42.0 });
        let bit = ran.has(CheckKind::WallPenetration);
        let level = level.filter(|level| *level == Severity::Error);
        assert_eq!(bit.as_ref().map(|check| check.severity), level, "{penetration_m}");
        assert_eq!(bit.and_then(|check| check.md_m), level.and(Some(100.0)));
    }
    ran.outcome.numerics.max_penetration_m = 1e-4;
    for (residual, level) in [
        (-0.05, None),
        (0.051, Some(Severity::Warning)),
        (-0.45, Some(Severity::Error)),
        (f64::NAN, Some(Severity::Error)),
    ] {
        ran.outcome.numerics.energy_residual = residual;
        assert_eq!(ran.severity(CheckKind::EnergyResidual), level, "{residual}");
    }
    let table_use = |outside_fraction| TableUse {
        outside_fraction,
        weights_N: [0.0, 1e4],
        table_weights_N: [1e3, 9e3],
        speeds_rad_per_s: [1.0, 2.0],
        table_speeds_rad_per_s: [1.0, 2.0],
    };
    for (fraction, level) in [(0.0, None), (0.01, Some(Severity::Warning))] {
        ran.outcome.bit_table = Some(table_use(fraction));
        assert_eq!(ran.severity(CheckKind::BitTableLeft), level);
    }
}

/// A bit that shakes a string of elements from joint to joint is a note; one that does not shake it
/// is not, nor is one on shorter elements.
#[test]
fn a_shaken_string_of_long_elements() {
    let mut ran = Ran::new(Drill);
    let shakes = |ran: &mut Ran, part: f64, reason: SizeReason| {
        ran.outcome.nodes.element_size.fill(reason);
        let statistics = &mut ran.outcome.statistics;
        let weight = statistics.iter_mut().find(|(name, _)| *name == "weight_on_bit_N");
        let (_, weight) = weight.expect("a weight on bit");
        weight.std = part * weight.mean;
        ran.severity(CheckKind::BendingWavesLeftOut)
    };
    for (part, reason, level) in [
        (0.021, SizeReason::JointToJoint, Some(Severity::Note)),
        (0.021, SizeReason::PlainPipe, Some(Severity::Note)),
        (0.019, SizeReason::JointToJoint, None),
        (0.021, SizeReason::Given, None),
        (0.021, SizeReason::BodyContact, None),
    ] {
        assert_eq!(shakes(&mut ran, part, reason), level, "{part} {reason:?}");
    }
}

#[test]
fn a_node_that_never_settled() {
    let mut ran = Ran::new(RotateOffBottom);
    let nodes = &mut ran.outcome.nodes;
    nodes.tension_std_N.fill(10.0);
    let largest_N = nodes.tension_N.iter().fold(0.0, |largest: f64, t| largest.max(t.abs()));
    let place = nodes.md_m.len() / 2;
    let md_m = nodes.md_m[place];
    nodes.tension_std_N[place] = 0.019 * largest_N;
    assert_eq!(ran.has(CheckKind::NodeUnsettled), None);
    ran.outcome.nodes.tension_std_N[place] = 0.021 * largest_N;
    let has = ran.has(CheckKind::NodeUnsettled).expect("a finding");
    assert_eq!((has.severity, has.md_m), (Severity::Warning, Some(md_m)));
    // A string that swings as a whole is a different case.
    ran.outcome.nodes.tension_std_N.fill(0.021 * largest_N);
    assert_eq!(ran.has(CheckKind::NodeUnsettled), None);
}

/// A mean that moves is a warning, and no more than a note where the bit moves, too.
#[test]
fn means_that_drift_and_endless_settling_are_reported() {
    let mut ran = Ran::new(OperationKind::TripIn);
    ran.outcome.numerics.bit_travel_m = 0.9;
    assert_eq!(ran.severity(CheckKind::WindowDrifts), None);
    ran.statistic("hook_load_N").drifts = true;
    assert_eq!(ran.severity(CheckKind::WindowDrifts), Some(Severity::Warning));
    ran.outcome.numerics.bit_travel_m = -1.1;
    assert_eq!(ran.severity(CheckKind::WindowDrifts), Some(Severity::Note));

    assert_eq!(ran.severity(CheckKind::NeverSteady), None);
    ran.outcome.numerics.settled = Some(false);
    let found = ran.has(CheckKind::NeverSteady).expect("a finding");
    assert_eq!(found.severity, Severity::Warning);
    assert_eq!(found.value, Some(ran.outcome.numerics.settle_s));
}

/// An element that buckles between its nodes makes the answer useless, however steady the run is.
#[test]
fn an_element_beyond_its_own_buckling_load_is_an_error() {
    let mut ran = Ran::new(OperationKind::TripIn);
    assert_eq!(ran.outcome.numerics.buckled_element, None);
    let element =
        BuckledElement { md_m: 77.0, length_m: 9.6, compression_N: 160e3, own_load_N: 133e3 };
    ran.outcome.numerics.buckled_element = Some(element);
    let found = ran.has(CheckKind::ElementBuckles).expect("a finding");
    assert_eq!((found.severity, found.md_m), (Severity::Error, Some(77.0)));
    assert_eq!((found.value, found.limit), (Some(160e3), Some(133e3)));
}

/// Settling that takes longer than foreseen moves the bit on; a time that is given is meant so.
#[test]
fn a_bit_that_has_advanced_is_reported() {
    let mut ran = Ran::new(OperationKind::TripIn);
    let requested_m = ran.operation.bit_depth_m;
    for (settled, off_m, is_reported) in [
        (None, 27.0, false),
        (Some(true), 0.9, false),
        (Some(true), 1.1, true),
        (Some(false), -1.1, true),
    ] {
        ran.outcome.numerics.settled = settled;
        ran.outcome.numerics.mean_bit_depth_m = requested_m + off_m;
        let found = ran.has(CheckKind::BitElsewhere);
        assert_eq!(found.is_some(), is_reported, "{settled:?} {off_m}");
        assert!(found.is_none_or(
            |check| check.limit == Some(requested_m) && check.severity == Severity::Note
        ));
    }
}
