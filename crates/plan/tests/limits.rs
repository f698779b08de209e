//! Limits of solved operations, against closed forms through the whole path: model, soft or stiff
//! string, limits.

mod common;

use std::f64::consts::PI;

use common::*;
use wholestring::{
    mud::Rheology,
    outcome::{QuantityKind, Solution},
    prelude::*,
    rig::Rig,
    statics::stiff::{self, StiffSettings},
    string::{Component, ConnectionStrength, ToolJoints, catalogue::PipeClass},
};
use wholestring_judge::{
    Check, CheckKind, Checks, DesignFactors, Judge, LimitSettings, Missing, Severity, Verdict,
    strength::{BendSide, BodyLoads, PSI_PA, Surface, worst_stress},
    surface_limits,
};
use wholestring_units::UnitSet;
use wholestring_verification::{report_worst, verify};

const YIELD_PA: f64 = 135e3 * PSI_PA;

/// 5 in 19.50 lb/ft, plain, in air.
fn five_inch(name: &str, length: ComponentLength, yield_strength_Pa: f64) -> ComponentSpec {
    ComponentSpec {
        yield_strength_Pa: Some(yield_strength_Pa),
        ..ComponentSpec::uniform(name, 5.0 * INCH_M, 4.276 * INCH_M, length, steel())
    }
}

/// The same, worn to the limit of its class.
fn worn(new: &ComponentSpec, class: PipeClass) -> ComponentSpec {
    let od_m = new.id_m + class.wall_left() * (new.od_m - new.id_m);
    ComponentSpec { od_m, class, ..new.clone() }
}

/// A string in a hole of 0.3 m through stations of measured depth, inclination and azimuth, m and
/// degrees.
fn in_hole(
    stations: &[[f64; 3]],
    friction: f64,
    mud: Mud,
    components: Vec<ComponentSpec>,
) -> Model {
    let stations: Vec<Station> =
        stations.iter().map(|&[md, inc, azi]| Station::from_degrees(md, inc, azi)).collect();
    let path = Path::minimum_curvature(&stations).expect("a sound survey");
    let depth_m = path.last_md_m();
    let hole = Hole::new(vec![HoleSection::open(0.0..depth_m, 0.3, friction)]).expect("a hole");
    let string = StringSpec { components }.assemble(depth_m).expect("a string");
    Model::new(Well { path, hole }, string, mud)
}

fn vertical(length_m: f64, components: Vec<ComponentSpec>) -> Model {
    let stations = [[0.0, 0.0, 0.0], [length_m, 0.0, 0.0]];
    in_hole(&stations, 0.3, Mud::of_density(0.0), components)
}

fn limits(
    model: &Model,
    operation: &Operation,
    solution: &Solution<'_>,
    settings: &LimitSettings,
) -> Checks {
    Judge::new(*settings, UnitSet::Si).limits(model, operation, solution)
}

fn soft(model: &Model, operation: &Operation, settings: &LimitSettings) -> Checks {
    let solved = soft_string(model, operation).expect("a sound model");
    limits(model, operation, &(&solved).into(), settings)
}

/// A limit with its numbers.
struct Limit {
    check: Check,
    load: f64,
    capacity: f64,
    factor: f64,
}

fn weight_N_per_m(model: &Model, component: usize) -> f64 {
    model.string.components()[component]
        .buoyed_weight_per_length_N_per_m(model.mud.density_kg_per_m3)
}

#[track_caller]
fn of(found: &Checks, kind: CheckKind, component: Option<&str>) -> Limit {
    let is_it = |check: &&Check| check.kind == kind && check.component.as_deref() == component;
    let mut all = found.limits().filter(is_it);
    let check = all.next().unwrap_or_else(|| panic!("no {kind:?} of {component:?}: {found:?}"));
    assert!(all.next().is_none(), "twice: {kind:?} of {component:?}");
    let number = |value: Option<f64>| value.expect("a limit with its numbers");
    let (load, capacity) = (number(check.value), number(check.limit));
    let factor = number(check.factor);
    assert!((factor - capacity / load).abs() < 1e-12 * factor);
    Limit { check: check.clone(), load, capacity, factor }
}

