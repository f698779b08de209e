//! User laws of a live run, which replace those of the case.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use wholestring::{
    dynamics::{BitLaw, CustomExcitation, CustomLaw, DynamicsSettings, Shake},
    operation::Operation,
};

use super::sampled_law::{BitAnswer, BitReading, HeldLaw, HeldShake, SampledLaw, ShakeReading};
use crate::{cancellation::CancellationToken, error::Error};

/// User laws of a live run.
#[derive(Debug, Clone, Default)]
pub struct OwnLaws {
    /// The law of the bit.
    pub bit_law: Option<SampledLaw<BitReading, BitAnswer>>,
    /// Excitation of the bit.
    pub excitation: Option<SampledLaw<ShakeReading, Shake>>,
}

/// Laws in a checkpoint: their names, and their answers before the first step.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct StoredLaws {
    bit_law: Option<(String, [f64; 2])>,
    excitation: Option<(String, [f64; 4])>,
}

impl StoredLaws {
    /// Names for messages.
    pub(super) fn titles(&self) -> String {
        let bit_law = self.bit_law.as_ref().map(|(name, _)| format!("the bit law {name}"));
        let shaking = self.excitation.as_ref();
        let excitation = shaking.map(|(name, _)| format!("the excitation {name}"));
        let titles: Vec<String> = bit_law.into_iter().chain(excitation).collect();
        if titles.is_empty() { "no user law".to_owned() } else { titles.join(" and ") }
    }

    /// Whether these are the laws of the checkpoint.
    pub(super) fn is_of(&self, laws: &OwnLaws) -> bool {
        let named = |name: Option<&String>, title: Option<String>| name == title.as_ref();
        named(
            self.bit_law.as_ref().map(|bit_law| &bit_law.0),
            laws.bit_law.as_ref().map(SampledLaw::title),
        ) && named(
            self.excitation.as_ref().map(|excitation| &excitation.0),
            laws.excitation.as_ref().map(SampledLaw::title),
        )
    }
}

impl OwnLaws {
    /// Names for messages.
    pub(super) fn titles(&self) -> String {
        let bit_law = self.bit_law.as_ref().map(|bit_law| (bit_law.title(), [0.0; 2]));
        let excitation = self.excitation.as_ref().map(|excitation| (excitation.title(), [0.0; 4]));
        StoredLaws { bit_law, excitation }.titles()
    }

    /// Evaluates them before the first step.
    pub(super) fn begin(
        &self,
        operation: &Operation,
        settings: &DynamicsSettings,
    ) -> Result<StoredLaws, Error> {
        if self.bit_law.is_none() && self.excitation.is_none() {
            return Ok(StoredLaws::default());
        }
        if operation.weight_on_bit_now_N() <= 0.0 {
            let name = operation.kind.name();
            let message = format!("the bit of `{name}` is off bottom: no bit law applies");
            return Err(Error::BadInput(message));
        }
        let speed = settings.bit.drilling_speed_rad_per_s(operation);
        let silent = |name: &str| Error::Failed(format!("{name} gave no answer"));
        let mut stored = StoredLaws::default();
        if let Some(law) = &self.bit_law {
            law.check()?;
            let weight_on_bit_N = operation.weight_on_bit_N;
            let reading = BitReading {
                time_s: 0.0,
                weight_on_bit_N,
                rotary_speed_rad_per_s: speed,
                angle_rad: 0.0,
                drilled_m: 0.0,
            };
            let answer = (law.ask)(&reading).ok_or_else(|| silent(&law.name))?;
            let per_weight =
                [answer.depth_of_cut_m, answer.torque_N_m].map(|v| v / weight_on_bit_N);
            stored.bit_law = Some((law.title(), per_weight));
        }
        if let Some(law) = &self.excitation {
            law.check()?;
            let time_s = 1.0 / law.rate_Hz;
            let mut shakes = [Shake::default(); 2];
            for (shake, time_s) in shakes.iter_mut().zip([0.0, time_s]) {
                let reading = ShakeReading { time_s, angle_rad: speed * time_s };
                *shake = (law.ask)(&reading).ok_or_else(|| silent(&law.name))?;
            }
            let [now, next] = shakes;
            let numbers = [now.front_m, now.torque, next.front_m, next.torque];
            stored.excitation = Some((law.title(), numbers));
        }
        Ok(stored)
    }

    /// Sets them in operation and settings; `failed` is cancelled if one of them returns no answer.
    pub(super) fn apply(
        &self,
        stored: &StoredLaws,
        operation: &mut Operation,
        settings: &mut DynamicsSettings,
        failed: &CancellationToken,
    ) -> Result<(), Error> {
        if let (Some(law), Some((_, first))) = (&self.bit_law, &stored.bit_law) {
            let excitation = match &settings.bit.law {
                BitLaw::Rate(law) => law.excitation,
                BitLaw::DetournayDefourny(law) => law.excitation,
                BitLaw::Table(law) => law.excitation,
                BitLaw::Custom(law) => law.excitation,
                BitLaw::Regenerative(_) | BitLaw::Rock(_) => {
                    let message = "a user bit law requires a rock stiffness: give the case a bit \
                                   law that has one, such as `rate`";
                    return Err(Error::BadInput(message.to_owned()));
                }
            };
            let rock_stiffness_N_per_m = settings.bit.law.stiffness_N_per_m();
            let held = HeldLaw {
                title: law.title(),
                law: law.clone(),
                first: *first,
                failed: failed.clone(),
            };
            let law = Arc::new(held);
            settings.bit.law =
                BitLaw::Custom(CustomLaw { law, rock_stiffness_N_per_m, excitation });
            *operation = settings.bit.drilling_steadily(*operation);
        }
        if let (Some(law), Some((_, first))) = (&self.excitation, &stored.excitation) {
            let held = HeldShake {
                title: law.title(),
                law: law.clone(),
                first: *first,
                failed: failed.clone(),
            };
            settings.bit.excitation = Some(CustomExcitation::new(held));
        }
        Ok(())
    }
}
