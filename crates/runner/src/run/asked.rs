//! Laws of the bit that a front asks at a rate, in whatever language they are written: what they
//! answered is held until they are asked again.

use std::{f64::consts::TAU, fmt, sync::Arc};

use serde::{Deserialize, Serialize};
use wholestring::{
    dynamics::{
        BitExcitation, BitLaw, BitRockLaw, BitRockStep, CustomExcitation, CustomLaw,
        DynamicsSettings, Shake, SteadyCut,
    },
    operation::Operation,
};

use crate::{cancellation::CancellationToken, error::Error};

/// Parts of a period by which a moment may be early and is taken for its end.
const EARLY: f64 = 1e-6;

/// What a law of the bit is asked with: how the bit drills at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BitReading {
    /// Time since the start of the run, s.
    pub time_s: f64,
    /// Weight on bit, N, more than zero.
    pub weight_on_bit_N: f64,
    /// Speed of the bit, motor included, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Angle through which the bit has turned since the start of the run, rad.
    pub angle_rad: f64,
    /// Rock that the bit has taken away along the hole since the start of the run, m.
    pub drilled_m: f64,
}

/// What a law of the bit answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BitAnswer {
    /// Rock that a revolution takes away under that weight, m; zero or more.
    pub depth_of_cut_m: f64,
    /// Torque on bit, N·m; zero or more.
    pub torque_N_m: f64,
}

/// What an excitation is asked with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShakeReading {
    /// Time since the start of the run, s.
    pub time_s: f64,
    /// Angle through which the bit will have turned then, at the speed that it has, rad.
    pub angle_rad: f64,
}

/// A law that is asked at a rate. It answers nothing where it cannot: the run then stops.
pub struct Asked<I, O> {
    /// Its name, by which a checkpoint knows it again.
    pub name: String,
    /// How often it is asked, Hz; once a step at most.
    pub rate_Hz: f64,
    /// The law itself.
    pub ask: Arc<dyn Fn(&I) -> Option<O> + Send + Sync>,
}

impl<I, O> Clone for Asked<I, O> {
    fn clone(&self) -> Self {
        Self { name: self.name.clone(), rate_Hz: self.rate_Hz, ask: Arc::clone(&self.ask) }
    }
}

impl<I, O> fmt::Debug for Asked<I, O> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.title())
    }
}

impl<I, O> Asked<I, O> {
    /// Name and rate.
    fn title(&self) -> String {
        format!("{} at {} Hz", self.name, self.rate_Hz)
    }

    fn check(&self) -> Result<(), Error> {
        if self.rate_Hz.is_finite() && self.rate_Hz > 0.0 {
            return Ok(());
        }
        Err(Error::BadInput(format!("{} is to be asked at {} Hz", self.name, self.rate_Hz)))
    }
}

/// The laws of one's own of a run in hand.
#[derive(Debug, Clone, Default)]
pub struct OwnLaws {
    /// The law of the bit.
    pub bit_law: Option<Asked<BitReading, BitAnswer>>,
    /// What shakes the bit.
    pub excitation: Option<Asked<ShakeReading, Shake>>,
}

/// What a checkpoint tells of them: their names, and what they answered before the first step.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct StoredLaws {
    bit_law: Option<(String, [f64; 2])>,
    excitation: Option<(String, [f64; 4])>,
}

impl StoredLaws {
    /// What they are called, for people.
    pub(super) fn titles(&self) -> String {
        let bit_law = self.bit_law.as_ref().map(|(name, _)| format!("the bit law {name}"));
        let shaking = self.excitation.as_ref();
        let excitation = shaking.map(|(name, _)| format!("the excitation {name}"));
        let titles: Vec<String> = bit_law.into_iter().chain(excitation).collect();
        if titles.is_empty() { "no law of one's own".to_owned() } else { titles.join(" and ") }
    }

    /// Whether these are the laws that it tells of.
    pub(super) fn is_of(&self, laws: &OwnLaws) -> bool {
        let named = |name: Option<&String>, title: Option<String>| name == title.as_ref();
        named(self.bit_law.as_ref().map(|of| &of.0), laws.bit_law.as_ref().map(Asked::title))
            && named(
                self.excitation.as_ref().map(|of| &of.0),
                laws.excitation.as_ref().map(Asked::title),
            )
    }
}

impl OwnLaws {
    /// What they are called, for people.
    pub(super) fn titles(&self) -> String {
        let bit_law = self.bit_law.as_ref().map(|of| (of.title(), [0.0; 2]));
        let excitation = self.excitation.as_ref().map(|of| (of.title(), [0.0; 4]));
        StoredLaws { bit_law, excitation }.titles()
    }