/// A pipe that hangs: its weight, at its top; the margin of overpull of S3b.
#[test]
fn a_pipe_that_hangs() {
    let mut model = vertical(3000.0, vec![five_inch("pipe", ToSurface, YIELD_PA)]);
    model.rig = Rig {
        hoist_capacity_N: Some(2.0e6),
        block_weight_N: Some(3e5),
        top_drive_torque_N_m: Some(5e4),
        ..Rig::default()
    };
    let settings = LimitSettings { overpull_N: 1e6, ..LimitSettings::default() };
    let found = soft(&model, &Operation::trip_out(3000.0), &settings);
    let hangs_N = 3000.0 * weight_N_per_m(&model, 0);
    let yield_N = 712_070.437_765_568_3 * POUND_FORCE_N;
    let tension = of(&found, CheckKind::Tension, Some("pipe"));
    assert_close("load", tension.load, hangs_N, 1e-9);
    assert_close("capacity", tension.capacity, yield_N, 1e-9);
    assert_eq!((tension.check.md_m, tension.check.verdict), (Some(0.0), Verdict::Ok));
    assert_close("reserve", tension.check.reserve(), 0.9 * yield_N / hangs_N, 1e-9);
    let stress = of(&found, CheckKind::VonMises, Some("pipe"));
    assert_close("stress", stress.load, hangs_N * YIELD_PA / yield_N, 1e-9);
    assert_close(
        "as the points",
        stress.check.stress.expect("points").von_mises_Pa,
        stress.load,
        1e-12,
    );

    let pipe = of(&found, CheckKind::Overpull, Some("pipe"));
    assert_close("margin", pipe.capacity, 0.9 * yield_N - hangs_N, 1e-9);
    let hoist = of(&found, CheckKind::Overpull, None);
    assert_close("of the hoist", hoist.capacity, 0.9 * 2.0e6 - hangs_N - 3e5, 1e-9);
    assert_eq!([pipe.check.verdict, hoist.check.verdict], [Verdict::Ok, Verdict::BelowRequired]);
    // A hoist that is overloaded has less than nothing left, and two of them are told apart.
    let left_N = |capacity_N| {
        let mut model = model.clone();
        model.rig.hoist_capacity_N = Some(capacity_N);
        let found = soft(&model, &Operation::trip_out(3000.0), &settings).checks;
        let mut found = found.iter().filter(|check| check.kind == CheckKind::Overpull);
        let check = found.find(|check| check.component.is_none()).expect("the hoist's");
        assert!(check.sentence.starts_with("Overpull margin of the hoist"), "{}", check.sentence);
        check.limit.expect("what is left")
    };
    let block_N = 3e5;
    assert_close("overloaded", left_N(6e5), 0.9 * 6e5 - hangs_N - block_N, 1e-9);
    assert!(left_N(6e5) < left_N(7e5) && left_N(7e5) < 0.0);
    assert_close("hoist", of(&found, CheckKind::Hoist, None).load, hangs_N + 3e5, 1e-9);
    let governing = found.governing().expect("a limit");
    assert_eq!(governing.kind, CheckKind::Hoist);

    // Without rotation, flow or compression there is no such limit, and unknown strengths are
    // reported.
    use CheckKind::*;
    for kind in [Torsion, TensionAndTorsion, TopDrive, Burst, Collapse, HelicalBuckling, LockUp] {
        assert!(found.worst(kind).is_none(), "{kind:?}");
    }
    let lacks: Vec<_> =
        found.unchecked.iter().map(|lack| (lack.kind, lack.component.as_deref())).collect();
    assert_eq!(lacks, [(MakeUp, Some("pipe")), (TopDrivePeak, None)]);
}

