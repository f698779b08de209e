//! A mud that flows, against the soft string and closed forms.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use wholestring::{
    GRAVITY_M_PER_S2,
    dynamics::{HoistControl, Motor, MudMotor, ScheduleStep},
    mud::{FluidInterval, Fluids, Rheology},
    prelude::*,
    string::REFERENCE_TEMPERATURE_K,
    well::Interpolation,
};

use crate::{
    common::{assert_close, mud_with_drag, operation, path, rpm},
    wells::{Case, each, go, mean_between, model, tool},
};

const LENGTH_M: f64 = 1000.0;
const OD_M: f64 = 0.127;
const ID_M: f64 = 0.1086;
const HOLE_M: f64 = 0.2159;

const BINGHAM: Rheology = Rheology::Bingham { plastic_viscosity_Pa_s: 0.025, yield_point_Pa: 7.2 };
const POWER_LAW: Rheology = Rheology::PowerLaw { consistency_Pa_s_n: 0.6, flow_index: 0.6 };

/// Plain pipe in a straight, frictionless hole.
fn case(kind: OperationKind, mud: Mud) -> Case {
    let stations = [[0.0, 20.0, 0.0], [LENGTH_M, 20.0, 0.0]];
    let mut model = model(
        path(&stations, Interpolation::Spline),
        vec![HoleSection::open(0.0..(LENGTH_M + 20.0), HOLE_M, 0.0)],
        vec![tool("pipe", ComponentLength::ToSurface, OD_M, ID_M)],
        LENGTH_M,
    );
    model.mud = mud;
    let operation = operation(kind, LENGTH_M)
        .rotary_speed_rad_per_s(rpm(100.0))
        .weight_on_bit_N(20e3)
        .bit_torque_N_m(1000.0)
        .rate_of_penetration_m_per_s(20.0 / 3600.0)
        .trip_speed_m_per_s(0.5)
        .flow_rate_m3_per_s(0.03)
        .bit_pressure_drop_Pa(8e6)
        .motor_pressure_drop_Pa(0.0);
    let mut case = Case::new(model, operation);
    case.lasts(20.0, 5.0);
    case
}

fn heavy(rheology: Rheology) -> Mud {
    Mud { rheology: Some(rheology), ..mud_with_drag() }
}

/// A motor that takes 4.19 MPa for the bit's 1000 N·m, `2π T/(η V)`.
const MOTOR: MudMotor = MudMotor {
    displacement_m3: 2e-3,
    rated_flow_m3_per_s: 0.03,
    max_pressure_Pa: 8e6,
    slip: 0.1,
    efficiency: 0.75,
    stall_torque_N_m: 3e3,
};

/// Drilling with a motor above the bit.
fn with_a_motor(mut case: Case) -> Case {
    let bit = &mut case.settings.bit;
    bit.motor = Motor::Displacement(MOTOR);
    case.operation = bit.drilling_steadily(case.operation);
    case
}

/// Rotating at constant speed in a weightless Newtonian mud, the string needs Couette's torque,
/// `4πμ a²R²Ω L/(R² − a²)`.
///
/// The difference is the remainder of the start after 20 s of rotation; the tolerance is 1e-4.
#[test]
fn a_rotating_string_needs_couettes_torque() {
    let viscosity = 0.5;
    let mut case = case(
        OperationKind::RotateOffBottom,
        Mud { density_kg_per_m3: 0.0, ..heavy(Rheology::Newtonian { viscosity_Pa_s: viscosity }) },
    );
    case.operation.flow_rate_m3_per_s = 0.0;
    let outcome = case.run();
    let (a2, r2) = (0.25 * OD_M * OD_M, 0.25 * HOLE_M * HOLE_M);
    let per_m = 4.0 * std::f64::consts::PI * viscosity * a2 * r2 / (r2 - a2) * rpm(100.0);
    let soft = case.soft();
    assert_close("soft", soft.scalars.surface_torque_N_m, per_m * LENGTH_M, 1e-12);
    let torque = outcome.scalars.surface_torque_N_m;
    assert_close("dynamic", torque, per_m * LENGTH_M, 1e-4);
    let mud = outcome.hydraulics.expect("the mud has a rheology");
    assert_close("mud torque", mud.mud_torque_N_m, per_m * LENGTH_M, 1e-4);
    assert!(soft.scalars.friction_torque_N_m.abs() < 1e-9);
}

