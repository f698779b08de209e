//! Against closed forms, an integration of its own and the soft string.

use std::f64::consts::PI;

use wholestring::{
    mud::{Annulus, FluidInterval, Fluids, Rheology},
    prelude::*,
    statics::{buckling::Criterion, soft::soft_string},
    string::{ComponentLength::Metres, ComponentSpec},
};

use super::*;
use crate::Setup;

const LENGTH_M: f64 = 1000.0;
const SHOE_M: f64 = 800.0;
const OD_M: f64 = 0.127;
const ID_M: f64 = 0.108;
const HOLE_M: f64 = 0.2159;
const DENSITY: f64 = 1200.0;

/// Plain pipe in a vertical hole as wide as its casing.
fn plain(rheology: Option<Rheology>) -> Setup {
    let stations =
        [Station::from_degrees(0.0, 0.0, 0.0), Station::from_degrees(LENGTH_M, 0.0, 0.0)];
    let hole = vec![
        HoleSection::casing(0.0..SHOE_M, HOLE_M, 0.2),
        HoleSection::open(SHOE_M..LENGTH_M, HOLE_M, 0.3),
    ];
    let pipe = ComponentSpec::uniform("pipe", OD_M, ID_M, Metres(LENGTH_M), Material::STEEL);
    Setup {
        well: Well::new(
            Path::minimum_curvature(&stations).expect("a path"),
            Hole::new(hole).expect("a hole"),
        ),
        string: StringSpec { components: vec![pipe] },
        mud: Mud { rheology, ..Mud::of_density(DENSITY) },
        fluids: Default::default(),
        rig: Rig::default(),
        ends: Default::default(),
        buckling: Criterion::default(),
    }
}

/// A viscosity at which no flow is turbulent.
const THICK: f64 = 2.0;

fn newtonian() -> Option<Rheology> {
    Some(Rheology::Newtonian { viscosity_Pa_s: THICK })
}

fn at(setup: &Setup, operation: &Operation, bit_depth_m: f64) -> HydraulicsRow {
    hydraulics(setup, operation, &[bit_depth_m]).expect("a row")[0]
}

fn trip(speed_m_per_s: f64) -> Operation {
    Operation { trip_speed_m_per_s: speed_m_per_s, ..Operation::trip_in(LENGTH_M) }
}

/// Returns the friction above a vertical depth, Pa, from an equivalent density.
fn friction_Pa(density: f64, depth_m: f64) -> f64 {
    (density - DENSITY) * GRAVITY_M_PER_S2 * depth_m
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    assert!(error <= tolerance, "{what}: {found} for {expected}, {error:.1e}");
}

/// `S ln(R/a) − D`, `D` and `ln(R/a)` of the annulus.
fn shape() -> (f64, f64, f64) {
    let (a, r) = (0.5 * OD_M, 0.5 * HOLE_M);
    let (sum, gap, log) = (r * r + a * a, r * r - a * a, (r / a).ln());
    (sum * log - gap, gap, log)
}

/// A closed pipe that moves axially in a Newtonian mud: `G = 4μv/((R² + a²) ln(R/a) − (R² − a²))`,
/// from Navier and Stokes with the pipe's wall at `v` and the displaced mud flowing up. To
/// rounding; at the shoe by its share of the length, and of swab the same with the other sign.
#[test]
fn a_closed_pipe_in_a_newtonian_mud() {
    let speed = 0.4;
    let row = at(&plain(newtonian()), &trip(speed), LENGTH_M);
    let gradient = 4.0 * THICK * speed / shape().0;
    let [closed, _] = row.surge;
    close("bit", friction_Pa(closed.bit_kg_per_m3, LENGTH_M), gradient * LENGTH_M, 1e-10);
    let at_shoe = closed.shoe_kg_per_m3.expect("a shoe");
    close("shoe", friction_Pa(at_shoe, SHOE_M), gradient * SHOE_M, 1e-10);
    let [swabbed, _] = row.swab;
    close("swab", friction_Pa(swabbed.bit_kg_per_m3, LENGTH_M), -gradient * LENGTH_M, 1e-10);
}

/// With the bit above the shoe the pressure at the bit is transmitted down: the same pressure,
/// deeper.
#[test]
fn a_shoe_below_the_bit_feels_the_bit() {
    let row = at(&plain(newtonian()), &trip(0.4), 500.0);
    let [closed, _] = row.surge;
    let at_shoe = friction_Pa(closed.shoe_kg_per_m3.expect("a shoe"), SHOE_M);
    close("shoe", at_shoe, friction_Pa(closed.bit_kg_per_m3, 500.0), 1e-10);
}