/// The allowable load at the surface separates the verdicts: a hook load or a torque that is
/// slightly less meets the required factor, one that is slightly more does not. The pipe's are
/// those of the topmost component, and unknown strengths have none.
#[test]
fn what_is_allowed_at_the_surface() {
    let connection = ConnectionStrength {
        make_up_torque_N_m: Some(2.5e4),
        torsional_yield_N_m: Some(4.2e4),
        ..ConnectionStrength::default()
    };
    let top = ComponentSpec { connection, ..five_inch("top", ToSurface, YIELD_PA) };
    let mut model = vertical(3000.0, vec![five_inch("below", Metres(100.0), YIELD_PA), top]);
    model.rig = Rig {
        hoist_capacity_N: Some(2.0e6),
        block_weight_N: Some(3e5),
        top_drive_torque_N_m: Some(5e4),
        top_drive_peak_torque_N_m: Some(7e4),
        ..Rig::default()
    };
    let settings = LimitSettings::default();
    let allowed = surface_limits(&model, &settings);
    let kinds: Vec<_> =
        allowed.iter().map(|limit| (limit.kind, limit.component.as_deref())).collect();
    use CheckKind::*;
    assert_eq!(
        kinds,
        [
            (Hoist, None),
            (Tension, Some("top")),
            (TopDrive, None),
            (TopDrivePeak, None),
            (MakeUp, Some("top")),
            (Torsion, Some("top")),
        ]
    );
    for of_surface in &allowed {
        for (part, is_kept) in [(1.0 - 1e-6, true), (1.0 + 1e-6, false)] {
            let load = part * of_surface.allowed;
            let is_torque = of_surface.kind.quantity() == QuantityKind::Torque;
            let hangs_N = 3000.0 * weight_N_per_m(&model, 0);
            // There is no friction in a vertical hole: the bit's torque equals that at the surface,
            // and a pull at the bit makes up the difference of the hook load.
            let operation = match is_torque {
                true => Operation::drill(3000.0)
                    .rotary_speed_rad_per_s(12.0)
                    .rate_of_penetration_m_per_s(1e-3)
                    .weight_on_bit_N(5e4)
                    .bit_torque_N_m(load),
                false => Operation::trip_out(3000.0).bit_pull_N(load - hangs_N),
            };
            let solved = soft_string(&model, &operation).expect("a sound model");
            let found = limits(&model, &operation, &(&solved).into(), &settings);
            let at_top = of(&found, of_surface.kind, of_surface.component.as_deref()).check;
            assert_eq!(at_top.reserve() > 1.0, is_kept, "{of_surface:?}: {at_top:?}");
            assert_close("of the surface", at_top.reserve(), 1.0, 3e-6);
        }
    }
    // Without ratings of the rig and the pipe's yield strength no limit is known.
    let bare = ComponentSpec { yield_strength_Pa: None, ..five_inch("bare", ToSurface, YIELD_PA) };
    assert!(surface_limits(&vertical(1000.0, vec![bare]), &settings).is_empty());
}

/// Each component of a tapered string has its largest load at its own top, whichever of two rows
/// that is; the bit has no limit, and a body without yield strength is reported.
#[test]
fn each_component_has_its_limit() {
    let plain =
        ComponentSpec { yield_strength_Pa: None, ..five_inch("plain", Metres(99.7), YIELD_PA) };
    let model = vertical(
        2500.0,
        vec![
            ComponentSpec::bit(0.2159, 0.3),
            plain,
            five_inch("weak", Metres(1400.0), 75e3 * PSI_PA),
            five_inch("strong", ToSurface, YIELD_PA),
        ],
    );
    let found = soft(&model, &Operation::trip_out(2500.0), &LimitSettings::default());
    let hung_N = |components: usize| -> f64 {
        let below = model.string.components()[..components].iter().enumerate();
        below.map(|(index, component)| weight_N_per_m(&model, index) * component.length_m).sum()
    };
    for (name, count, md_m) in [("weak", 3, 1000.0), ("strong", 4, 0.0)] {
        let tension = of(&found, CheckKind::Tension, Some(name));
        assert_close("tension", tension.load, hung_N(count), 1e-9);
        assert!((tension.check.md_m.expect("a place") - md_m).abs() < 1e-6);
    }
    let lacks = |component: &str| {
        let lacking = found.unchecked.iter();
        let lacking = lacking.filter(|lack| lack.component.as_deref() == Some(component));
        lacking.filter(|lack| lack.missing == Missing::YieldStrength).count()
    };
    assert_eq!(["bit", "plain", "weak", "strong"].map(lacks), [0, 6, 0, 0]);
}

