//! Events from rest and wear by the dynamics, against closed forms.

mod common;

use std::f64::consts::PI;

use common::*;
use wholestring::{
    GRAVITY_M_PER_S2,
    dynamics::{DynamicsSettings, HoistLine, RodDamping},
    mud::Rheology,
    prelude::*,
    well::{CasingPipe, HoleSection},
};
use wholestring_judge::{CheckKind, strength::PSI_PA};
use wholestring_plan::{
    Broomstick, CampaignSettings, FrictionLevel, Frictions, Setup, Share, Statics,
    dynamic::{DynamicPlan, Event, EventAnswer, EventTask},
    hydraulics::gel_break,
};
use wholestring_verification::verify;

const OD_M: f64 = 0.127;
const ID_M: f64 = 0.1086;
const CASING_OD_M: f64 = 0.244475;
const HOLE_M: f64 = 0.2159;

fn area_m2() -> f64 {
    0.25 * PI * (OD_M * OD_M - ID_M * ID_M)
}

/// Plain pipe in a straight hole at an inclination.
fn straight(length_m: f64, inclination_deg: f64, friction: Friction, mud: Mud) -> Setup {
    straight_of(HOLE_M, length_m, inclination_deg, friction, mud)
}

/// Like [`straight`] in a hole of a diameter, m.
fn straight_of(
    hole_m: f64,
    length_m: f64,
    inclination_deg: f64,
    friction: Friction,
    mud: Mud,
) -> Setup {
    let stations = [0.0, length_m].map(|md_m| Station::from_degrees(md_m, inclination_deg, 0.0));
    let casing = Some(CasingPipe { od_m: CASING_OD_M, yield_strength_Pa: Some(80e3 * PSI_PA) });
    let section =
        HoleSection { casing, friction, ..HoleSection::casing(0.0..length_m, hole_m, 0.2) };
    let pipe = ComponentSpec {
        yield_strength_Pa: Some(135e3 * PSI_PA),
        ..ComponentSpec::uniform("pipe", OD_M, ID_M, ToSurface, steel())
    };
    Setup {
        well: Well {
            path: Path::minimum_curvature(&stations).expect("a path"),
            hole: Hole::new(vec![section]).expect("a hole"),
        },
        string: StringSpec { components: vec![pipe] },
        mud,
        fluids: Default::default(),
        rig: Default::default(),
        ends: Default::default(),
        buckling: Default::default(),
    }
}

fn broomstick(setup: &Setup, operations: Vec<Operation>, depth_m: f64) -> Broomstick {
    let depths_m = vec![depth_m];
    Broomstick::new(setup, &Frictions::default(), operations, depths_m, vec![Statics::Soft])
        .expect("a broomstick")
}

/// A stiff line without a block, without damping.
fn dynamics(element_m: f64) -> DynamicsSettings {
    DynamicsSettings {
        mesh: MeshSettings::uniform(element_m),
        damping: RodDamping { mass_per_s: 0.0, stiffness_s: 0.0 },
        hoist_line: HoistLine {
            stiffness_N_per_m: 1e11,
            damping_N_s_per_m: 0.0,
            block_mass_kg: 0.0,
        },
        ..DynamicsSettings::default()
    }
}

fn answer(
    setup: &Setup,
    event: Event,
    plan: &DynamicPlan,
    dynamics: &DynamicsSettings,
    bit_depth_m: f64,
) -> EventAnswer {
    let task = EventTask { event, friction: FrictionLevel::Expected, bit_depth_m };
    let found = broomstick(setup, Vec::new(), bit_depth_m);
    let found = found.solve_event(&task, plan, dynamics, &|| true).expect("an answer");
    found.expect("it went on")
}