/// Hook load, torque, stretch and pressures of the dynamics are the soft string's, for tripping,
/// circulating, rotating and drilling, in a Bingham and a power-law mud.
///
/// Both take the mud's forces from the same annulus, the dynamics with each element's own motion,
/// recomputed when it has changed by 1 %. Without friction the difference is the remainder of the
/// start: 0.1 % of the mud's part of hook load and stretch, of all torque and of the pressure is
/// allowed. The energy balance closes to 1e-5.
#[test]
fn dynamics_and_soft_string_agree_in_a_mud_that_flows() {
    use OperationKind::*;
    let cases: Vec<Case> = [BINGHAM, POWER_LAW]
        .into_iter()
        .flat_map(|rheology| {
            [TripOut, TripIn, RotateOffBottom, BackReam, Drill]
                .map(|kind| case(kind, heavy(rheology)))
        })
        .chain([with_a_motor(case(Drill, heavy(BINGHAM)))])
        .collect();
    let outcomes = each(&cases, |case| {
        let mut dry = case.clone();
        dry.model.mud.rheology = None;
        (case.soft(), dry.soft(), case.run())
    });
    for (case, (soft, dry, dynamic)) in cases.iter().zip(&outcomes) {
        let name = format!("{:?} {:?}", case.operation.kind, case.model.mud.rheology);
        let (s, d, none) = (&soft.scalars, &dynamic.scalars, &dry.scalars);
        let mud = soft.hydraulics.expect("the mud has a rheology");
        let found = dynamic.hydraulics.expect("the mud has a rheology");
        assert_close(
            &format!("{name}: hook load by the mud"),
            d.hook_load_N - none.hook_load_N,
            s.hook_load_N - none.hook_load_N,
            1e-3,
        );
        assert_close(
            &format!("{name}: stretch by the mud"),
            d.stretch_m - none.stretch_m,
            s.stretch_m - none.stretch_m,
            1e-3,
        );
        assert_close(&name, found.mud_drag_N, mud.mud_drag_N, 1e-3);
        if case.operation.kind.rotates() {
            let (found, wanted) =
                (d.surface_torque_N_m - d.bit_torque_N_m, s.surface_torque_N_m - s.bit_torque_N_m);
            let allowed = 1e-3 * s.surface_torque_N_m;
            assert!((found - wanted).abs() < allowed, "{name}: torque {found} for {wanted}");
        }
        let motor_Pa = match case.settings.bit.motor {
            Motor::Speed(_) => 0.0,
            Motor::Displacement(_) => TAU * 1000.0 / (0.75 * 2e-3),
        };
        for (model, hydraulics) in [("soft", mud), ("dynamic", found)] {
            assert!(
                (hydraulics.motor_loss_Pa - motor_Pa).abs() <= 1e-3 * motor_Pa,
                "{name}, {model}: {hydraulics:?}"
            );
        }
        if mud.pump_pressure_Pa.abs() > 0.0 {
            let losses = mud.bore_loss_Pa + mud.bit_loss_Pa + motor_Pa + mud.annulus_loss_Pa;
            assert_close(&name, mud.pump_pressure_Pa, losses, 1e-12);
            assert_close(&name, found.pump_pressure_Pa, mud.pump_pressure_Pa, 1e-3);
        }
        assert!(dynamic.numerics.energy_residual.abs() < 1e-5, "{name}: {:?}", dynamic.numerics);
    }
}

/// When the pumps start the string becomes lighter by the soft string's amount: the stream lifts
/// it, the bit's jets push it up. The work of both is booked, and the energy balance closes.
#[test]
fn the_pumps_lift_the_string() {
    let mut on = case(OperationKind::RotateOffBottom, heavy(BINGHAM));
    on.lasts(5.0, 60.0);
    on.settings.hoist_control = Some(HoistControl::BlockVelocity(0.0));
    let mut off = on.clone();
    off.operation.flow_rate_m3_per_s = 0.0;
    let expected = on.soft().scalars.hook_load_N - off.soft().scalars.hook_load_N;
    let mut simulation = on.start();
    simulation.set_flow_rate(0.0);
    go(&mut simulation, 30.0);
    simulation.set_flow_rate(on.operation.flow_rate_m3_per_s);
    go(&mut simulation, 35.0);
    let outcome = simulation.outcome();
    let series = &outcome.series;
    let hook = |from, to| mean_between(&series.time_s, &series.hook_load_N, from, to);
    let found = hook(55.0, 65.0) - hook(20.0, 30.0);
    assert!(expected < -1000.0, "{expected}");
    assert_close("lift", found, expected, 1e-3);
    let energy = outcome.numerics.energy.expect("the window has begun");
    assert!(energy.flow_work_J > 0.0, "{energy:?}");
    assert!(outcome.numerics.energy_residual.abs() < 1e-5, "{energy:?}");
}

