//! A bit alone on the rock under one weight at one speed.

use std::f64::consts::{PI, TAU};

use wholestring_rock::{
    Advance, Alone, Drilling, DrillingSpec, Driver, Rock, Stepper, Trial, TrialError, TrialOutcome,
    TrialSpec, bit_face::ContactLaw,
};
use wholestring_verification::verify;

use crate::setup::{elastic, small_bit};

/// Elements of the rock, m: coarse, for the books and not for the forces.
const SIZE_M: f64 = 8e-3;

/// A rock of 10 MPa, of which a crushed element takes as much per volume.
fn weak() -> Rock {
    Rock { compressive_fracture_energy_J_per_m2: 10e6 * SIZE_M, ..Rock::of_strength(10e6) }
}

/// A bit of 60 mm on a rock.
fn small(rock: Rock) -> DrillingSpec {
    small_bit(rock, SIZE_M)
}

/// Three and a half revolutions of which three count, at 300 rev/min.
fn trial(weight_N: f64) -> TrialSpec {
    TrialSpec {
        weight_N,
        rotary_rad_per_s: 10.0 * PI,
        mass_kg: 100.0,
        settle_revolutions: 0.5,
        revolutions: 3.0,
        averaging_s: 4.6e-3,
        step_s: 0.91e-3,
    }
}

fn whole(spec: &TrialSpec, drilling: &DrillingSpec) -> TrialOutcome {
    let mut trial = Trial::new(spec, drilling).expect("a sound trial");
    assert_eq!(trial.outcome(), None, "nothing is counted yet");
    trial.advance(u64::MAX, &Stepper::default(), &Alone).expect("finite forces");
    assert!(trial.is_finished());
    assert_eq!(trial.revolutions(), 3.5);
    trial.outcome().expect("an outcome")
}

/// Mean and standard deviation.
fn moments(values: &[f64]) -> [f64; 2] {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|x| (x - mean).powi(2)).sum();
    [mean, (squares / count).sqrt()]
}

/// The outcome is that of a bit driven by hand, each number by its definition.
#[test]
fn a_trial_counts_what_a_driven_bit_does() {
    let (spec, rock) = (trial(1500.0), small(weak()));
    let outcome = whole(&spec, &rock);
    // 0.2 s in 44 averages of not more than 4.6 ms, 220 steps of not more than 0.91 ms.
    let dt = 0.2 / 220.0;
    let driver = Driver::Weight {
        weight_N: 1500.0,
        mass_kg: 100.0,
        rotary_rad_per_s: spec.rotary_rad_per_s,
    };
    let mut drilling = Drilling::new(&rock).unwrap();
    let stepper = Stepper::default();
    let mut advances: Vec<Advance> = (0..110 + 3 * 220)
        .map(|_| driver.drive(&mut drilling, spec.step_time_s(), &stepper, &Alone))
        .collect();
    advances.drain(..110);
    let each_step =
        |what: &dyn Fn(&Advance) -> f64| advances.iter().map(what).collect::<Vec<f64>>();
    let (rate, torque, weight) = (
        each_step(&|step| step.displacement_m.z / dt),
        each_step(&|step| -step.moment_N_m.z),
        each_step(&|step| -step.force_N.z),
    );
    let error = |values: &[f64]| {
        let turns: Vec<f64> = values.chunks(220).map(|turn| moments(turn)[0]).collect();
        assert_eq!(turns.len(), 3);
        moments(&turns)[1] / 2f64.sqrt()
    };
    let deviation = |values: &[f64]| {
        let means: Vec<f64> = values.chunks(5).map(|mean| moments(mean)[0]).collect();
        moments(&means)[1]
    };
    let broken: usize = advances.iter().map(|step| step.broken).sum();
    assert!(broken > 0);
    assert_eq!(outcome.bricks_broken, broken as u64);
    let work_J = -advances.iter().map(|step| step.work_J).sum::<f64>();
    let way_m = 0.6 * moments(&rate)[0];
    let volume_m3 = broken as f64 * SIZE_M.powi(3);
    for (quantity, expected, computed) in [
        ("rate of penetration", moments(&rate)[0], outcome.rate_of_penetration_m_per_s),
        ("error of the rate", error(&rate), outcome.rate_of_penetration_error_m_per_s.unwrap()),
        ("depth of cut", way_m / 3.0, outcome.depth_of_cut_m),
        ("torque", moments(&torque)[0], outcome.torque_N_m),
        ("error of the torque", error(&torque), outcome.torque_error_N_m.unwrap()),
        ("standard deviation of the torque", deviation(&torque), outcome.torque_std_N_m),
        ("weight", moments(&weight)[0], outcome.weight_borne_N),
        ("standard deviation of the weight", deviation(&weight), outcome.weight_on_bit_std_N),
        ("specific energy", work_J / volume_m3, outcome.specific_energy_Pa.unwrap()),
        (
            "energy per volume of hole",
            work_J / (PI * 0.03 * 0.03 * way_m),
            outcome.mechanical_specific_energy_Pa.unwrap(),
        ),
        ("time", 0.6, outcome.time_s),
        ("revolutions", 3.0, outcome.revolutions),
        ("averaging time", 5.0 * dt, outcome.averaging_time_s),
    ] {
        verify("rock", format!("{quantity} of a bit alone over that summed up by hand"))
            .absolute(1e-12, "rounding of 660 steps")
            .report(1.0, computed / expected);
    }
    // Teale's form of the same: weight per area, and torque per depth of cut and area.
    let area_m2 = PI * 0.03 * 0.03;
    verify("rock", "work of a bit alone per volume of hole over W/A + 2πT/(A d)")
        .absolute(
            0.02,
            "weight and rate fluctuate together; their covariance is left out of the formula",
        )
        .report(
            1.0,
            outcome.mechanical_specific_energy_Pa.unwrap()
                / (outcome.weight_borne_N / area_m2
                    + TAU * outcome.torque_N_m / (area_m2 * outcome.depth_of_cut_m)),
        );
    assert!(outcome.kinetic_fraction > 0.0 && outcome.kinetic_fraction < 0.05);
}

