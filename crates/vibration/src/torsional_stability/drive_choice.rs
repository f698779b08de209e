//! Effect of another controller of the top drive on the threshold.

use super::{
    StabilityAtWeight, StabilityError, StabilityRange, StabilitySettings, Threshold,
    drive::LinearDrive,
};
use wholestring::dynamics::{Gains, SpeedController};

/// Impedances of a controller that takes torsional waves, over the pipe's, that are tried.
const RATIOS: [f64; 4] = [1.0, 1.5, 2.5, 4.0];

/// Part of the speeds of the map at which a controller is tried.
const THINNED: usize = 3;

/// A controller tuned to the string, and its effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TunedDrive {
    /// Its proportional gain over the characteristic impedance of the uppermost pipe.
    pub impedance_ratio: f64,
    /// Its gains.
    pub gains: Gains,
    /// Part of a torsional wave of the string's lowest frequency that it sends back.
    pub reflection: f64,
    /// From which speed on the string is stable under it.
    pub threshold: Threshold,
}

impl StabilityAtWeight<'_> {
    /// SoftTorque with the drive's inertia, tuned to the string's lowest frequency: the impedance
    /// that makes steady rotation stable from the lowest speed; none of a drive without inertia.
    ///
    /// # Errors
    /// Those of [`Self::line`].
    pub fn tuned_drive(
        &self,
        settings: &StabilitySettings,
    ) -> Result<Option<TunedDrive>, StabilityError> {
        let speeds = settings.speeds_rad_per_s;
        let values = (speeds.values / THINNED).max(8).min(speeds.values);
        let thinned = StabilitySettings {
            speeds_rad_per_s: StabilityRange { values, ..speeds },
            ..*settings
        };
        let string = self.string();
        let mut best: Option<TunedDrive> = None;
        for impedance_ratio in RATIOS {
            let tuned =
                self.under(SpeedController::SoftTorque { impedance_ratio, frequency_Hz: None });
            let LinearDrive::Tuned { gains, .. } = tuned.drive() else {
                return Ok(None);
            };
            let threshold = tuned.line(&thinned)?.threshold;
            let reflection = tuned.drive().reflection(string.impedance_N_m_s, string.frequency_Hz);
            let found = TunedDrive { impedance_ratio, gains, reflection, threshold };
            let lower = best.is_none_or(|best| threshold.sooner_than(best.threshold));
            if lower {
                best = Some(found);
            }
        }
        Ok(best)
    }
}

impl Threshold {
    /// Whether it is stable from a lower speed on.
    pub(super) fn sooner_than(self, other: Self) -> bool {
        let speed = |threshold: Self| match threshold {
            Self::Everywhere => 0.0,
            Self::From(speed) => speed,
            Self::Nowhere => f64::INFINITY,
        };
        speed(self) < speed(other)
    }
}