/// S3b through the whole path: drilling in a vertical hole, the top carries the weight less that on
/// the bit and the torque of the bit, against the torsional yield under that tension.
#[test]
fn s3b_through_the_whole_path() {
    let data = verification("S3b_torque_under_tension_overpull.json");
    let whole = five_inch("pipe", ToSurface, YIELD_PA);
    let mut rows = Vec::new();
    for case in data["cases"].as_array().expect("cases") {
        let (input, expected) = (&case["inputs"], &case["expected"]);
        let premium = number(input, "od_in") < 4.99;
        let class = if premium { PipeClass::Premium } else { PipeClass::New };
        let tension_N = number(input, "tension_lbf") * POUND_FORCE_N;
        let model = vertical(1000.0, vec![worn(&whole, class)]);
        let weight_N = 1000.0 * weight_N_per_m(&model, 0);
        let drill = Operation::drill(1000.0)
            .rotary_speed_rad_per_s(12.0)
            .rate_of_penetration_m_per_s(1e-9)
            .weight_on_bit_N(weight_N - tension_N)
            .bit_torque_N_m(2e4);
        let found = soft(&model, &drill, &LimitSettings::default());
        // The tension for the torsional yield is that at the top; where it is zero, the pipe below
        // is in compression.
        if tension_N == 0.0 {
            continue;
        }
        let combined = of(&found, CheckKind::TensionAndTorsion, Some("pipe"));
        let pulled = combined.check.md_m == Some(0.0);
        assert!(pulled || tension_N < weight_N, "{:?}", combined.check);
        assert_close("torque", combined.load, 2e4, 1e-6);
        if pulled {
            let what = format!("torsional yield of a {class:?} pipe that drills, N·m");
            rows.push((what, combined.capacity, number(expected, "torque_under_tension_Nm")));
        }
        let torsion = of(&found, CheckKind::Torsion, Some("pipe"));
        let yield_N_m = number(expected, "torsional_yield_ftlbf") * FOOT_POUND_N_M;
        assert_close("torsion", torsion.capacity, yield_N_m, 1e-9);
    }
    assert!(rows.len() >= 6);
    report_worst(rows.iter().map(|(what, computed, expected)| {
        verify("S3b", what)
            .relative(1e-6, "the file's; the tension at the top by integration")
            .row(*expected, *computed)
    }));
}

