//! A user-defined bit law, run in a case from a file: a bit whose torque decreases with speed, as
//! Brett measured for PDC bits (*SPE Drilling Engineering* 7, 1992, 168-174), so that the string
//! sticks and slips below some rotary speed.
//!
//! It requires [`FallingTorque`] and its `impl BitRockLaw`; everything else is the program around
//! it.

use std::{error::Error, f64::consts::TAU, sync::Arc};

use wholestring::dynamics::{BitLaw, BitRockLaw, CustomLaw, SteadyCut};
use wholestring_case::{Case, Override, load};
use wholestring_runner::{CancellationToken, Silent, run};

/// Depth of cut and torque in proportion to the weight; the torque is larger by a fraction `rise`
/// at rest, half of which remains at a speed.
#[derive(Debug, Clone, Copy)]
pub struct FallingTorque {
    /// Depth of cut per revolution and weight, m/N.
    pub depth_of_cut_per_weight_m_per_N: f64,
    /// Torque per weight of a bit that turns fast, m.
    pub torque_per_weight_m: f64,
    /// Increase of the torque at rest, relative to it.
    pub rise: f64,
    /// Speed at which half of the increase remains, rad/s.
    pub half_rad_per_s: f64,
}

impl FallingTorque {
    /// Torque, N·m, under a weight, N, at a speed, rad/s.
    pub fn torque_N_m(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> f64 {
        let turning = rotary_speed_rad_per_s.abs() / self.half_rad_per_s;
        self.torque_per_weight_m * weight_on_bit_N * (1.0 + self.rise / (1.0 + turning))
    }
}

// ANCHOR: law
impl BitRockLaw for FallingTorque {
    fn name(&self) -> &str {
        "falling torque"
    }

    fn cut(&self, _: &[f64], weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let depth_of_cut_m = self.depth_of_cut_per_weight_m_per_N * weight_on_bit_N;
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: self.torque_N_m(weight_on_bit_N, rotary_speed_rad_per_s),
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }
}
// ANCHOR_END: law

/// Returns a case file with the law in place of its own: the engine uses it from the settings, and
/// its operations drill according to the law.
///
/// # Errors
/// Errors in the case, as the command line reports them.
pub fn case(
    file: &std::path::Path,
    law: FallingTorque,
    changes: &[Override],
) -> Result<Case, String> {
    let mut case = load(file, changes).map_err(|report| report.render(false))?;
    // ANCHOR: settings
    let rock_stiffness_N_per_m = case.dynamics.bit.law.stiffness_N_per_m();
    let law = CustomLaw { law: Arc::new(law), rock_stiffness_N_per_m, excitation: None };
    case.dynamics.bit.law = BitLaw::Custom(law);
    // ANCHOR_END: settings
    for operation in &mut case.operations {
        if operation.weight_on_bit_now_N() > 0.0 {
            *operation = case.dynamics.bit.drilling_steadily(*operation);
        }
    }
    Ok(case)
}

/// Slowest and fastest speed of the bit, rad/s, and its mean torque, N·m, over the window of the
/// case's only operation.
///
/// # Errors
/// A run that cannot begin, or that diverged.
pub fn drill(case: &Case) -> Result<[f64; 3], Box<dyn Error>> {
    let solved = run::answer(case, None, &Silent, &CancellationToken::new())?;
    if let Some(stopped) = solved.stopped {
        return Err(Box::new(wholestring_runner::Error::from(stopped)));
    }
    let operation = solved.answers.summary().operations.last().ok_or("no operation")?;
    let statistic =
        |name: &str| operation.statistics.as_ref().and_then(|all| all.get(name)).copied();
    let speed = statistic("bit_rotary_speed_rad_per_s").ok_or("no speed")?;
    let torque = statistic("bit_torque_N_m").ok_or("no torque")?;
    Ok([speed.min, speed.max, torque.mean])
}
