//! `[bit.excitation]`.

use wholestring::dynamics::{Band, BitTable as Points, Excitation};
use wholestring_config::prelude::*;

/// Defaults: three lobes of a tricone bit; noise up to eight waves per revolution.
const LOBES: u64 = 3;
const WAVES: f64 = 8.0;

table! {
    /// Excitation of the bit on its rock front. Without any excitation the bottom is smooth.
    ExcitationTable in "[bit.excitation]" {
        /// Lobes of the bottom pattern per revolution: the cones of a roller-cone bit. Raising it
        /// raises the frequency.
        lobes: u64 = default(Count { from: 1, to: 100 }, LOBES);
        /// Amplitude of the lobes: half of the height from trough to crest. Raising it raises the
        /// swing of the weight on bit at this many times the rotary speed, until the bit bounces.
        amplitude: f64 = default(displacement(), 0.0);
        /// Roughness of the bottom, rms. Raising it raises the noise of the weight on bit, until
        /// the bit bounces. A table of the law "table" may give its own.
        roughness: f64 = default(displacement(), 0.0);
        /// Fluctuation of the bit's torque, rms, as a fraction of the torque. Raising it raises the
        /// noise of the torque. A table of the law "table" may give its own.
        torque_fluctuation: f64 = default(Number::up_to(1.0), 0.0);
        /// Waves per revolution at which the power density of roughness and torque fluctuation has
        /// fallen to half. Raising it makes the noise finer.
        waves: f64 = default(
            Number { unit: "", range: Range::positive_to(1000.0) },
            WAVES,
        );
        /// The same as a frequency, for noise that depends on time instead of the bit's angle.
        frequency: f64 = optional(Quantity::si(
            Dimension::Frequency,
            Range::positive_to(1000.0).usual(0.1, 500.0),
            "20 Hz",
        ));
    }
}

fn displacement() -> Quantity {
    Quantity::si(Dimension::Diameter, Range::from_to(0.0, 0.1).usual(1e-6, 0.03), "1 mm")
}

impl ExcitationTable {
    /// Returns the excitation, if its amplitudes are not all zero; a measured table of the bit may
    /// give the standard deviations.
    pub(super) fn build(
        &self,
        points: Option<&Points>,
        reader: &mut Reader,
    ) -> Option<Option<Excitation>> {
        let spreads_torque = points.is_some_and(Points::spreads_torque);
        let spreads_weight = points.is_some_and(Points::spreads_weight);
        for (field, name, column, brought) in [
            (&self.torque_fluctuation, "torque_fluctuation", "torque_std_N_m", spreads_torque),
            (&self.roughness, "roughness", "weight_on_bit_std_N", spreads_weight),
        ] {
            if let Some(entry) = field.given().filter(|_| brought) {
                return Diagnostic::error(format!("`{name}` is given twice"))
                    .at(entry.place, format!("the table has it by `{column}`"))
                    .help("keep one of the two")
                    .refuse(reader);
            }
        }
        let frequency = self.frequency.optional()?;
        if let (Some(frequency), Some(waves)) = (frequency, self.waves.given()) {
            return Diagnostic::error(
                "the noise depends on time or on the bit's angle, not on both",
            )
            .at(frequency.place, "by time")
            .at(waves.place, "by the bit's angle")
            .help("give one of `frequency` and `waves`")
            .refuse(reader);
        }
        let excitation = Excitation {
            lobes: u32::try_from(*self.lobes.get()?).ok()?,
            amplitude_m: *self.amplitude.get()?,
            roughness_m: *self.roughness.get()?,
            torque_fluctuation: *self.torque_fluctuation.get()?,
            band: match frequency {
                Some(frequency) => Band::PerSecond(frequency.value),
                None => Band::PerRevolution(*self.waves.get()?),
            },
        };
        let lobed = excitation.amplitude_m > 0.0;
        let noisy = excitation.roughness_m > 0.0
            || excitation.torque_fluctuation > 0.0
            || spreads_torque
            || spreads_weight;
        let noise = "used with `roughness` or `torque_fluctuation`";
        for (place, name, used, with) in [
            (self.lobes.place(), "lobes", lobed, "used with `amplitude`"),
            (self.waves.place(), "waves", noisy, noise),
            (self.frequency.place(), "frequency", noisy, noise),
        ] {
            if let Some(place) = place.filter(|_| !used) {
                reader.report(Diagnostic::idle(name, place, with));
            }
        }
        Some((lobed || noisy).then_some(excitation))
    }
}