/// Weightless pipe with tool joints in an arc under a tension: bent by `x coth x` more than the
/// hole at its joints. Its von Mises stress, new and worn, by the closed forms; and of the stiff
/// string.
#[test]
fn bending_at_joints_counts() {
    let (tension_N, torque_N_m, rate_per_m) = (4e5, 8e3, (3.0_f64 / 30.0).to_radians());
    let joints = Some(ToolJoints { od_m: 0.1683, spacing_m: 9.6 });
    let pipe = ComponentSpec { joints, ..five_inch("pipe", ToSurface, YIELD_PA) };
    let mud = Mud::of_density(steel().density_kg_per_m3);
    let model = |pipe| in_hole(&[[0.0, 0.0, 0.0], [600.0, 60.0, 0.0]], 0.0, mud, vec![pipe]);
    let drill = Operation::drill(600.0)
        .rotary_speed_rad_per_s(12.0)
        .rate_of_penetration_m_per_s(1e-3)
        .weight_on_bit_N(-tension_N)
        .bit_torque_N_m(torque_N_m);
    let settings = LimitSettings::default();
    let mut rows = Vec::new();
    for class in PipeClass::ALL {
        // Weightless at any wear.
        let body = worn(&pipe, class);
        let model = model(body);
        let body = &model.string.components()[0];
        let found = of(&soft(&model, &drill, &settings), CheckKind::VonMises, Some("pipe"));
        let x = 4.8 * (tension_N / body.bending_stiffness_N_m2()).sqrt();
        let bent_Pa = 210e9 * rate_per_m * x / x.tanh() * 0.5 * body.od_m;
        let sheared_Pa = torque_N_m * 0.5 * body.od_m / body.polar_moment_m4();
        let normal_Pa = tension_N / body.area_m2() + bent_Pa;
        let expected_Pa = (normal_Pa.powi(2) + 3.0 * sheared_Pa.powi(2)).sqrt();
        let what = format!("von Mises stress of {class:?} pipe in an arc with joints, Pa");
        rows.push((what, found.load, expected_Pa));
        let point = found.check.stress.expect("a point");
        assert_eq!((point.surface, point.side), (Surface::Outer, BendSide::Tension));
    }
    report_worst(rows.iter().map(|(what, computed, expected)| {
        verify("S3a", what).relative(1e-9, "rounding").row(*expected, *computed)
    }));
    let model = model(pipe);
    let solved = stiff::solve(&model, &drill, &StiffSettings::default()).expect("an equilibrium");
    let stiff = limits(&model, &drill, &(&solved).into(), &settings);
    let largest = solved.von_mises_stress_Pa.iter().copied().fold(0.0, f64::max);
    assert_close("stiff", of(&stiff, CheckKind::VonMises, Some("pipe")).load, largest, 1e-9);
}

/// The internal pressure of a flowing mud is largest at the surface: the pressure of the pump.
#[test]
fn burst_and_the_pump() {
    let mud = Mud {
        rheology: Some(Rheology::Newtonian { viscosity_Pa_s: 0.02 }),
        ..Mud::of_density(1200.0)
    };
    let stations = [[0.0, 0.0, 0.0], [2000.0, 0.0, 0.0]];
    let pipe = five_inch("pipe", ToSurface, YIELD_PA);
    let mut model = in_hole(&stations, 0.3, mud, vec![pipe]);
    model.rig.pump_pressure_limit_Pa = Some(35e6);
    let turn = Operation::rotate_off_bottom(2000.0)
        .rotary_speed_rad_per_s(12.0)
        .flow_rate_m3_per_s(0.03)
        .bit_pressure_drop_Pa(8e6);
    let settings = LimitSettings::default();
    let solved = soft_string(&model, &turn).expect("a sound model");
    let found = limits(&model, &turn, &(&solved).into(), &settings);
    let pump_Pa = solved.hydraulics.expect("a rheology").pump_pressure_Pa;
    let pump = of(&found, CheckKind::PumpPressure, None);
    assert_eq!([pump.load, pump.capacity], [pump_Pa, 35e6]);
    let burst = of(&found, CheckKind::Burst, Some("pipe"));
    assert_close("inside", burst.load, pump_Pa, 1e-9);
    assert_eq!(burst.check.md_m, Some(0.0));
    assert_close("Barlow", burst.capacity / PSI_PA, 17_104.5, 1e-9);
    assert!(found.worst(CheckKind::Collapse).is_none());

    // While the string trips the pumps rest: its pressure is surge or swab, and the limit of the
    // pump does not apply.
    let trip = Operation::trip_in(2000.0).trip_speed_m_per_s(0.5);
    let found = soft(&model, &trip, &settings);
    assert!(found.worst(CheckKind::PumpPressure).is_none());
    assert!(found.unchecked.iter().all(|unchecked| unchecked.kind != CheckKind::PumpPressure));

    // Without a rheology the pump pressure is not known.
    let still = Model { mud: Mud::of_density(1200.0), ..model };
    let found = soft(&still, &turn, &settings);
    let lacks = found.unchecked.iter().find(|unchecked| unchecked.kind == CheckKind::PumpPressure);
    assert_eq!(lacks.expect("a note").missing, Missing::Rheology);
}

