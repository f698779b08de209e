//! A law of the bit of the caller's own, against a law that the engine has.

use wholestring::dynamics::{
    Band, BitLaw, BitRockLaw, BitRockStep, BitSettings, CustomLaw, DynamicsSettings, Excitation,
    RateLaw, Shake, SteadyCut,
};

use crate::setup::{assert_refused, assert_resumes, drill, run, settings};

const STIFFNESS_N_PER_M: f64 = 1e8;

/// The rate law of [`drill`], which may count its revolutions.
#[derive(Debug)]
struct OwnRate {
    name: &'static str,
    /// By which part a revolution makes it slower.
    blunting: f64,
    /// Curvature of the rate against the weight: 1 is a straight line.
    exponent: f64,
}

const OWN: OwnRate = OwnRate { name: "own", blunting: 0.0, exponent: 1.0 };

impl BitRockLaw for OwnRate {
    fn name(&self) -> &str {
        self.name
    }

    fn initial_state(&self) -> Vec<f64> {
        vec![0.0]
    }

    fn cut(&self, state: &[f64], weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let nominal = drill();
        let part = weight_on_bit_N / nominal.weight_on_bit_N;
        let sharp = 1.0 / (1.0 + self.blunting * state[0]);
        SteadyCut {
            depth_of_cut_m: 0.0,
            torque_N_m: nominal.bit_torque_N_m * part,
            rate_of_penetration_m_per_s: nominal.rate_of_penetration_m_per_s
                * part.powf(self.exponent)
                * (rotary_speed_rad_per_s / nominal.rotary_speed_rad_per_s)
                * sharp,
        }
    }

    fn shake(&self, state: &[f64], bit_angle_rad: f64, time_s: f64) -> Shake {
        let amplitude = self.blunting * (state[0] + time_s);
        Shake { front_m: 1e-4 * amplitude * bit_angle_rad.sin(), torque: 0.0 }
    }

    fn advance(&self, state: &mut [f64], step: &BitRockStep) {
        state[0] += step.bit_speed_rad_per_s * step.dt_s / std::f64::consts::TAU;
    }
}

fn with(law: BitLaw) -> DynamicsSettings {
    DynamicsSettings { bit: BitSettings { law, ..BitSettings::default() }, ..settings() }
}

fn custom(law: OwnRate) -> DynamicsSettings {
    with(BitLaw::Custom(CustomLaw::new(law, STIFFNESS_N_PER_M)))
}

/// The rate law as a user-defined law drills like the engine's. The weight is found to 1e-12 of
/// itself, and the rest of the difference is rounding, which a string in smooth drilling amplifies
/// to 1.3e-10 in 4 s.
#[test]
fn the_rate_law_as_ones_own_is_the_rate_law() {
    let own = run(&custom(OWN));
    let built_in = run(&with(BitLaw::Rate(RateLaw {
        rock_stiffness_N_per_m: STIFFNESS_N_PER_M,
        excitation: None,
    })));
    for (what, own, built_in) in [
        ("weight on bit", &own.series.weight_on_bit_N, &built_in.series.weight_on_bit_N),
        ("torque", &own.series.bit_torque_N_m, &built_in.series.bit_torque_N_m),
        (
            "rate",
            &own.series.rate_of_penetration_m_per_s,
            &built_in.series.rate_of_penetration_m_per_s,
        ),
    ] {
        for (row, (own, built_in)) in own.iter().zip(built_in).enumerate() {
            let error = (own - built_in).abs() / built_in.abs();
            assert!(error < 1e-8, "{what} of sample {row}: {own} {built_in}");
        }
    }
}

/// A curved law drills at its own rate for the weight: no step of the search was lost. Means over a
/// sample differ from the law's by the variation of the weight within it, 1e-4 here.
#[test]
fn a_curved_law_drills_at_its_rate() {
    let law = OwnRate { exponent: 1.6, ..OWN };
    let outcome = run(&custom(law));
    let from = outcome.series.time_s.len() / 2;
    let nominal = drill();
    for row in from..outcome.series.time_s.len() {
        let part = outcome.series.weight_on_bit_N[row] / nominal.weight_on_bit_N;
        let speed = outcome.series.bit_rotary_speed_rad_per_s[row] / nominal.rotary_speed_rad_per_s;
        let expected = nominal.rate_of_penetration_m_per_s * part.powf(1.6) * speed;
        let rate = outcome.series.rate_of_penetration_m_per_s[row];
        assert!((rate / expected - 1.0).abs() < 1e-3, "sample {row}: {rate} {expected}");
    }
}

/// The engine's noise comes on top of the law's own excitation.
#[test]
fn excitation_shakes_a_law_of_ones_own() {
    let shaken = |excitation| {
        let law = CustomLaw { excitation, ..CustomLaw::new(OWN, STIFFNESS_N_PER_M) };
        let outcome = run(&with(BitLaw::Custom(law)));
        let (_, weight) = *outcome
            .statistics
            .iter()
            .find(|(name, _)| *name == "weight_on_bit_N")
            .expect("a weight on bit");
        weight.std
    };
    let lobes = Excitation {
        lobes: 3,
        amplitude_m: 0.2e-3,
        roughness_m: 0.0,
        torque_fluctuation: 0.0,
        band: Band::PerRevolution(8.0),
    };
    let (still, moved) = (shaken(None), shaken(Some(lobes)));
    assert!(moved > 5.0 * still, "{still} {moved}");
}

/// The state of the law is restored from a checkpoint, to the bit.
#[test]
fn a_law_of_ones_own_resumes_with_the_same_bits() {
    let blunting = || custom(OwnRate { blunting: 0.5, ..OWN });
    let whole = assert_resumes(blunting);
    assert_ne!(whole.series, run(&custom(OWN)).series);
}

/// Another law of one's own, and a law that the engine has, are refused with a sentence.
#[test]
fn a_checkpoint_of_another_law_is_refused() {
    let other = custom(OwnRate { name: "other", ..OWN });
    assert_refused("the law of the bit", 1, [&custom(OWN), &other, &settings()]);
}

/// The record of a run names the law.
#[test]
fn settings_are_written_with_the_name_of_the_law() {
    let written = serde_json::to_value(custom(OWN)).expect("plain data");
    assert_eq!(written["bit"]["law"]["Custom"]["name"], "own");
}