/// A free rod that is lifted at its top, from rest to a speed in a time: `F = W + Z [v(t) + 2 Σ
/// (−1)^k v(t − 2kL/c)]` with `Z = ρ A c`, d'Alembert's waves on a rod whose lower end is free.
#[test]
fn a_rod_is_lifted_against_its_impedance() {
    const LENGTH_M: f64 = 2000.0;
    const SPEED: f64 = 0.3;
    let air = Mud { drag_coefficient: 0.0, ..Mud::of_density(0.0) };
    let setup = straight(LENGTH_M, 0.0, Friction::uniform(0.0), air);
    let wave = (steel().youngs_modulus_Pa / steel().density_kg_per_m3).sqrt();
    let impedance = steel().density_kg_per_m3 * area_m2() * wave;
    let weight_N = steel().density_kg_per_m3 * area_m2() * GRAVITY_M_PER_S2 * LENGTH_M;
    for ramp_s in [0.5, 1.0, 2.0] {
        let velocity = |time_s: f64| SPEED * (time_s / ramp_s).clamp(0.0, 1.0);
        let force_N = |time_s: f64| {
            let echo = |k: i32| {
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                2.0 * sign * velocity(time_s - 2.0 * f64::from(k) * LENGTH_M / wave)
            };
            impedance * (velocity(time_s) + (1..10).map(echo).sum::<f64>())
        };
        let plan = DynamicPlan {
            set_points: Some(Operation::trip_out(LENGTH_M).trip_speed_m_per_s(SPEED)),
            hoist_ramp_s: ramp_s,
            watch_s: 4.0 - ramp_s,
            ..DynamicPlan::default()
        };
        let found = answer(&setup, Event::PickUpFromSlips, &plan, &dynamics(5.0), LENGTH_M);
        let hook = found.hook_load_N;
        // A sample is the mean over the 10 ms before, and the samples may miss the apex.
        let sample = |time_s: f64| {
            (0..10).map(|i| force_N(time_s - 1e-3 * (f64::from(i) + 0.5))).sum::<f64>() / 10.0
        };
        let exact = found.history.time_s.iter().map(|at| sample(*at)).fold(0.0, f64::max);
        verify("peaks", format!("weight of a rod before it is lifted in {ramp_s} s, N"))
            .relative(1e-4, "the rest of the settling after the start")
            .report(weight_N, hook.at_rest);
        verify("peaks", format!("peak over the weight of a rod that is lifted in {ramp_s} s, N"))
            .relative(
                1e-3,
                "the rod rings at its kinks: 5.4e-3 with elements of 10 m, 4.9e-4 with these of 5 m, 2.4e-5 of 2.5 m",
            )
            .report(exact, hook.peak - hook.at_rest);
        // The whole course, not the peak alone: the root of the mean square over four seconds.
        let history = &found.history;
        let squares = history.time_s.iter().zip(&history.hook_load_N).filter(|(t, _)| **t > 0.0);
        let (sum, count) = squares.fold((0.0, 0.0), |(sum, n), (time_s, load_N)| {
            // A sample is the mean over the 10 ms before.
            let off = load_N - hook.at_rest - force_N(time_s - 0.005);
            (sum + off * off, n + 1.0)
        });
        let off = (sum / count).sqrt() / (impedance * SPEED);
        assert!(off < 0.01, "{ramp_s} s: {off}");
        // The tension on the table of limits is that of the top, where the peak is.
        let tension = found.limits.iter().find(|limit| limit.kind == CheckKind::Tension);
        let tension = tension.expect("a yield strength");
        assert!(tension.md_m.is_some_and(|md_m| md_m < 1.0), "{tension:?}");
        verify("peaks", format!("largest tension of a rod that is lifted in {ramp_s} s, N"))
            .relative(
                3e-3,
                "half an element hangs above the first tension: 1.3e-3 with these of 5 m",
            )
            .report(hook.peak, tension.value.expect("a load"));
    }
}

