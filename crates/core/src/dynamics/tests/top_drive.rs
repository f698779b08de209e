//! The top drive under its controllers, against closed forms.

use std::f64::consts::TAU;

use super::bench::{Bench, PIPE_M, Support};
use crate::{
    dynamics::{
        boundary::top_drive::{Gains, TopDrive, TorsionalString},
        kernel::chain::{Chain, element, node},
        settings::{SpeedController, TopDriveSettings},
    },
    rod::torsion,
};

/// Small for a top drive, so that the oscillation that SoftTorque leaves decays within seconds.
const INERTIA_KG_M2: f64 = 400.0;

/// The gains of the drive of E02 and E08.
const STIFF: SpeedController =
    SpeedController::Pi { proportional_N_m_s: 38e3, integral_N_m: 100e3 };

const SOFT: SpeedController =
    SpeedController::SoftTorque { impedance_ratio: 1.0, frequency_Hz: Some(0.25) };

const MATCHED: SpeedController = SpeedController::ZTorque {
    impedance_ratio: 1.0,
    frequency_Hz: Some(0.15),
    proportional_N_m_s: 38e3,
    integral_N_m: 100e3,
};

fn driven(controller: SpeedController, torque_limit_N_m: Option<f64>) -> TopDriveSettings {
    TopDriveSettings::Driven { inertia_kg_m2: INERTIA_KG_M2, controller, torque_limit_N_m }
}

/// A complex number: real and imaginary part.
type Complex = (f64, f64);

