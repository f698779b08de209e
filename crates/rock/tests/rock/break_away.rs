//! Torque that turns a stationary bit, against its torque while it turns.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use wholestring_rock::{
    Alone, BitMotion, BitShape, Drilling, DrillingSpec, Driver, Inertia, Progress, Rock, Stepper,
    bit_face::PdcBit,
};

use wholestring_verification::{Tolerance, verify};

const ROTARY_RAD_PER_S: f64 = 4.0 * TAU;
const STEP_S: f64 = 0.25e-3;

/// Rotation of the bit between two stops, revolutions.
const BETWEEN: f64 = 0.7;

const WEIGHT_N: f64 = 1000.0;

/// Angle by which a bit that was stopped has broken away, rad: farther than from one element to the
/// next.
const AWAY_RAD: f64 = 0.5;

/// A bit that turns more slowly than this is taken as stationary, rad/s: a twenty-fifth of the
/// speed that it drills at.
const STANDS_RAD_PER_S: f64 = 1.0;

/// Moment of inertia of a bit that is released, kg·m².
const INERTIA_KG_M2: f64 = 0.2;

/// Time in which the torque on it grows by its mean torque, s: a hundred times that in which a wave
/// crosses the block.
const RISING_S: f64 = 0.1;

/// A bit of 60 mm on a rock of 10 MPa.
struct Standing {
    drilling: Drilling,
    weight_N: f64,
    stepper: Stepper,
}

impl Standing {
    fn new(element_m: f64, weight_N: f64) -> Self {
        let bit = BitShape::Pdc(PdcBit::for_diameter(0.06));
        let spec =
            DrillingSpec::new(Rock::for_drilling(10e6), bit, element_m).expect("a sound face");
        Self {
            drilling: Drilling::new(&spec).expect("a intact rock"),
            weight_N,
            stepper: Stepper::default(),
        }
    }

    fn mass_kg(&self) -> f64 {
        self.weight_N / 9.81
    }

    /// Drills at a constant speed.
    fn turn(&mut self, revolutions: f64) -> Progress {
        let driver = Driver::Weight {
            weight_N: self.weight_N,
            mass_kg: self.mass_kg(),
            rotary_rad_per_s: ROTARY_RAD_PER_S,
        };
        let mut progress = Progress::default();
        for _ in 0..(revolutions * TAU / ROTARY_RAD_PER_S / STEP_S) as usize {
            let advance = driver.drive(&mut self.drilling, STEP_S, &self.stepper, &Alone);
            progress.add(&self.drilling, &advance);
        }
        progress
    }

    /// Stops the bit, lets a torque on it grow from nothing, and returns that with which it broke
    /// away.
    fn break_away(&mut self, rising_N_m_per_s: f64) -> f64 {
        let mut pose = *self.drilling.pose();
        pose.angular_velocity_rad_per_s = Vector3::zeros();
        self.drilling.place(pose);
        let (mut torque_N_m, mut turned_rad, mut stood_N_m) = (0.0, 0.0, 0.0);
        while turned_rad < AWAY_RAD {
            torque_N_m += rising_N_m_per_s * STEP_S;
            let pose = self.drilling.pose();
            let motion = BitMotion {
                velocity_m_per_s: Vector3::z() * pose.velocity_m_per_s.z,
                angular_velocity_rad_per_s: pose.angular_velocity_rad_per_s,
                force_N: Vector3::z() * self.weight_N,
                moment_N_m: Vector3::z() * torque_N_m,
                inertia: Inertia {
                    mass_kg: self.mass_kg(),
                    about_axis_kg_m2: INERTIA_KG_M2,
                    ..Inertia::PRESCRIBED
                },
            };
            let advance = self.drilling.advance(STEP_S, &motion, &self.stepper, &Alone);
            turned_rad += advance.turned_rad;
            if advance.angular_velocity_rad_per_s.z < STANDS_RAD_PER_S {
                stood_N_m = torque_N_m;
            }
        }
        stood_N_m
    }
}

/// Ratio of the torque that turned it again to its torque while turning.
struct Over {
    mean: f64,
    /// Standard error of the mean.
    error: f64,
    /// Elements in the depth of cut of a revolution.
    elements: f64,
}

fn over_the_mean(element_m: f64, weight_N: f64, turns: f64, stops: usize) -> Over {
    let mut bit = Standing::new(element_m, weight_N);
    bit.turn(1.0);
    let drilled = bit.turn(turns);
    let torque_N_m = drilled.torque_N_m();
    let parts: Vec<f64> = (0..stops)
        .map(|_| {
            let away_N_m = bit.break_away(torque_N_m / RISING_S);
            bit.turn(BETWEEN);
            away_N_m / torque_N_m
        })
        .collect();
    let count = stops as f64;
    let mean = parts.iter().sum::<f64>() / count;
    let squares: f64 = parts.iter().map(|part| (part - mean).powi(2)).sum();
    let over = Over {
        mean,
        error: (squares / (count - 1.0) / count).sqrt(),
        elements: drilled.depth_of_cut_m() / element_m,
    };
    println!(
        "elements of {} mm, {weight_N} N: {:.2} elements a revolution, {torque_N_m:.1} N·m, broke away at {mean:.2} ± {:.2} of it",
        1e3 * element_m,
        over.elements,
        over.error
    );
    over
}

/// Ratio of the holding torques on coarse and on finer elements.
fn held_less(coarse_m: f64, coarse: &Over, fine_m: f64, fine: &Over) {
    verify(
        "rock",
        format!(
            "torque that turns a standing bit on elements of {} mm over that on elements of {} mm",
            1e3 * coarse_m,
            1e3 * fine_m
        ),
    )
    .at_least(
        "coarse elements hold it all at once: 2.9 and 1.9 times with six stops, each known \
             to a fifth; one if elements made no difference",
    )
    .report(1.5, coarse.mean / fine.mean);
}

#[test]
fn coarse_elements_hold_a_bit_that_stands() {
    let [coarse, fine] = [6e-3, 4e-3].map(|element_m| over_the_mean(element_m, WEIGHT_N, 2.0, 2));
    held_less(6e-3, &coarse, 4e-3, &fine);
}

/// A stationary bit needs no more than one that turns, against rock whose grain is finer than its
/// cut. Elements that are coarser than the cut of a blade hold it by more: all those in front of
/// cutters at once, where a bit that turns meets them one by one.
#[test]
#[ignore = "minutes: run by cargo xtask verify"]
fn what_holds_a_bit_that_stands_falls_with_the_elements() {
    let [coarse, middle, fine] =
        [6e-3, 4e-3, 3e-3].map(|element_m| over_the_mean(element_m, WEIGHT_N, 4.0, 6));
    held_less(6e-3, &coarse, 4e-3, &middle);
    held_less(4e-3, &middle, 3e-3, &fine);
    assert!(fine.elements > 1.5, "{} elements in a revolution", fine.elements);
    let shown = (Tolerance::Any, "addition by such coarse elements, shown");
    let held = (
        Tolerance::Absolute(0.4),
        "elements of half the depth of cut of a revolution: twice the standard error of six stops, 0.18",
    );
    for (name, over, (tolerance, reason)) in
        [("6", coarse, shown), ("4", middle, shown), ("3", fine, held)]
    {
        verify(
            "rock",
            format!(
                "torque that turns a standing bit on elements of {name} mm over that which turns \
                a turning one"
            ),
        )
        .within(tolerance, reason)
        .report(1.0, over.mean);
    }
}