/// The static friction of a string in an inclined hole breaks: the peak is between the kinetic
/// friction and the full static friction, and close to the latter where the block is slow; the
/// steady value is kinetic.
#[test]
fn friction_at_rest_breaks() {
    const LENGTH_M: f64 = 300.0;
    const INCLINATION_DEG: f64 = 60.0;
    let friction = Friction { kinetic: 0.2, at_rest: 0.35, around: 1.0 };
    // Nearly as narrow as the pipe, so that the clamp at the top holds no more than some metres of
    // it off the wall.
    let setup =
        straight_of(0.13, LENGTH_M + 50.0, INCLINATION_DEG, friction, Mud::of_density(1200.0));
    let (speed, ramp_s, stribeck) = (0.5, 25.0, 0.1);
    // Friction that falls with the speed makes an undamped rod stick and slip for ever: the line
    // absorbs the waves that run up the string, as a dashpot of its impedance.
    let wave = (steel().youngs_modulus_Pa / steel().density_kg_per_m3).sqrt();
    let hoist_line = HoistLine {
        stiffness_N_per_m: 1e5,
        damping_N_s_per_m: steel().density_kg_per_m3 * area_m2() * wave,
        block_mass_kg: 0.0,
    };
    let settings =
        DynamicsSettings { stribeck_speed_m_per_s: stribeck, hoist_line, ..dynamics(5.0) };
    let plan = DynamicPlan {
        set_points: Some(
            Operation::trip_out(LENGTH_M).trip_speed_m_per_s(speed).rotary_speed_rad_per_s(10.0),
        ),
        hoist_ramp_s: ramp_s,
        rotary_ramp_s: ramp_s,
        watch_s: 4.0,
        ..DynamicPlan::default()
    };
    let metal = steel().density_kg_per_m3;
    let weight_N_per_m = (metal - 1200.0) * area_m2() * GRAVITY_M_PER_S2;
    let (sine, cosine) = INCLINATION_DEG.to_radians().sin_cos();
    let (hangs_N, presses_N) =
        (weight_N_per_m * cosine * LENGTH_M, weight_N_per_m * sine * LENGTH_M);
    let at = |sliding: f64| {
        let part = sliding / stribeck;
        friction.kinetic + (friction.at_rest - friction.kinetic) / (1.0 + part * part)
    };
    let pulled = answer(&setup, Event::PickUpFromSlips, &plan, &settings, LENGTH_M).hook_load_N;
    let slackened =
        answer(&setup, Event::SlackOffFromSlips, &plan, &settings, LENGTH_M).hook_load_N;
    let inertia_N = metal * area_m2() * LENGTH_M * speed / ramp_s;
    for (name, sign, hook) in [("lifted", 1.0, pulled), ("lowered", -1.0, slackened)] {
        verify("peaks", format!("hook load at rest of a string that is then {name}, N"))
            .relative(5e-3, "friction holds the rest of the start")
            .report(hangs_N, hook.at_rest);
        verify("peaks", format!("friction of a string that is {name} at its speed, N"))
            .relative(0.025, "top and bit hold some 5 m of 300 m off the wall")
            .report(at(speed) * presses_N, sign * (hook.steady - hangs_N));
        let broke_N = sign * (hook.peak - hangs_N);
        let bound_N = friction.at_rest * presses_N;
        // The top slides already, at some mm/s, when the end breaks; the block accelerates the mass
        // that it pulls.
        let what = format!("friction that breaks where a string is {name}, N");
        verify("peaks", what)
            .relative(0.01, "the acceleration of the pulled mass, 160 N, and the clamp")
            .report(bound_N, broke_N);
        assert!(broke_N < bound_N + inertia_N, "{broke_N}");
    }
    // The steady torque without friction that falls with the speed, because a rigid drive absorbs
    // no waves: Coulomb's, climbed.
    let (kinetic, mud) = (friction.kinetic, Mud::of_density(1200.0));
    let long_m = 1000.0;
    let smooth = straight_of(0.13, long_m, INCLINATION_DEG, Friction::uniform(kinetic), mud);
    let plan = DynamicPlan { rotary_ramp_s: 5.0, watch_s: 20.0, ..plan };
    let usual = DynamicsSettings::default();
    let turned = answer(&smooth, Event::BreakRotation, &plan, &usual, long_m);
    let torque = turned.surface_torque_N_m.expect("it turns");
    let climbed_N = weight_N_per_m * sine * long_m / (1.0 + kinetic * kinetic).sqrt();
    verify("peaks", "torque of a string that has begun to turn, N·m")
        .relative(0.015, "top and bit hold some 7 m of 1000 m off the wall")
        .report(kinetic * climbed_N * 0.5 * OD_M, torque.steady);
    assert!(
        torque.at_rest.abs() < 1e-3 * torque.steady && torque.peak > torque.steady,
        "{torque:?}"
    );
}