/// Where the external pressure is the larger: collapse under the local tension, by API TR 5C3.
/// Loads by hand.
#[test]
fn collapse_under_tension() {
    let model = vertical(1000.0, vec![five_inch("pipe", ToSurface, YIELD_PA)]);
    let hang = Operation::trip_out(1000.0);
    let mut solved = soft_string(&model, &hang).expect("a sound model");
    // As if the string were run empty in 1200 kg/m³.
    let weight_Pa_per_m = 1200.0 * 9.80665;
    let outside = solved.profile.md_m.iter().map(|md_m| weight_Pa_per_m * md_m);
    solved.profile.outside_pressure_Pa = outside.collect();
    let found = limits(&model, &hang, &(&solved).into(), &LimitSettings::default());
    let collapse = of(&found, CheckKind::Collapse, Some("pipe"));
    let md_m = collapse.check.md_m.expect("a place");
    assert_close("load", collapse.load, weight_Pa_per_m * md_m, 1e-12);
    // The pull at the bit is nearly zero, where the mud pressure is largest.
    assert!(md_m > 999.0);
    let untouched = 15_672.0 * PSI_PA;
    assert_close("capacity", collapse.capacity, untouched, 2e-3);
}

/// A string that slides down a slant: the driving force is `w L cos θ`, the resistance `μ w L sin
/// θ` and the bit.
#[test]
fn sliding_down_a_slant() {
    let (friction, inc_deg, length_m) = (0.2, 60.0_f64, 1500.0);
    let pipe = five_inch("pipe", ToSurface, YIELD_PA);
    let stations = [[0.0, inc_deg, 0.0], [length_m, inc_deg, 0.0]];
    let model = in_hole(&stations, friction, Mud::of_density(1200.0), vec![pipe]);
    let weight_N = length_m * weight_N_per_m(&model, 0);
    let (sin, cos) = inc_deg.to_radians().sin_cos();
    for asked_N in [0.0, 2e4, 6e4, 1.2e5] {
        let down = if asked_N > 0.0 {
            Operation::slide(length_m)
                .weight_on_bit_N(asked_N)
                .bit_torque_N_m(1e3)
                .rate_of_penetration_m_per_s(1e-3)
        } else {
            Operation::trip_in(length_m)
        };
        let found = soft(&model, &down, &LimitSettings::default());
        let lock_up = found.worst(CheckKind::LockUp).expect("a limit");
        let expected = weight_N * cos / (friction * weight_N * sin + asked_N);
        assert_close("lock-up", lock_up.factor.expect("a factor"), expected, 1e-6);
        assert_eq!(lock_up.verdict == Verdict::Exceeded, expected < 1.0, "{asked_N}");
        // No overpull is required for an operation without a pull.
        assert!(found.worst(CheckKind::Overpull).is_none());
        // The weight of the block pushes too.
        let mut pushed = model.clone();
        pushed.rig.block_weight_N = Some(1e4);
        let found = soft(&pushed, &down, &LimitSettings::default());
        let expected = (weight_N * cos + 1e4) / (friction * weight_N * sin + asked_N);
        assert_close(
            "pushed",
            found.worst(CheckKind::LockUp).and_then(|check| check.factor).expect("a limit"),
            expected,
            1e-6,
        );
    }
}