/// Burkhardt's clinging constant (1961) for laminar flow, `κ = (α² − 2α² ln α − 1)/(2(1 − α²) ln
/// α)` with `α = a/R`: the pressure of the moving pipe is that of a pipe at rest past which mud
/// flows at `v (α²/(1 − α²) + κ)`. To rounding.
#[test]
fn the_clinging_constant_is_burkhardts() {
    let (speed, alpha) = (0.4, OD_M / HOLE_M);
    let square = alpha * alpha;
    let clinging = (square - 2.0 * square * alpha.ln() - 1.0) / (2.0 * (1.0 - square) * alpha.ln());
    assert!((0.35..0.5).contains(&clinging), "{clinging}");
    let setup = plain(newtonian());
    let area = PI / 4.0 * (HOLE_M.powi(2) - OD_M.powi(2));
    let flow_m3_per_s = area * speed * (square / (1.0 - square) + clinging);
    let at_rest = Motion { flow_m3_per_s, ..Motion::default() };
    let gradient = Annulus::new(OD_M, HOLE_M).drag(&setup.mud, &at_rest).gradient_Pa_per_m;
    let [closed, _] = at(&setup, &trip(speed), LENGTH_M).surge;
    close("bit", friction_Pa(closed.bit_kg_per_m3, LENGTH_M), gradient * LENGTH_M, 1e-10);
}

/// An open pipe in a Newtonian mud: with `q` up its bore the annulus has
/// `4μv/N − 8μq ln(R/a)/(πND)` and the bore `8μq/(πb⁴)`, which are equal. 1e-9: the search for `q`.
#[test]
fn an_open_pipe_in_a_newtonian_mud() {
    let speed = 0.4;
    let row = at(&plain(newtonian()), &trip(speed), LENGTH_M);
    let (narrow, gap, log) = shape();
    let bore = 8.0 * THICK / (PI * (0.5 * ID_M).powi(4));
    let annulus = 8.0 * THICK * log / (PI * narrow * gap);
    let flow = 4.0 * THICK * speed / narrow / (annulus + bore);
    let [_, open] = row.surge;
    close("bit", friction_Pa(open.bit_kg_per_m3, LENGTH_M), bore * flow * LENGTH_M, 1e-9);
    let [_, swabbed] = row.swab;
    close("swab", friction_Pa(swabbed.bit_kg_per_m3, LENGTH_M), -bore * flow * LENGTH_M, 1e-9);
    assert!(row.surge[1].bit_kg_per_m3 < row.surge[0].bit_kg_per_m3);
}

/// Nozzles that pass hardly any mud make an open string a closed one.
#[test]
fn small_nozzles_close_the_string() {
    let setup = plain(newtonian());
    let operation = Operation { flow_rate_m3_per_s: 1e-3, bit_pressure_drop_Pa: 1e15, ..trip(0.4) };
    let [closed, open] = at(&setup, &operation, LENGTH_M).surge;
    let [closed, open] = [closed, open].map(|density| friction_Pa(density.bit_kg_per_m3, LENGTH_M));
    close("nozzles", open, closed, 1e-4);
}

/// Mid-points in each of the two ways across the gap of the integration below.
const POINTS: usize = 4000;

/// Velocity of the wall of a pipe towards the bit, m/s, and flow up the annulus over `2π`, m³/s,
/// that a power law has under `τ = G r/2 + B/r`: integrated by the mid-point rule.
fn flow_under(gradient: f64, b: f64, consistency: f64, index: f64) -> (f64, f64) {
    let (a, r) = (0.5 * OD_M, 0.5 * HOLE_M);
    let step = (r - a) / POINTS as f64;
    // Up the hole from the hole's wall inwards: `u(r) = −∫ u' dr`.
    let (mut speed, mut flow) = (0.0, 0.0);
    for i in (0..POINTS).rev() {
        let at = a + (i as f64 + 0.5) * step;
        let stress = 0.5 * gradient * at + b / at;
        // Pressure that falls upwards drives mud up: `τ = −μ u'` for an upward speed `u`.
        let slope = -stress.signum() * (stress.abs() / consistency).powf(1.0 / index);
        let middle = speed - 0.5 * slope * step;
        flow += middle * at * step;
        speed -= slope * step;
    }
    (-speed, flow)
}