/// Pumps that start by the plan, and the loads of the metal when they run: its own weight, the
/// pressures on its ends and the shear of the mud on its walls, none of which is an effective
/// tension. In a Newtonian mud all of them have closed forms (Hagen and Poiseuille; Bird, Stewart
/// and Lightfoot, *Transport Phenomena*, for the annulus).
///
/// The tolerance is 1e-8 of the pressure (1e-10 found, from remaining oscillation), and 9 N of the
/// tension, where the momentum of the mud in the bore is 117 N: the string is 0.15 m longer than
/// without load, which is 5.5 N of pressure, and the swinging leaves 2 N.
#[test]
fn the_metal_feels_the_pressures_of_a_mud_that_flows() {
    let (viscosity, flow, bit_loss) = (0.6, 0.03, 8e6);
    let mut case = case(
        OperationKind::RotateOffBottom,
        heavy(Rheology::Newtonian { viscosity_Pa_s: viscosity }),
    );
    let pumps = |at_s, ramp_s, flow| ScheduleStep {
        at_s,
        ramp_s,
        flow_rate_m3_per_s: Some(flow),
        ..ScheduleStep::default()
    };
    case.settings.schedule.steps = vec![pumps(0.0, 0.0, 0.0), pumps(2.0, 8.0, flow)];
    let from_top_m: Vec<f64> =
        case.start().mesh().nodes.iter().map(|node| LENGTH_M - node.from_bit_m).collect();
    let outcome = case.run();
    let nodes = &outcome.nodes;

    let bore = FRAC_PI_4 * ID_M * ID_M;
    let body = FRAC_PI_4 * OD_M * OD_M;
    let area = body - bore;
    let density = case.model.mud.density_kg_per_m3;
    let falls = 20f64.to_radians().cos();
    let at_rest = density * GRAVITY_M_PER_S2 * falls;
    let in_bore = 128.0 * viscosity * flow / (PI * ID_M.powi(4));
    let (hole, part) = (0.5 * HOLE_M, OD_M / HOLE_M);
    let neutral = (1.0 - part * part) / (2.0 * (1.0 / part).ln());
    let in_annulus = 8.0 * viscosity * flow
        / (PI * hole.powi(4) * (1.0 - part * part) * (1.0 + part * part - 2.0 * neutral));
    let outside = |md: f64| in_annulus * md;
    let inside = |md: f64| in_annulus * LENGTH_M + bit_loss + in_bore * (LENGTH_M - md);
    for (i, md_m) in from_top_m.iter().enumerate() {
        let close = |what: &str, found: f64, expected: f64| {
            // The string is a little longer than without load: its top is above the surface.
            let found = found - at_rest * nodes.md_m[i].max(0.0);
            let off = (found - expected).abs() / inside(0.0);
            assert!(off < 1e-8, "{what} at {md_m}: {found} for {expected} Pa");
        };
        close("outside", nodes.outside_pressure_Pa[i], outside(*md_m));
        close("inside", nodes.inside_pressure_Pa[i], inside(*md_m));
    }

    // On the metal below a depth: its weight, the pressures on the bit less the thrust of the mud
    // that leaves it faster than it enters, the stream's shear on the bore, downwards, and on the
    // outside, upwards.
    let steel = case.model.string.components()[0].mass_per_length_kg_per_m;
    let jets = density * flow * ((2.0 * bit_loss / density).sqrt() - flow / bore);
    let end = inside(LENGTH_M) * bore - outside(LENGTH_M) * body - at_rest * LENGTH_M * area - jets;
    let rubbed = PI * in_annulus * hole * hole * (neutral - part * part);
    let shear = in_bore * bore - rubbed;
    let metal = |md: f64| end + (LENGTH_M - md) * (steel * GRAVITY_M_PER_S2 * falls + shear);
    let ends_neighbours = [1, from_top_m.len() - 2];
    for (i, md_m) in from_top_m.iter().enumerate() {
        // They have the mud's pull on half an element too much, which is the ends'.
        if ends_neighbours.contains(&i) {
            continue;
        }
        let (found, expected) = (nodes.true_tension_N[i], metal(*md_m));
        assert!((found - expected).abs() < 9.0, "true tension at {md_m}: {found} for {expected} N");
    }

    let series = &outcome.series;
    for (i, &time) in series.time_s.iter().enumerate() {
        let plan = flow * ((time - 2.0) / 8.0).clamp(0.0, 1.0);
        // A sample reports the step before it.
        let step = outcome.numerics.time_step_s / 8.0 * flow;
        let set = series.flow_rate_m3_per_s[i];
        assert!((set - plan).abs() <= 1.01 * step, "{set} for {plan}");
        let pump = series.pump_pressure_Pa[i].expect("the mud has a rheology");
        if time < 2.0 {
            assert!(pump.abs() < 1e-4 * inside(0.0), "{pump} at rest");
        } else if time > 15.0 {
            assert_close("pump pressure", pump, inside(0.0), 1e-4);
        }
    }
}

