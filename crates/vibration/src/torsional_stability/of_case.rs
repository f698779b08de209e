//! Results of the map at the case's own speed and weight.

use super::{
    LiesBy, StabilityError, StabilitySettings, Threshold, TorsionalStability, TunedDrive,
    roots::Stability,
};

/// Frequencies at which the top drive's reflection is reported, over the string's lowest.
const REFLECTED: [f64; 4] = [1.0, 2.0, 4.0, 8.0];

/// The case's own speed and weight on the map, and its top drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StabilityOfCase {
    /// Rotary speed at surface, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Stability of small vibrations there.
    pub stability: Stability,
    /// From which speed on this weight is stable.
    pub threshold: Threshold,
    /// Torque at the top while the string turns steadily, N·m.
    pub surface_torque_N_m: f64,
    /// Whether that is more than the top drive gives.
    pub stalls: bool,
    /// Method that provided the contact of the string.
    pub lies_by: LiesBy,
    /// Lowest torsional frequency of the string, held at the top and free at the bit, Hz.
    pub string_frequency_Hz: f64,
    /// Characteristic torsional impedance of the uppermost pipe, N·m·s.
    pub pipe_impedance_N_m_s: f64,
    /// Frequencies, Hz, from that one up, and the part of a torsional wave of each that the top
    /// drive sends back.
    pub reflections: [[f64; 2]; REFLECTED.len()],
    /// A controller with a lower threshold; none where the case is stable at all speeds, the drive
    /// has no inertia, or nothing that was tried is better.
    pub tuned: Option<TunedDrive>,
}

impl StabilityOfCase {
    /// The speed over the threshold, less one; none without a threshold in the map.
    pub fn margin(&self) -> Option<f64> {
        match self.threshold {
            Threshold::From(speed) => Some(self.rotary_speed_rad_per_s / speed - 1.0),
            Threshold::Everywhere | Threshold::Nowhere => None,
        }
    }
}

impl TorsionalStability<'_> {
    /// The case's own speed and weight.
    ///
    /// # Errors
    /// Those of [`Self::line`].
    pub fn of_case(&self, settings: &StabilitySettings) -> Result<StabilityOfCase, StabilityError> {
        let operation = self.operation();
        let at = self.at_weight(operation.weight_on_bit_N)?;
        let line = at.line(settings)?;
        let own = at.point(operation.rotary_speed_rad_per_s, self.band(settings))?;
        let string = self.string();
        let tuned = match line.threshold {
            Threshold::Everywhere => None,
            threshold => at
                .tuned_drive(settings)?
                .filter(|tuned_drive| tuned_drive.threshold.sooner_than(threshold)),
        };
        Ok(StabilityOfCase {
            rotary_speed_rad_per_s: own.rotary_speed_rad_per_s,
            weight_on_bit_N: own.weight_on_bit_N,
            stability: own.stability,
            threshold: line.threshold,
            surface_torque_N_m: line.surface_torque_N_m,
            stalls: line.stalls,
            lies_by: line.lies_by,
            string_frequency_Hz: string.frequency_Hz,
            pipe_impedance_N_m_s: string.impedance_N_m_s,
            reflections: REFLECTED.map(|times| {
                let frequency_Hz = times * string.frequency_Hz;
                [frequency_Hz, self.drive().reflection(string.impedance_N_m_s, frequency_Hz)]
            }),
            tuned,
        })
    }
}
