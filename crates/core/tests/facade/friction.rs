//! A coefficient of friction of the caller's own, against that of the hole.

use wholestring::{
    dynamics::{CustomFriction, FrictionCoefficient, Precision, SlidingContact},
    prelude::*,
};

use crate::setup::{BIT_DEPTH_M, assert_refused, assert_resumes, drill, model, run, settings};

/// The hole's own coefficient, which the work of friction at a node lowers.
#[derive(Debug)]
struct Polished {
    name: &'static str,
    /// Work at a node that takes half of its friction, J; infinite for the hole's own.
    half_life_J: f64,
}

const OWN: Polished = Polished { name: "own", half_life_J: f64::INFINITY };

impl FrictionCoefficient for Polished {
    fn name(&self) -> &str {
        self.name
    }

    /// The work so far, J.
    fn initial_state(&self) -> Vec<f64> {
        vec![0.0]
    }

    fn coefficient(&self, state: &mut [f64], contact: &SlidingContact) -> f64 {
        assert!((0.0..=BIT_DEPTH_M + 1.0).contains(&contact.md_m), "{contact:?}");
        assert!((contact.md_m + contact.from_bit_m - BIT_DEPTH_M).abs() < 1.0, "{contact:?}");
        assert!(contact.normal_force_N >= 0.0, "{contact:?}");
        let coefficient = contact.friction.kinetic / (1.0 + state[0] / self.half_life_J);
        let slid_m = contact.sliding_speed_m_per_s() * contact.dt_s;
        state[0] += coefficient * contact.normal_force_N * slid_m;
        coefficient
    }
}

fn custom(law: impl FrictionCoefficient + 'static) -> DynamicsSettings {
    DynamicsSettings { friction_coefficient: Some(CustomFriction::new(law)), ..settings() }
}

/// A law that returns the hole's own coefficient changes no bit, in either precision.
#[test]
fn the_holes_own_coefficient_gives_the_same_bits() {
    for precision in [Precision::Double, Precision::Single] {
        let own = run(&DynamicsSettings { precision, ..custom(OWN) });
        let plain = run(&DynamicsSettings { precision, ..settings() });
        assert_eq!(own, plain);
    }
}

/// The law's state at each node is restored from a checkpoint, to the bit.
#[test]
fn a_coefficient_of_ones_own_resumes_with_the_same_bits() {
    let polished = || custom(Polished { half_life_J: 100.0, ..OWN });
    let whole = assert_resumes(polished);
    let plain = run(&settings());
    let torque = |series: &[f64]| series[series.len() - 1];
    let [polished, plain] = [&whole, &plain].map(|o| torque(&o.series.friction_torque_N_m));
    assert!(polished < 0.9 * plain, "{polished} {plain}");
}

/// Another law, and a checkpoint with the hole's friction, are refused with a sentence.
#[test]
fn a_checkpoint_of_another_coefficient_is_refused() {
    let simulation = Simulation::new(&model(), &drill(), &settings()).expect("a valid case");
    let nodes = simulation.elements() + 1;
    let other = custom(Polished { name: "other", ..OWN });
    assert_refused("the coefficient of friction", nodes, [&custom(OWN), &other, &settings()]);
}

/// An impossible coefficient ends the run, and the error names the place.
#[test]
fn a_coefficient_that_cannot_be_ends_the_run() {
    #[derive(Debug)]
    struct Wrong(f64);

    impl FrictionCoefficient for Wrong {
        fn name(&self) -> &str {
            "wrong"
        }

        fn coefficient(&self, _state: &mut [f64], contact: &SlidingContact) -> f64 {
            if contact.md_m > 300.0 { self.0 } else { contact.friction.kinetic }
        }
    }

    for wrong in [-0.1, f64::NAN, f64::INFINITY] {
        let settings = custom(Wrong(wrong));
        let mut simulation = Simulation::new(&model(), &drill(), &settings).expect("a valid case");
        let error = simulation.to_end().expect_err("no wall has that");
        assert_eq!(error.quantity, "coefficient of friction");
        assert_eq!(error.value.to_bits(), wrong.to_bits());
        assert!(error.md_m > 299.0 && error.time_s < 0.1, "{error}");
    }
}

/// The record of a run names the law where there is one.
#[test]
fn settings_are_written_with_the_name_of_the_law() {
    let written = |settings| serde_json::to_value(settings).expect("plain data");
    assert_eq!(written(custom(OWN))["friction_coefficient"]["name"], "own");
    assert!(written(settings()).get("friction_coefficient").is_none());
}