/// Air above water in a string in mud above cement: hook load, stretch, pressures and the force in
/// the metal are those of the soft string, with and without temperatures; and so of fluids that flow.
///
/// Without friction the difference is the remainder of the start, and in the element in which a
/// fluid ends half of the change of its weight is at the wrong end: 0.1 % in all.
#[test]
fn dynamics_and_soft_string_agree_in_layers_of_fluid() {
    let mut cold = case(OperationKind::RotateOffBottom, mud_with_drag());
    cold.model.fluids = Fluids {
        inside: vec![FluidInterval::air(400.0), FluidInterval::of_density(400.0, 707.0, 1000.0)],
        annulus: vec![FluidInterval::of_density(600.0, LENGTH_M, 1900.0)],
    };
    let mut warm = cold.clone();
    warm.model.fluids.annulus[0].temperatures_K = Some([350.0, 400.0]);
    // Air that flows out below a heavy fluid.
    let mut flows = case(OperationKind::RotateOffBottom, heavy(BINGHAM));
    flows.model.fluids.inside = vec![
        FluidInterval {
            rheology: Some(POWER_LAW),
            ..FluidInterval::of_density(0.0, 500.0, 1500.0)
        },
        FluidInterval::of_density(500.0, LENGTH_M, 0.0),
    ];
    let cases = [cold, warm, flows];
    let outcomes = each(&cases, |case| (case.soft(), case.run()));
    for (soft, dynamic) in &outcomes {
        let (s, d) = (&soft.scalars, &dynamic.scalars);
        assert_close("hook load", d.hook_load_N, s.hook_load_N, 1e-3);
        assert_close("stretch", d.stretch_m, s.stretch_m, 1e-3);
        let nodes = &dynamic.nodes;
        for (i, md_m) in nodes.md_m.iter().enumerate().skip(2) {
            let row = soft.md_m.partition_point(|row_m| row_m < md_m).clamp(1, soft.md_m.len() - 1);
            let part = (md_m - soft.md_m[row - 1]) / (soft.md_m[row] - soft.md_m[row - 1]);
            let at = |values: &[f64]| values[row - 1] + part * (values[row] - values[row - 1]);
            for (what, found, expected, scale) in [
                ("outside", nodes.outside_pressure_Pa[i], at(&soft.outside_pressure_Pa), 1e7),
                ("inside", nodes.inside_pressure_Pa[i], at(&soft.inside_pressure_Pa), 1e7),
                ("metal", nodes.true_tension_N[i], at(&soft.true_tension_N), s.hook_load_N),
            ] {
                let error = (found - expected).abs();
                assert!(error < 2e-3 * scale, "{what} at {md_m} m: {found} for {expected}");
            }
        }
    }
    let [cold_m, warm_m] = [0, 1].map(|index| outcomes[index].1.scalars.stretch_m);
    let steel = cases[0].model.string.components()[0].material;
    let expected_m = steel.thermal_expansion_per_K * 400.0 * (375.0 - REFERENCE_TEMPERATURE_K);
    assert_close("by temperature", warm_m - cold_m, expected_m, 1e-3);
}