/// Compression of a level pipe against Dawson and Paslay's `2 √(EI w/r)` and the helix's `√2` of
/// it.
#[test]
fn buckling_of_a_level_pipe() {
    let pipe = five_inch("pipe", ToSurface, YIELD_PA);
    let stations = [[0.0, 90.0, 0.0], [1000.0, 90.0, 0.0]];
    let model = in_hole(&stations, 0.0, Mud::of_density(1200.0), vec![pipe]);
    let pressed_N = 3e5;
    let slide = Operation::slide(1000.0)
        .weight_on_bit_N(pressed_N)
        .bit_torque_N_m(1e3)
        .rate_of_penetration_m_per_s(1e-3);
    let found = soft(&model, &slide, &LimitSettings::default());
    let body = &model.string.components()[0];
    let clearance_m = 0.5 * (0.3 - body.od_m);
    let dawson_N =
        2.0 * (body.bending_stiffness_N_m2() * weight_N_per_m(&model, 0) / clearance_m).sqrt();
    for (kind, critical_N) in [
        (CheckKind::SinusoidalBuckling, dawson_N),
        (CheckKind::HelicalBuckling, 2.0_f64.sqrt() * dawson_N),
    ] {
        let limit = of(&found, kind, Some("pipe"));
        assert_close(kind.name(), limit.factor, critical_N / pressed_N, 1e-6);
        // Exceeded, but neither broken nor stopped.
        assert_eq!(limit.check.verdict, Verdict::Exceeded);
        assert_eq!(limit.check.severity, Severity::Warning);
        assert!(!kind.stops());
    }
}

/// Given strengths of connections replace higher ones: tool joints that yield before the body, a
/// make-up torque that is exceeded.
#[test]
fn connections_that_are_given() {
    let connection = ConnectionStrength {
        make_up_torque_N_m: Some(2.5e4),
        torsional_yield_N_m: Some(4.2e4),
        tensile_yield_N: Some(9e9),
    };
    let pipe = ComponentSpec { connection, ..five_inch("pipe", ToSurface, YIELD_PA) };
    let model = vertical(1000.0, vec![pipe.clone()]);
    let drill = Operation::drill(1000.0)
        .rotary_speed_rad_per_s(12.0)
        .rate_of_penetration_m_per_s(1e-3)
        .weight_on_bit_N(5e4)
        .bit_torque_N_m(3e4);
    let settings = LimitSettings::default();
    let found = soft(&model, &drill, &settings);
    let made_up = of(&found, CheckKind::MakeUp, Some("pipe"));
    assert_close("make-up", made_up.factor, 2.5e4 / 3e4, 1e-6);
    assert_eq!(made_up.check.verdict, Verdict::Exceeded);
    assert_eq!(of(&found, CheckKind::Torsion, Some("pipe")).capacity, 4.2e4);
    let yield_N = 712_070.437_765_568_3 * POUND_FORCE_N;
    assert_close("body", of(&found, CheckKind::Tension, Some("pipe")).capacity, yield_N, 1e-9);
    assert_eq!(found.governing().map(|check| check.kind), Some(CheckKind::MakeUp));
    // Joints are known where the body is not.
    let unknown = ComponentSpec { yield_strength_Pa: None, ..pipe };
    let found = soft(&vertical(1000.0, vec![unknown]), &drill, &settings);
    assert_eq!(of(&found, CheckKind::Torsion, Some("pipe")).capacity, 4.2e4);
    let lacks: Vec<_> = found.unchecked.iter().map(|unchecked| unchecked.kind).collect();
    assert!(!lacks.contains(&CheckKind::Torsion) && lacks.contains(&CheckKind::VonMises));
}

