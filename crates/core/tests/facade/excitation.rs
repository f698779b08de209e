//! An excitation of the caller's own, against the engine's.

use wholestring::{
    dynamics::{
        Band, BitExcitation, BitLaw, BitRockStep, BitSettings, CustomExcitation, Cutters,
        Excitation, RateLaw, RegenerativeLaw, SetupError, Shake,
    },
    prelude::*,
};

use crate::setup::{assert_refused, assert_resumes, drill, model, run, settings};

const LOBES: u32 = 3;
const AMPLITUDE_M: f64 = 0.2e-3;

/// The lobes of the engine's, which may wear with the rock that is drilled.
#[derive(Debug)]
struct OwnLobes {
    name: &'static str,
    /// By which part a metre makes them lower.
    wear_per_m: f64,
}

const OWN: OwnLobes = OwnLobes { name: "own", wear_per_m: 0.0 };

impl BitExcitation for OwnLobes {
    fn name(&self) -> &str {
        self.name
    }

    /// Drilled distance, m.
    fn initial_state(&self) -> Vec<f64> {
        vec![0.0]
    }

    fn shake(&self, state: &[f64], bit_angle_rad: f64, _time_s: f64) -> Shake {
        let amplitude_m = AMPLITUDE_M / (1.0 + self.wear_per_m * state[0]);
        let front_m = amplitude_m * (f64::from(LOBES) * bit_angle_rad).sin();
        Shake { front_m, torque: 0.0 }
    }

    fn advance(&self, state: &mut [f64], step: &BitRockStep) {
        state[0] += step.advance_m;
    }
}

fn rate(excitation: Option<Excitation>) -> BitLaw {
    BitLaw::Rate(RateLaw { rock_stiffness_N_per_m: 1e8, excitation })
}

fn with(law: BitLaw, own: Option<OwnLobes>) -> DynamicsSettings {
    let excitation = own.map(CustomExcitation::new);
    DynamicsSettings { bit: BitSettings { law, excitation, ..Default::default() }, ..settings() }
}

/// The engine's lobes as one's own shake a bit of the engine's as the engine's do, to the bit.
#[test]
fn the_engines_lobes_as_ones_own_give_the_same_bits() {
    let lobes = Excitation {
        lobes: LOBES,
        amplitude_m: AMPLITUDE_M,
        roughness_m: 0.0,
        torque_fluctuation: 0.0,
        band: Band::PerRevolution(8.0),
    };
    let own = run(&with(rate(None), Some(OWN)));
    assert_eq!(own, run(&with(rate(Some(lobes)), None)));
    assert_ne!(own.series, run(&with(rate(None), None)).series);
}

#[test]
fn an_excitation_of_ones_own_resumes_with_the_same_bits() {
    let worn = || with(rate(None), Some(OwnLobes { wear_per_m: 100.0, ..OWN }));
    let whole = assert_resumes(worn);
    assert_ne!(whole.series, run(&with(rate(None), Some(OWN))).series);
}

#[test]
fn a_checkpoint_of_another_excitation_is_refused() {
    let with = |own| with(rate(None), own);
    let other = with(Some(OwnLobes { name: "other", ..OWN }));
    assert_refused("the excitation of the bit", 1, [&with(Some(OWN)), &other, &with(None)]);
}

/// A law that knows more of the bottom than its depth has no front to shake.
#[test]
fn a_law_without_a_rock_front_is_refused() {
    let cutters = Cutters {
        radius_m: 0.108,
        core_radius_m: 0.0,
        intrinsic_specific_energy_Pa: 60e6,
        cutter_inclination: 0.6,
        wear_flat_m: 1.2e-3,
        contact_strength_Pa: 60e6,
        bit_geometry: 1.0,
        friction: 0.6,
    };
    let law = BitLaw::Regenerative(RegenerativeLaw { cutters, blades: 6 });
    let answer = Simulation::new(&model(), &drill(), &with(law, Some(OWN)));
    assert!(matches!(answer, Err(SetupError::Excitation(_))));
}