/// `4 τ L/d` of each bore and `4 τ L/(d₂ − d₁)` of each annulus; the same as printed, `τ/(300 d)`
/// psi/ft of lbf/100 ft² and inches; and the lift on the string as the difference of two forces.
#[test]
fn a_gel_breaks() {
    const POUNDS_PER_100_FT2_PA: f64 = POUND_FORCE_N / (100.0 * 0.3048 * 0.3048);
    let gel_Pa = 25.0 * POUNDS_PER_100_FT2_PA;
    let collar = ComponentSpec::uniform("collar", 0.165, 0.0714, Metres(150.0), steel());
    let setup = straight(1000.0, 30.0, Friction::uniform(0.2), Mud::of_density(1200.0));
    let pipe = setup.string.components[0].clone();
    let setup = Setup { string: StringSpec { components: vec![collar, pipe] }, ..setup };
    let broken = gel_break(&setup.at(1000.0).expect("a model"), 1000.0, gel_Pa);
    let parts = [(150.0, 0.165, 0.0714), (850.0, OD_M, ID_M)];
    let sum =
        |term: &dyn Fn(f64, f64) -> f64| parts.iter().map(|(l, od, id)| l * term(*od, *id)).sum();
    let bore: f64 = sum(&|_, id| 4.0 * gel_Pa / id);
    let annulus: f64 = sum(&|od, _| 4.0 * gel_Pa / (HOLE_M - od));
    verify("peaks", "pressure that breaks gel in the bore, Pa")
        .relative(1e-12, "rounding")
        .report(bore, broken.bore_Pa);
    verify("peaks", "pressure that breaks gel in the annulus, Pa")
        .relative(1e-12, "rounding")
        .report(annulus, broken.annulus_Pa);
    let printed: f64 = sum(&|od, id| {
        let gap_in = (HOLE_M - od) / INCH_M;
        25.0 / 300.0 * (INCH_M / id + 1.0 / gap_in) * PSI_PA / 0.3048
    });
    verify("peaks", "pressure that breaks gel as printed, Pa")
        .relative(1e-9, "rounding")
        .report(printed, broken.pressure_Pa());
    // The gel strength acts at the walls of pipe and hole; effective tension adds the annulus's
    // gradient on the section of the pipe.
    let lift: f64 =
        sum(&|od, _| PI * od * gel_Pa + 0.25 * PI * od * od * 4.0 * gel_Pa / (HOLE_M - od));
    verify("peaks", "lift of gel on the string, N")
        .relative(1e-12, "rounding")
        .report(lift, broken.lift_N);
}

/// Pumps that start bring the pressure of the steady flow, and the gel counts where it is more.
#[test]
fn circulation_breaks() {
    const LENGTH_M: f64 = 500.0;
    let rheology = Rheology::Newtonian { viscosity_Pa_s: 0.5 };
    let mud = Mud { rheology: Some(rheology), ..Mud::of_density(1200.0) };
    let mut setup = straight(LENGTH_M, 30.0, Friction::uniform(0.2), mud);
    setup.rig.pump_pressure_limit_Pa = Some(35e6);
    let turn = Operation::rotate_off_bottom(LENGTH_M).flow_rate_m3_per_s(0.02);
    let plan = |gel_strength_Pa| DynamicPlan {
        set_points: Some(turn),
        pump_ramp_s: 2.0,
        watch_s: 4.0,
        gel_strength_Pa,
        ..DynamicPlan::default()
    };
    let at =
        |gel_Pa| answer(&setup, Event::BreakCirculation, &plan(gel_Pa), &dynamics(10.0), LENGTH_M);
    let found = at(None);
    let pump = found.pump_pressure_Pa.expect("a rheology");
    let wholestring_plan::hydraulics::HydraulicsRow { standpipe_Pa, .. } =
        wholestring_plan::hydraulics::hydraulics(&setup, &turn, &[LENGTH_M]).expect("a row")[0];
    verify("peaks", "pressure of pumps that have started, Pa")
        .relative(1e-3, "the remaining motion")
        .report(standpipe_Pa, pump.steady);
    assert!(pump.at_rest.abs() < 1e-6 * pump.steady, "{pump:?}");
    assert!(found.gel.is_none() && found.surface_torque_N_m.is_none());
    // The stream lifts the string.
    assert!(found.hook_load_N.steady < found.hook_load_N.at_rest - 100.0);
    let limit = |answer: &EventAnswer| {
        let limit = answer.limits.iter().find(|limit| limit.kind == CheckKind::PumpPressure);
        limit.and_then(|check| check.value).expect("a limit of the pump")
    };
    assert_close("limit", limit(&found), pump.peak, 1e-12);
    let strong = at(Some(1000.0));
    let gel_Pa = strong.gel.expect("a gel").pressure_Pa();
    assert!(gel_Pa > pump.peak);
    assert_close("limit", limit(&strong), gel_Pa, 1e-12);
}