/// Required factors are those that are given.
#[test]
fn factors_are_required() {
    let model = vertical(3000.0, vec![five_inch("pipe", ToSurface, YIELD_PA)]);
    let level = |tension: f64| {
        let factors = DesignFactors { tension, ..DesignFactors::default() };
        let settings = LimitSettings { factors, ..LimitSettings::default() };
        let found = soft(&model, &Operation::trip_out(3000.0), &settings);
        of(&found, CheckKind::Tension, Some("pipe"))
    };
    let factor = level(1.0).factor;
    for (part, expected) in
        [(0.85, Verdict::Ok), (0.95, Verdict::Marginal), (1.05, Verdict::BelowRequired)]
    {
        let limit = level(part * factor);
        assert_eq!(limit.check.verdict, expected);
        assert_close("reserve", limit.check.reserve(), 1.0 / part, 1e-12);
    }
    assert_eq!(DesignFactors::default().bad_factor(), None);
    let bad = DesignFactors { burst: -1.0, ..DesignFactors::default() };
    assert_eq!(bad.bad_factor(), Some((CheckKind::Burst, -1.0)));
}

/// A pull on the bit of a bent pipe, by hand: the worst point of the worst place has the stresses
/// of `worst_stress`.
#[test]
fn the_worst_point_is_told() {
    let pipe = five_inch("pipe", ToSurface, YIELD_PA);
    let model =
        in_hole(&[[0.0, 0.0, 0.0], [900.0, 90.0, 0.0]], 0.3, Mud::of_density(1200.0), vec![pipe]);
    let out = Operation::trip_out(900.0).bit_pull_N(2e5);
    let solved = soft_string(&model, &out).expect("a sound model");
    let found = limits(&model, &out, &(&solved).into(), &LimitSettings::default());
    let limit = of(&found, CheckKind::VonMises, Some("pipe"));
    let row = solved.md_m.iter().position(|md_m| Some(*md_m) == limit.check.md_m).expect("a row");
    let loads = BodyLoads {
        effective_tension_N: solved.tension_N[row],
        bending_N_m: 210e9 * PI / 1800.0 * second_moment_m4(&model),
        inside_Pa: solved.inside_pressure_Pa[row],
        outside_Pa: solved.outside_pressure_Pa[row],
        ..BodyLoads::default()
    };
    let body: &Component = &model.string.components()[0];
    let expected = worst_stress(body, &loads);
    let point = limit.check.stress.expect("a point");
    assert_close("stress", point.von_mises_Pa, expected.von_mises_Pa, 1e-9);
    assert_close("load", limit.load, expected.von_mises_Pa, 1e-9);
}

fn second_moment_m4(model: &Model) -> f64 {
    model.string.components()[0].second_moment_m4()
}

/// A pipe below a stiffer one has its own bending where the two meet, not the other's: in the soft
/// string both have the curvature of the hole.
#[test]
fn each_component_bends_by_its_own_stiffness() {
    let weightless = Mud::of_density(steel().density_kg_per_m3);
    let heavy = ComponentSpec { id_m: 3.0 * INCH_M, ..five_inch("heavy", ToSurface, YIELD_PA) };
    let heavy = ComponentSpec {
        mass_per_length_kg_per_m: ComponentSpec::uniform(
            "",
            heavy.od_m,
            heavy.id_m,
            ToSurface,
            steel(),
        )
        .mass_per_length_kg_per_m,
        ..heavy
    };
    let model = in_hole(
        &[[0.0, 0.0, 0.0], [600.0, 60.0, 0.0]],
        0.0,
        weightless,
        vec![five_inch("pipe", Metres(300.0), YIELD_PA), heavy],
    );
    let pulled = Operation::trip_out(600.0).bit_pull_N(1e5);
    let found = soft(&model, &pulled, &LimitSettings::default());
    for body in model.string.components() {
        let bent_Pa = 210e9 * 0.1_f64.to_radians() * 0.5 * body.od_m;
        let stress = of(&found, CheckKind::VonMises, Some(&body.name)).load;
        assert_close("stress", stress, bent_Pa + 1e5 / body.area_m2(), 1e-9);
    }
}
