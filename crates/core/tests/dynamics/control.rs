//! The three ways in which the hoist is controlled, on a string whose answer is known in closed
//! form.

use wholestring::{
    dynamics::{Autodriller, BitLaw, HoistControl, RodDamping},
    operation::OperationKind,
};

use crate::{
    common::{assert_close, operation},
    wells::{Case, between, go, line, mean_between, straight},
};

const LENGTH_M: f64 = 1000.0;
const WEIGHT_N: f64 = 20e3;
const RATE_M_PER_S: f64 = 5.0 / 3600.0;

/// Drilling with 20 kN at 5 m/h in a straight hole without friction: only the string's stretch is
/// between the block and the rock.
fn drilling() -> Case {
    let drill = operation(OperationKind::Drill, LENGTH_M)
        .weight_on_bit_N(WEIGHT_N)
        .rate_of_penetration_m_per_s(RATE_M_PER_S);
    let mut case = Case::new(straight(LENGTH_M, 0.0), drill);
    case.settings.damping = RodDamping { mass_per_s: 0.0, ..case.settings.damping };
    case
}

/// Stiffness between block and rock front, N/m: pipe, hoist line and rock in series.
fn stiffness_N_per_m(case: &Case) -> f64 {
    let pipe: f64 =
        case.model.string.components().iter().map(|c| c.length_m / c.axial_stiffness_N()).sum();
    let line = 1.0 / case.settings.hoist_line.stiffness_N_per_m;
    let BitLaw::Rate(law) = case.settings.bit.law else { panic!("the rate law is the default") };
    let rock = 1.0 / law.rock_stiffness_N_per_m;
    1.0 / (pipe + line + rock)
}

/// With the block stopped, the bit drills off: the string stretches as the front advances at
/// `v = v₀ W/W₀`, so `dW/dt = −k v₀ W/W₀` and the weight decays with the time constant `W₀/(k v₀)`.
///
/// `k` is that of pipe, line and rock in series. Within 0.2 %: the string follows the bit as a
/// spring without mass up to `(L/c)²/τ²` = 1e-4, `L/c` = 0.19 s the travel of an axial wave, τ = 18
/// s; the rest is its ringing after the stop.
#[test]
fn a_stopped_block_drills_off() {
    let case = drilling();
    let mut simulation = case.start();
    go(&mut simulation, 10.0);
    simulation.set_hoist(HoistControl::BlockVelocity(0.0));
    go(&mut simulation, 30.0);
    let series = simulation.outcome().series;
    let time = between(&series.time_s, &series.time_s, 12.0, 40.0);
    let weight = between(&series.time_s, &series.weight_on_bit_N, 12.0, 40.0);
    let logarithm: Vec<f64> = weight.iter().map(|w| w.ln()).collect();
    let found = -1.0 / line(&time, &logarithm).0;
    let expected = WEIGHT_N / (stiffness_N_per_m(&case) * RATE_M_PER_S);
    assert_close("time constant of the drill-off", found, expected, 2e-3);
    assert!(weight[weight.len() - 1] < 0.2 * WEIGHT_N);
}

/// Under a constant hook load the bit carries the rest of the weight: 5 kN more above are 5 kN less
/// below. Without friction that is a balance of forces. The string rings on its bit after the
/// change, damped by 0.1/s and by the rock's own rate; after 40 s less than 1 % of the 5 kN is left
/// of it, and less than 20 N (0.1 % of the weight on bit) in a mean over 5 s.
#[test]
fn a_constant_hook_load_sets_the_weight_on_bit() {
    let mut case = drilling();
    case.settings.damping.mass_per_s = 0.1;
    let mut simulation = case.start();
    go(&mut simulation, 10.0);
    let series = simulation.outcome().series;
    let hook = mean_between(&series.time_s, &series.hook_load_N, 8.0, 10.0);
    let weight = mean_between(&series.time_s, &series.weight_on_bit_N, 8.0, 10.0);
    simulation.set_hoist(HoistControl::HookLoad(hook));
    go(&mut simulation, 15.0);
    simulation.set_hoist(HoistControl::HookLoad(hook + 5e3));
    go(&mut simulation, 45.0);
    let series = simulation.outcome().series;
    let mean_between = |from, to| mean_between(&series.time_s, &series.weight_on_bit_N, from, to);
    let (same, less) = (mean_between(20.0, 25.0), mean_between(65.0, 70.0));
    assert!((same - weight).abs() < 20.0, "{same} N for {weight} N at the same hook load");
    assert!((weight - less - 5e3).abs() < 20.0, "{less} N for {weight} N less 5 kN");
}

/// The autodriller brings a bit that has too little weight back to its target, at the rate of the
/// slower root of `(s + k v₀/W₀)(1 + τ s) + k g = 0`: the drill-off of a stopped block, closed by a
/// gain `g` on a weight that is filtered over `τ`.
///
/// Within 0.5 %: as above, and the faster root is down to `e⁻⁶` of the slower one where the fit
/// begins.
#[test]
fn the_autodriller_recovers_its_weight() {
    let case = drilling();
    let mut simulation = case.start();
    go(&mut simulation, 10.0);
    let series = simulation.outcome().series;
    let hook = mean_between(&series.time_s, &series.hook_load_N, 8.0, 10.0);
    simulation.set_hoist(HoistControl::HookLoad(hook + 5e3));
    go(&mut simulation, 20.0);
    simulation.set_hoist(HoistControl::Autodriller);
    go(&mut simulation, 60.0);
    let series = simulation.outcome().series;
    let time = between(&series.time_s, &series.time_s, 38.0, 52.0);
    let missing: Vec<f64> = between(&series.time_s, &series.weight_on_bit_N, 38.0, 52.0)
        .iter()
        .map(|w| (WEIGHT_N - w).ln())
        .collect();
    let found = -line(&time, &missing).0;
    let Autodriller { gain_m_per_s_per_N: gain, filter_s: tau, .. } = case.settings.autodriller;
    let k = stiffness_N_per_m(&case);
    let open = k * RATE_M_PER_S / WEIGHT_N;
    // τ s² + (1 + open τ) s + open + k g = 0.
    let (b, c) = (1.0 + open * tau, open + k * gain);
    let expected = (b - (b * b - 4.0 * tau * c).sqrt()) / (2.0 * tau);
    assert_close("rate of recovery", found, expected, 5e-3);
    let end = mean_between(&series.time_s, &series.weight_on_bit_N, 80.0, 90.0);
    assert_close("weight on bit in the end", end, WEIGHT_N, 1e-3);
}