/// A closed pipe in a power law: the gradient for which an integration across the gap, shot from
/// the hole's wall, gives the pipe's speed and the displaced volume. 2e-7: the mid-point rule's
/// error falls by four from 2000 points (2.8e-7) to 4000 (7e-8).
#[test]
fn a_closed_pipe_in_a_power_law() {
    let (consistency, index, speed) = (0.9, 0.55, 0.4);
    let rheology = Rheology::PowerLaw { consistency_Pa_s_n: consistency, flow_index: index };
    // Without weight it is never turbulent.
    let mut setup = plain(Some(rheology));
    setup.mud.density_kg_per_m3 = 1e-6;
    let [closed, _] = at(&setup, &trip(speed), LENGTH_M).surge;
    let found = (closed.bit_kg_per_m3 - 1e-6) * GRAVITY_M_PER_S2;
    let displaced = 0.5 * (0.5 * OD_M).powi(2) * speed;
    // For each gradient the `B` that gives the pipe its speed; then the gradient for the flow.
    let b_at = |gradient: f64| {
        let (mut low, mut high) = (-gradient, gradient);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            let (pipe, _) = flow_under(gradient, middle, consistency, index);
            if pipe > speed { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    let (mut low, mut high) = (1.0, 1e4);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        let (_, flow) = flow_under(middle, b_at(middle), consistency, index);
        if flow < displaced { low = middle } else { high = middle }
    }
    close("gradient", found, 0.5 * (low + high), 2e-7);
}

/// The pressures of circulation equal those of the soft string, which computes them in another way;
/// rotation thins a power law in both.
#[test]
fn circulation_is_the_soft_strings() {
    let rheology = Rheology::PowerLaw { consistency_Pa_s_n: 0.9, flow_index: 0.55 };
    let mut setup = plain(Some(rheology));
    let collar = ComponentSpec::uniform("collar", 0.165, 0.0714, Metres(90.0), Material::STEEL);
    setup.string.components.insert(0, collar);
    let drill = Operation {
        flow_rate_m3_per_s: 0.03,
        bit_pressure_drop_Pa: 4e6,
        motor_pressure_drop_Pa: 1e6,
        bit_torque_N_m: 3e3,
        weight_on_bit_N: 5e4,
        rate_of_penetration_m_per_s: 5e-3,
        rotary_speed_rad_per_s: 12.0,
        ..Operation::drill(LENGTH_M)
    };
    for depth_m in [300.0, LENGTH_M] {
        let row = at(&setup, &drill, depth_m);
        let operation = Operation { bit_depth_m: depth_m, ..drill };
        let model = setup.at(depth_m).expect("a model");
        let soft = soft_string(&model, &operation).expect("an answer");
        let expected = soft.hydraulics.expect("a mud that flows");
        close("standpipe", row.standpipe_Pa, expected.pump_pressure_Pa, 1e-10);
        close("annulus", row.annulus_loss_Pa, expected.annulus_loss_Pa, 1e-10);
        let at_bit = friction_Pa(row.circulating.bit_kg_per_m3, depth_m);
        close("at the bit", at_bit, expected.annulus_loss_Pa, 1e-8);
    }
    // Rotation thins the mud where the flow is slow enough not to thin it by itself.
    let slow = Operation { flow_rate_m3_per_s: 5e-3, ..drill };
    let still = Operation { rotary_speed_rad_per_s: 1e-9, ..slow };
    let [turning, still] =
        [slow, still].map(|operation| at(&setup, &operation, LENGTH_M).annulus_loss_Pa);
    assert!(turning < 0.9 * still, "{turning} {still}");
}

#[test]
fn what_has_no_answer_says_so() {
    let error = hydraulics(&plain(None), &trip(0.4), &[500.0]).unwrap_err();
    assert_eq!(error, HydraulicsError::NoRheology);
    let setup = plain(newtonian());
    assert!(matches!(hydraulics(&setup, &trip(0.4), &[-1.0]), Err(HydraulicsError::Assembly(_))));
    assert_eq!(casing_shoe_m(&setup.well.hole), Some(SHOE_M));
    // A string at rest adds no pressure.
    let row = at(&setup, &trip(0.0), LENGTH_M);
    for density in [row.surge, row.swab].concat() {
        assert!((density.bit_kg_per_m3 - DENSITY).abs() < 1e-9);
    }
}

/// Cement below mud in the annulus: at rest the equivalent density is that of the weights above, and
/// a closed pipe that moves adds each fluid's own friction over its length.
#[test]
fn each_fluid_weighs_and_flows_by_itself() {
    const TOP_M: f64 = 600.0;
    const CEMENT: f64 = 1900.0;
    let thicker = Rheology::Newtonian { viscosity_Pa_s: 2.0 * THICK };
    let cement = FluidInterval {
        rheology: Some(thicker),
        ..FluidInterval::of_density(TOP_M, LENGTH_M, CEMENT)
    };
    let fluids = Fluids { annulus: vec![cement], ..Fluids::default() };
    let setup = Setup { fluids, ..plain(newtonian()) };
    let speed = 0.4;
    let row = at(&setup, &trip(speed), LENGTH_M);
    let gradient = 4.0 * THICK * speed / shape().0;
    let weight = |to_m: f64| GRAVITY_M_PER_S2 * (DENSITY * TOP_M + CEMENT * (to_m - TOP_M));
    let surge = |to_m: f64| gradient * (TOP_M + 2.0 * (to_m - TOP_M));
    let equivalent = |to_m: f64, surge_Pa: f64| (weight(to_m) + surge_Pa) / GRAVITY_M_PER_S2 / to_m;
    let [closed, _] = row.surge;
    close("bit", closed.bit_kg_per_m3, equivalent(LENGTH_M, surge(LENGTH_M)), 1e-10);
    let at_shoe = closed.shoe_kg_per_m3.expect("a shoe");
    close("shoe", at_shoe, equivalent(SHOE_M, surge(SHOE_M)), 1e-10);
    let still = at(&setup, &Operation::slide(LENGTH_M), LENGTH_M).circulating;
    close("at rest", still.bit_kg_per_m3, equivalent(LENGTH_M, 0.0), 1e-12);
}
