//! A law of the bit of the caller's own.

use std::{fmt, sync::Arc};

use serde::{Deserialize, Serialize, Serializer};

use super::rules::{CutStart, LawRules};
use crate::dynamics::{
    assemble::SetupError,
    boundary::{
        bit::{
            cutters::SteadyCut,
            excitation::{Excitation, Shake, Shaker},
            front::{FrontCut, FrontRule, Press, check_front},
            step::BitRockStep,
        },
        extension::{AnotherExtension, Extension},
    },
};

/// A user-defined law of the bit on rock, for [`BitLaw::Custom`](crate::dynamics::BitLaw).
///
/// The rock front is at the depth that the bit has cut, with the stiffness of [`CustomLaw`]. In
/// each step the engine finds the weight at which the front's compression and its advance agree,
/// evaluates rate and torque with [`cut`](Self::cut), and never lets the rock pull the bit down or
/// turn it back. The bit's side force, its motor and the noise of [`Excitation`] are modelled by
/// the engine; an excitation that does not need the law is a
/// [`BitExcitation`](crate::dynamics::BitExcitation).
///
/// The law object does not change. Its `state` between steps consists of numbers, which the engine
/// stores and writes to checkpoints: a run resumes with the same bits. See the example `bit_law`.
pub trait BitRockLaw: fmt::Debug + Send + Sync {
    /// Name, by which a checkpoint knows the law again.
    fn name(&self) -> &str;

    /// Initial state of the law, with the same count of numbers in every run. None by default.
    fn initial_state(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Returns the bit's torque and rate of penetration under a weight on bit, N, and at its speed,
    /// motor included, rad/s. The rate of penetration must not fall as the weight grows, and is
    /// taken as zero where it is negative.
    fn cut(&self, state: &[f64], weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut;

    /// Returns the excitation after the bit has turned through an angle, rad, at a time, s, both
    /// from the start of the run. Nothing by default.
    fn shake(&self, _state: &[f64], _bit_angle_rad: f64, _time_s: f64) -> Shake {
        Shake::default()
    }

    /// Updates the state after each step. Does nothing by default.
    fn advance(&self, _state: &mut [f64], _step: &BitRockStep) {}
}

/// A user-defined law with the stiffness of the rock and an excitation of the bit.
#[derive(Debug, Clone, Serialize)]
pub struct CustomLaw {
    /// The law; its name alone in the record of a run.
    #[serde(rename = "name", serialize_with = "name_of")]
    pub law: Arc<dyn BitRockLaw>,
    /// Stiffness of the contact between bit and rock front, N/m.
    pub rock_stiffness_N_per_m: f64,
    /// Excitation of the bit in addition to the law; `None` for none.
    pub excitation: Option<Excitation>,
}

fn name_of<S: Serializer>(law: &Arc<dyn BitRockLaw>, to: S) -> Result<S::Ok, S::Error> {
    law.name().serialize(to)
}

/// The same law, not one of the same name.
impl PartialEq for CustomLaw {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.law, &other.law)
            && self.rock_stiffness_N_per_m == other.rock_stiffness_N_per_m
            && self.excitation == other.excitation
    }
}

impl CustomLaw {
    /// A law on rock of a stiffness, N/m, without noise.
    pub fn new(law: impl BitRockLaw + 'static, rock_stiffness_N_per_m: f64) -> Self {
        Self { law: Arc::new(law), rock_stiffness_N_per_m, excitation: None }
    }

    /// Steady drilling from the law's initial state under a weight on bit, at a speed.
    pub fn steady(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let state = self.law.initial_state();
        self.law.cut(&state, weight_on_bit_N, rotary_speed_rad_per_s)
    }
}

impl LawRules for CustomLaw {
    type Cut = FrontCut<CustomCut>;

    fn check(&self) -> Result<(), SetupError> {
        check_front(self.rock_stiffness_N_per_m, self.excitation.as_ref())
    }

    fn stiffness_N_per_m(&self) -> f64 {
        self.rock_stiffness_N_per_m
    }

    fn steady_cut(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> Option<SteadyCut> {
        Some(self.steady(weight_on_bit_N, rotary_speed_rad_per_s))
    }

    fn begin(&self, start: &CutStart<'_>) -> Option<Self::Cut> {
        let law = CustomCut::new(self);
        Some(FrontCut::new(law, self.rock_stiffness_N_per_m, self.excitation, start))
    }
}

/// The law in a run.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct CustomCut {
    law: Extension<dyn BitRockLaw>,
    angle_rad: f64,
    time_s: f64,
}

impl CustomCut {
    fn new(custom: &CustomLaw) -> Self {
        let law = &custom.law;
        Self {
            law: Extension::new(law, law.name(), law.initial_state()),
            angle_rad: 0.0,
            time_s: 0.0,
        }
    }

    fn cut_at(&self, weight_N: f64, speed_rad_per_s: f64) -> SteadyCut {
        match self.law.get() {
            Some((law, state)) => law.cut(state, weight_N, speed_rad_per_s),
            None => SteadyCut::default(),
        }
    }
}

impl FrontRule for CustomCut {
    type Law = CustomLaw;

    fn is_of(&self, _law: &CustomLaw) -> bool {
        self.law.is_attached()
    }

    fn attach(&mut self, custom: &CustomLaw) -> Result<(), AnotherExtension> {
        let law = &custom.law;
        let numbers = law.initial_state().len();
        self.law.attach("the law of the bit", law, law.name(), numbers)
    }

    fn press(&self, press: &Press, turning_rad_per_s: f64) -> (f64, f64) {
        press.on_rate(|weight| self.cut_at(weight, turning_rad_per_s).rate_of_penetration_m_per_s)
    }

    fn cut(&mut self, weight_N: f64, turning_rad_per_s: f64) -> (f64, f64) {
        let cut = self.cut_at(weight_N, turning_rad_per_s);
        (cut.torque_N_m, cut.depth_of_cut_m)
    }

    /// The law's own, and noise besides.
    fn shake(
        &self,
        shaker: Option<&Shaker>,
        _weight_N: f64,
        _turning_rad_per_s: f64,
        turn_rad: f64,
        dt: f64,
    ) -> Shake {
        let own = match self.law.get() {
            Some((law, state)) => law.shake(state, self.angle_rad + turn_rad, self.time_s + dt),
            None => Shake::default(),
        };
        let Some(shaker) = shaker else {
            return own;
        };
        let noise = shaker.next(turn_rad, dt);
        Shake { front_m: own.front_m + noise.front_m, torque: own.torque + noise.torque }
    }

    fn advance(&mut self, step: &BitRockStep) {
        self.angle_rad += step.bit_speed_rad_per_s * step.dt_s;
        self.time_s += step.dt_s;
        if let Some((law, state)) = self.law.get_mut() {
            law.advance(state, step);
        }
    }
}