fn times(a: Complex, b: Complex) -> Complex {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

fn over(a: Complex, b: Complex) -> Complex {
    let square = b.0 * b.0 + b.1 * b.1;
    let (x, y) = times(a, (b.0, -b.1));
    (x / square, y / square)
}

fn plus(a: Complex, b: Complex) -> Complex {
    (a.0 + b.0, a.1 + b.1)
}

fn size(a: Complex) -> f64 {
    a.0.hypot(a.1)
}

/// `|(Z_td − Z)/(Z_td + Z)|` with `Z_td = (J s + C)/(1 + C H/Z_s)`, `C = K_p + K_i/s`,
/// `H = s/(s + ω₁)`.
fn reflection(gains: &Gains, pipe: f64, omega: f64) -> f64 {
    let control = (gains.proportional_N_m_s, -gains.integral_N_m / omega);
    let stiff = plus(control, (0.0, INERTIA_KG_M2 * omega));
    let divisor = gains.shown.map_or((1.0, 0.0), |shown| {
        let pass = over((0.0, omega), (shown.corner_rad_per_s, omega));
        let feedback = times(control, pass);
        let z = shown.impedance_N_m_s;
        plus((1.0, 0.0), (feedback.0 / z, feedback.1 / z))
    });
    let drive = over(stiff, divisor);
    size(over(plus(drive, (-pipe, 0.0)), plus(drive, (pipe, 0.0))))
}

const ELEMENT_M: f64 = 25.0;
const WAVE_M_PER_S: f64 = 3178.35;

/// Reflection of a pulse at the top drive, measured at each frequency, Hz: the pipe is so long that
/// no reflection returns from its lower end. A pulse that runs up is split into its upward and
/// downward parts at an element below the top, `(Ω ∓ T/Z)/2`, by the Fourier transforms of its
/// speed and torque.
fn measured(
    controller: SpeedController,
    frequencies_Hz: &[f64],
    dt: f64,
) -> (Gains, f64, Vec<f64>) {
    let seconds = 20.0;
    let (from_m, wide_m) = (4_000.0, 800.0);
    let mut rod = Bench::new(&[(PIPE_M, 36_000.0)], ELEMENT_M, 0.0);
    rod.input.dt = dt;
    let pipe = torsion::impedance_N_m_s(&rod.mesh.elements[0].section);
    let string = TorsionalString { impedance_N_m_s: pipe, frequency_Hz: 0.25 };
    rod.support(0, Support::CLAMPED);
    let shape = |z: f64| 1e-3 * (-((z - from_m) / wide_m).powi(2)).exp();
    for i in 0..rod.chain.nodes() {
        let speed = shape(rod.z_m(i));
        node!(rod.chain, i, spin = speed);
    }
    // In a wave that runs up the strain is v/c; the twist is half a step earlier.
    for i in 0..rod.chain.elements() {
        let length = rod.mesh.elements[i].length_m;
        let at = rod.z_m(i) + 0.5 * length - 0.5 * dt * WAVE_M_PER_S;
        element!(rod.chain, i, twist = shape(at) / WAVE_M_PER_S * length);
    }
    node!(rod.chain, 0, spin = 0.0);
    let settings = driven(controller, None);
    let mut drive = TopDrive::new(&settings, string, &mut rod.chain);
    let place = 4;
    let mut sums = vec![((0.0, 0.0), (0.0, 0.0)); frequencies_Hz.len()];
    for step in 0..(seconds / dt) as usize {
        rod.step();
        drive.act(&mut rod.chain, 0.0, dt);
        let torque = -element!(rod.chain, place, torque);
        let speed = 0.5 * (node!(rod.chain, place, spin) + node!(rod.chain, place + 1, spin));
        for (sum, hz) in sums.iter_mut().zip(frequencies_Hz) {
            // Torque is that of the step's beginning, speed that of its middle.
            let turn = |later: f64| (TAU * hz * dt * (step as f64 + later)).sin_cos();
            let ((st, ct), (ss, cs)) = (turn(0.0), turn(0.5));
            sum.0 = plus(sum.0, (torque * ct, -torque * st));
            sum.1 = plus(sum.1, (speed * cs, -speed * ss));
        }
    }
    let found = sums
        .iter()
        .map(|&(torque, speed)| {
            let carried = (torque.0 / pipe, torque.1 / pipe);
            let up = plus(speed, (-carried.0, -carried.1));
            size(plus(speed, carried)) / size(up)
        })
        .collect();
    (Gains::of(controller, INERTIA_KG_M2, string), pipe, found)
}

/// Reflection of a torsional wave at the drive, at seven frequencies, for each controller. The
/// implicit step errs in proportion to its length, by 0.0017 at 1 ms where SoftTorque absorbs all,
/// and by half of that at half of it. A stiff controller reflects nearly all; SoftTorque least at
/// the frequency that it is tuned to; Z-Torque little over a band.
#[test]
fn waves_are_thrown_back_as_the_impedances_say() {
    let hz = [0.08, 0.15, 0.25, 0.35, 0.5, 0.7, 1.0];
    for (name, controller) in [("pi", STIFF), ("soft-torque", SOFT), ("z-torque", MATCHED)] {
        let (gains, pipe, coarse) = measured(controller, &hz, 1e-3);
        let (.., fine) = measured(controller, &hz, 0.5e-3);
        let exact: Vec<f64> = hz.iter().map(|f| reflection(&gains, pipe, TAU * f)).collect();
        let worst = |found: &[f64]| {
            let errors = found.iter().zip(&exact).map(|(f, e)| (f - e).abs());
            errors.fold(0.0, f64::max)
        };
        assert!(worst(&coarse) < 2e-3 && worst(&fine) < 1e-3, "{name}");
        match name {
            "pi" => assert!(exact.iter().all(|r| *r > 0.96)),
            "soft-torque" => {
                assert!(exact[2] < 1e-12);
                assert!(exact.iter().enumerate().all(|(i, r)| i == 2 || *r > 0.3));
            }
            _ => assert!(exact[4..].iter().all(|r| *r < 0.15)),
        }
    }
}

/// A drive with boundless gains follows its set point exactly: it is the constant speed.
#[test]
fn boundless_gains_are_a_constant_speed() {
    let controller = SpeedController::Pi { proportional_N_m_s: 1e15, integral_N_m: 1e15 };
    let mut rod = Bench::new(&[(PIPE_M, 500.0)], ELEMENT_M, 0.0);
    rod.support(0, Support::CLAMPED);
    let string = TorsionalString { impedance_N_m_s: 340.0, frequency_Hz: 1.6 };
    let mut drive = TopDrive::new(&driven(controller, None), string, &mut rod.chain);
    let dt = rod.input.dt;
    for i in 0..2000 {
        rod.step();
        let set = 7.0 * (f64::from(i) / 1000.0).min(1.0);
        drive.act(&mut rod.chain, set, dt);
        assert!((node!(rod.chain, 0, spin) - set).abs() < 1e-8);
    }
}

/// Two ends with a spring between; the lower one is held until released.
fn held(stiffness: f64) -> Chain {
    let mut chain = Chain::new(2);
    element!(chain, 0, torsion = stiffness);
    chain
}

/// A string that is stuck at its lower end stalls the drive: it swings about the twist that its
/// limit holds, with nothing to damp it. Let go, it comes back to its speed, and how far it
/// overshoots does not depend on how long it was stalled (ten swings or forty): the integral has
/// waited.
#[test]
fn a_stuck_string_stalls_the_drive() {
    let (limit, stiffness, dt) = (20e3, 500.0, 1e-3);
    let string = TorsionalString { impedance_N_m_s: 340.0, frequency_Hz: 0.2 };
    let swing_s = TAU * (INERTIA_KG_M2 / stiffness).sqrt();
    let overshoot = |swings: f64| {
        let mut chain = held(stiffness);
        let mut drive = TopDrive::new(&driven(STIFF, Some(limit)), string, &mut chain);
        let turn = |chain: &mut Chain, drive: &mut TopDrive, stuck: bool| {
            let spring =
                if stuck { element!(chain, 0, twist) - dt * node!(chain, 0, spin) } else { 0.0 };
            element!(chain, 0, twist = spring);
            element!(chain, 0, torque = stiffness * spring);
            drive.act(chain, 12.0, dt).string_torque_N_m
        };
        let steps = (swings * swing_s / dt).round() as usize;
        let torques: Vec<f64> = (0..steps).map(|_| turn(&mut chain, &mut drive, true)).collect();
        let end = &torques[steps - (4.0 * swing_s / dt).round() as usize..];
        let mean = end.iter().sum::<f64>() / end.len() as f64;
        assert!((mean / limit - 1.0).abs() < 2e-3, "{mean}");
        let mut fastest: f64 = 0.0;
        for _ in 0..20_000 {
            turn(&mut chain, &mut drive, false);
            fastest = fastest.max(node!(chain, 0, spin));
        }
        assert!((node!(chain, 0, spin) - 12.0).abs() < 1e-6);
        fastest - 12.0
    };
    let [short, long] = [10.0, 40.0].map(overshoot);
    assert!((short - long).abs() < 0.05, "{short} {long}");
    assert!(long < 6.0, "{long}");
}

/// The lowest frequency of a string: a quarter wave of a uniform one, the roots of
/// `Z₁ cot(ωL₁/c) = Z₂ tan(ωL₂/c)` for pipe on collars.
#[test]
fn the_lowest_frequency_is_the_closed_form() {
    let rod = Bench::new(&[(PIPE_M, 1000.0)], 10.0, 0.0);
    let found = torsion::lowest_frequency_Hz(&rod.mesh);
    assert!((found / (3178.35 / 4000.0) - 1.0).abs() < 1e-5, "{found}");
    let rod = Bench::new(&[(super::bench::COLLAR_M, 250.0), (PIPE_M, 2000.0)], 10.0, 0.0);
    let omega = TAU * torsion::lowest_frequency_Hz(&rod.mesh);
    let [collar, pipe] = [rod.mesh.elements.len() - 1, 0]
        .map(|i| torsion::impedance_N_m_s(&rod.mesh.elements[i].section));
    let c = (super::bench::STEEL.shear_modulus_Pa / super::bench::STEEL.density_kg_per_m3).sqrt();
    let balance = pipe / (omega * 2000.0 / c).tan() / (collar * (omega * 250.0 / c).tan());
    assert!((balance - 1.0).abs() < 1e-9, "{balance}");
}
