//! A controller of the top drive of the caller's own, against one that the engine has.

use std::sync::Arc;

use wholestring::dynamics::{
    CustomTopDrive, DynamicsSettings, SpeedController, TopDriveController, TopDriveReading,
    TopDriveSettings,
};

use crate::setup::{assert_refused, assert_resumes, run, settings};

const INERTIA_KG_M2: f64 = 2000.0;
const PROPORTIONAL_N_M_S: f64 = 20e3;
const INTEGRAL_N_M: f64 = 40e3;

/// Proportional and integral.
#[derive(Debug)]
struct OwnPi(&'static str);

impl TopDriveController for OwnPi {
    fn name(&self) -> &str {
        self.0
    }

    fn initial_state(&self, torque_N_m: f64) -> Vec<f64> {
        vec![torque_N_m]
    }

    fn torque_N_m(&self, state: &mut [f64], reading: &TopDriveReading) -> f64 {
        let missing = reading.set_rad_per_s - reading.speed_rad_per_s;
        let torque = state[0] + PROPORTIONAL_N_M_S * missing;
        if torque.abs() < reading.torque_limit_N_m {
            state[0] += INTEGRAL_N_M * missing * reading.dt_s;
        }
        torque
    }
}

fn with(top_drive: TopDriveSettings) -> DynamicsSettings {
    DynamicsSettings { top_drive, ..settings() }
}

fn custom(name: &'static str, torque_limit_N_m: Option<f64>) -> DynamicsSettings {
    with(TopDriveSettings::Custom(CustomTopDrive {
        inertia_kg_m2: INERTIA_KG_M2,
        controller: Arc::new(OwnPi(name)),
        torque_limit_N_m,
    }))
}

fn built_in(torque_limit_N_m: Option<f64>) -> DynamicsSettings {
    with(TopDriveSettings::Driven {
        inertia_kg_m2: INERTIA_KG_M2,
        controller: SpeedController::Pi {
            proportional_N_m_s: PROPORTIONAL_N_M_S,
            integral_N_m: INTEGRAL_N_M,
        },
        torque_limit_N_m,
    })
}

/// The engine's acts on the speed at the step's end, the user-defined one on that at its beginning:
/// they agree to the part of the time constant `J/K_p` of 0.1 s that a step of less than 1 ms is, a
/// hundredth, of the change of the speed.
#[test]
fn a_pi_controller_of_ones_own_is_the_engines() {
    let (own, engines) = (run(&custom("own", None)), run(&built_in(None)));
    let (own, engines) =
        (&own.series.rotary_speed_rad_per_s, &engines.series.rotary_speed_rad_per_s);
    let moved = engines.iter().map(|speed| (speed - 12.0).abs()).fold(0.0, f64::max);
    let apart =
        own.iter().zip(engines).map(|(own, engines)| (own - engines).abs()).fold(0.0, f64::max);
    assert!(apart < 0.01 * moved, "{apart} {moved}");
}

/// A drive that cannot supply the string's torque slows down, under any controller.
#[test]
fn the_limit_holds() {
    let limit_N_m = 1500.0;
    let own = run(&custom("own", Some(limit_N_m))).series.rotary_speed_rad_per_s;
    let engines = run(&built_in(Some(limit_N_m))).series.rotary_speed_rad_per_s;
    let (own, engines) = (own[own.len() - 1], engines[engines.len() - 1]);
    assert!(own < 11.5, "{own}");
    assert!((own - engines).abs() < 0.02 * (12.0 - engines), "{own} {engines}");
}

#[test]
fn a_controller_of_ones_own_resumes_with_the_same_bits() {
    assert_resumes(|| custom("own", None));
}

#[test]
fn a_checkpoint_of_another_controller_is_refused() {
    let [own, other] = ["own", "other"].map(|name| custom(name, None));
    assert_refused("the controller of the top drive", 1, [&own, &other, &built_in(None)]);
}