/// Casing in which a string turns at one inclination: the friction work of the dynamics causes the
/// same wear as the side force over the same distance, except that a rotating string climbs, so
/// that `1/√(1 + μ²)` of the force is left.
#[test]
fn wear_by_the_work_of_friction() {
    const LENGTH_M: f64 = 500.0;
    const FRICTION: f64 = 0.2;
    let setup = straight(LENGTH_M, 60.0, Friction::uniform(FRICTION), Mud::of_density(1200.0));
    let turn = Operation::rotate_off_bottom(LENGTH_M).rotary_speed_rad_per_s(4.0 * PI);
    let campaign = CampaignSettings { off_bottom_s: 36e3, ..CampaignSettings::default() };
    let broomstick = broomstick(&setup, vec![turn], LENGTH_M).with_campaign(&campaign);
    let broomstick = broomstick.expect("casing");
    let plan =
        DynamicPlan { bit_depths_m: vec![LENGTH_M], wear: vec![turn], ..DynamicPlan::default() };
    let settings =
        DynamicsSettings { settle_s: 10.0, duration_s: 10.0, ..DynamicsSettings::default() };
    let campaign = broomstick.campaign().expect("a campaign");
    let [task] = &plan.wear_tasks(campaign)[..] else { panic!("one operation at one depth") };
    let by_work = broomstick.solve_wear(task, &plan, &settings, &|| true).expect("an answer");
    let by_work = by_work.expect("a share of the campaign");
    let points =
        broomstick.tasks().iter().flat_map(|task| broomstick.solve(task)).collect::<Vec<_>>();
    let shares = points.iter().filter_map(|point| point.outcome.as_ref().ok()?.share.clone());
    let [by_force] = &shares.collect::<Vec<_>>()[..] else { panic!("one share") };
    let worn = |share: &Share| -> f64 {
        let rows = campaign.casings(share);
        // The supports at the top and the end of the string differ.
        let inner = rows.iter().filter(|row| (50.0..LENGTH_M - 50.0).contains(&row.md_m));
        inner.map(|row| row.worn_m3_per_m).sum()
    };
    verify("peaks", "casing worn by the dynamics' work over that by the side force")
        .relative(1e-3, "the rolling left after ten seconds; 5e-5 found")
        .report(1.0 / (1.0 + FRICTION * FRICTION).sqrt(), worn(&by_work) / worn(by_force));
}

/// A run that is stopped has no result, and no wrong one.
#[test]
fn what_is_stopped_has_no_answer() {
    let setup = straight(300.0, 0.0, Friction::uniform(0.2), Mud::of_density(1200.0));
    let plan =
        DynamicPlan { set_points: Some(Operation::trip_out(300.0)), ..DynamicPlan::default() };
    let event = Event::PickUpFromSlips;
    let task = EventTask { event, friction: FrictionLevel::Expected, bit_depth_m: 300.0 };
    let broomstick = broomstick(&setup, Vec::new(), 300.0);
    assert!(matches!(broomstick.solve_event(&task, &plan, &dynamics(10.0), &|| false), Ok(None)));
    let nothing = DynamicPlan::default();
    assert!(broomstick.solve_event(&task, &nothing, &dynamics(10.0), &|| true).is_err());
}