/// In pieces, stored and resumed on the way: the same bits.
#[test]
fn a_trial_goes_on_from_a_checkpoint_with_the_same_bits() {
    let (mut spec, rock) = (trial(1500.0), small(weak()));
    spec.revolutions = 1.25;
    let stepper = Stepper::default();
    let bits = |trial: &Trial| postcard::to_allocvec(trial).expect("plain data");
    let mut one = Trial::new(&spec, &rock).unwrap();
    one.advance(u64::MAX, &stepper, &Alone).unwrap();
    let mut other = Trial::new(&spec, &rock).unwrap();
    while !other.is_finished() {
        other.advance(83, &stepper, &Alone).unwrap();
        other = postcard::from_bytes(&bits(&other)).expect("the same data");
    }
    assert!(one.drilling().block().removed().0 > 0);
    assert!(bits(&one) == bits(&other));
    assert_eq!(one.outcome(), other.outcome());
    // Beyond its end it does not go.
    other.advance(5, &stepper, &Alone).unwrap();
    assert!(bits(&one) == bits(&other));
}

/// A bit that the rock does not let in ends as any other, with nothing broken.
#[test]
fn a_bit_that_does_not_drill_ends_too() {
    let mut spec = trial(1000.0);
    spec.settle_revolutions = 1.5;
    spec.revolutions = 2.0;
    let mut rock = small(elastic());
    // Its strength is none of a rock: a contact as stiff as its elements.
    rock.contact = ContactLaw {
        stiffness_Pa_per_m: rock.block.rock.youngs_modulus_Pa / SIZE_M,
        damping_ratio: 1.0,
        friction: 0.3,
    };
    let outcome = whole(&spec, &rock);
    assert_eq!(outcome.bricks_broken, 0);
    assert_eq!(outcome.specific_energy_Pa, None);
    verify("rock", "depth of cut of a bit alone on rock that never fails, m")
        .absolute(0.1 * SIZE_M, "a tenth of an element: it hops over their corners and comes back")
        .report(0.0, outcome.depth_of_cut_m);
}

#[test]
fn numbers_that_make_no_trial() {
    let rock = small(weak());
    let valid = trial(1000.0);
    for (spec, named) in [
        (TrialSpec { weight_N: 0.0, ..valid }, "weight"),
        (TrialSpec { rotary_rad_per_s: f64::NAN, ..valid }, "speed"),
        (TrialSpec { mass_kg: -1.0, ..valid }, "mass"),
        (TrialSpec { step_s: f64::INFINITY, ..valid }, "step"),
        (TrialSpec { step_s: 1e-14, ..valid }, "steps"),
        (TrialSpec { revolutions: 0.0, ..valid }, "revolutions"),
        (TrialSpec { settle_revolutions: -0.5, ..valid }, "settling"),
    ] {
        let error = Trial::new(&spec, &rock).unwrap_err();
        assert!(matches!(error, TrialError::Number { .. }), "{error}");
        assert!(error.to_string().contains(named), "{error}");
    }
}