    /// Asks them for what they answer before the first step.
    pub(super) fn begin(
        &self,
        operation: &Operation,
        settings: &DynamicsSettings,
    ) -> Result<StoredLaws, Error> {
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

    /// Puts them into operation and settings; `failed` is told when one of them gives no answer.
    pub(super) fn apply(
        &self,
        stored: &StoredLaws,
        operation: &mut Operation,
        settings: &mut DynamicsSettings,
        failed: &CancellationToken,
    ) -> Result<(), Error> {
        if self.bit_law.is_none() && self.excitation.is_none() {
            return Ok(());
        }
        if operation.weight_on_bit_now_N() <= 0.0 {
            let name = operation.kind.name();
            let message = format!("the bit of `{name}` is off bottom: it has no law to follow");
            return Err(Error::BadInput(message));
        }
        if let (Some(asked), Some((_, first))) = (&self.bit_law, &stored.bit_law) {
            let excitation = match &settings.bit.law {
                BitLaw::Rate(law) => law.excitation,
                BitLaw::DetournayDefourny(law) => law.excitation,
                BitLaw::Table(law) => law.excitation,
                BitLaw::Custom(law) => law.excitation,
                BitLaw::Regenerative(_) | BitLaw::Rock(_) => {
                    let message = "a bit law of one's own cuts a rock front of a stiffness: give \
                                   the case a bit law that has one, such as `rate`";
                    return Err(Error::BadInput(message.to_owned()));
                }
            };
            let rock_stiffness_N_per_m = settings.bit.law.stiffness_N_per_m();
            let held = HeldLaw {
                title: asked.title(),
                asked: asked.clone(),
                first: *first,
                failed: failed.clone(),
            };
            let law = Arc::new(held);
            settings.bit.law =
                BitLaw::Custom(CustomLaw { law, rock_stiffness_N_per_m, excitation });
            *operation = settings.bit.drilling_steadily(*operation);
        }
        if let (Some(asked), Some((_, first))) = (&self.excitation, &stored.excitation) {
            let held = HeldShake {
                title: asked.title(),
                asked: asked.clone(),
                first: *first,
                failed: failed.clone(),
            };
            settings.bit.excitation = Some(CustomExcitation::new(held));
        }
        Ok(())
    }
}

/// A law of the bit between two questions: depth of cut and torque in proportion to the weight, as
/// it answered last. A bit that is off the rock is not asked.
#[derive(Debug)]
struct HeldLaw {
    title: String,
    asked: Asked<BitReading, BitAnswer>,
    /// Depth of cut, m/N, and torque, m, per weight at the start.
    first: [f64; 2],
    failed: CancellationToken,
}

impl BitRockLaw for HeldLaw {
    fn name(&self) -> &str {
        &self.title
    }

    /// Time, s; angle, rad; drilled, m; periods begun; depth of cut and torque per weight.
    fn initial_state(&self) -> Vec<f64> {
        let [depth_m_per_N, torque_m] = self.first;
        vec![0.0, 0.0, 0.0, 1.0, depth_m_per_N, torque_m]
    }

    fn cut(&self, state: &[f64], weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let &[.., depth_m_per_N, torque_m] = state else {
            return SteadyCut::default();
        };
        let depth_of_cut_m = depth_m_per_N * weight_on_bit_N;
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: torque_m * weight_on_bit_N,
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }

    fn advance(&self, state: &mut [f64], step: &BitRockStep) {
        let [time_s, angle_rad, drilled_m, periods, depth_m_per_N, torque_m] = state else {
            return;
        };
        *time_s += step.dt_s;
        *angle_rad += step.bit_speed_rad_per_s * step.dt_s;
        *drilled_m += step.advance_m;
        let passed = *time_s * self.asked.rate_Hz + EARLY;
        if passed < *periods || step.weight_on_bit_N <= 0.0 || self.failed.is_cancelled() {
            return;
        }
        *periods = passed.floor() + 1.0;
        let reading = BitReading {
            time_s: *time_s,
            weight_on_bit_N: step.weight_on_bit_N,
            rotary_speed_rad_per_s: step.bit_speed_rad_per_s,
            angle_rad: *angle_rad,
            drilled_m: *drilled_m,
        };
        match (self.asked.ask)(&reading) {
            Some(answer) => {
                *depth_m_per_N = answer.depth_of_cut_m / step.weight_on_bit_N;
                *torque_m = answer.torque_N_m / step.weight_on_bit_N;
            }
            None => {
                self.failed.cancel();
            }
        }
    }
}

/// An excitation between two questions: on the straight line from one answer to the next, which is
/// asked a period ahead.
#[derive(Debug)]
struct HeldShake {
    title: String,
    asked: Asked<ShakeReading, Shake>,
    /// Front, m, and torque at the start and after the first period.
    first: [f64; 4],
    failed: CancellationToken,
}

impl BitExcitation for HeldShake {
    fn name(&self) -> &str {
        &self.title
    }

    /// Time, s; angle, rad; beginning and end of the period, s; front and torque at both.
    fn initial_state(&self) -> Vec<f64> {
        let period_s = 1.0 / self.asked.rate_Hz;
        [0.0, 0.0, 0.0, period_s].into_iter().chain(self.first).collect()
    }

    fn shake(&self, state: &[f64], _bit_angle_rad: f64, time_s: f64) -> Shake {
        let &[_, _, from_s, to_s, front_m, torque, next_front_m, next_torque] = state else {
            return Shake::default();
        };
        let part = (time_s - from_s) / (to_s - from_s);
        Shake {
            front_m: part.mul_add(next_front_m - front_m, front_m),
            torque: part.mul_add(next_torque - torque, torque),
        }
    }

    fn advance(&self, state: &mut [f64], step: &BitRockStep) {
        let [time_s, angle_rad, from_s, to_s, front_m, torque, next_front_m, next_torque] = state
        else {
            return;
        };
        *time_s += step.dt_s;
        *angle_rad += step.bit_speed_rad_per_s * step.dt_s;
        let period_s = (1.0 / self.asked.rate_Hz).max(step.dt_s);
        if *time_s < *to_s - EARLY * period_s || self.failed.is_cancelled() {
            return;
        }
        let next_s = *to_s + period_s;
        let reading = ShakeReading {
            time_s: next_s,
            angle_rad: step.bit_speed_rad_per_s.mul_add(next_s - *time_s, *angle_rad),
        };
        match (self.asked.ask)(&reading) {
            Some(shake) => {
                (*from_s, *to_s) = (*to_s, next_s);
                (*front_m, *torque) = (*next_front_m, *next_torque);
                (*next_front_m, *next_torque) = (shake.front_m, shake.torque);
            }
            None => {
                self.failed.cancel();
            }
        }
    }
}
