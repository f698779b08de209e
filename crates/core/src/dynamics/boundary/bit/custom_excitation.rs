//! An excitation of the caller's own.

use std::{fmt, sync::Arc};

use serde::{Deserialize, Serialize, Serializer};

use super::{BitRockStep, Shake};
use crate::{
    damage::{Damaged, ensure},
    dynamics::boundary::extension::{AnotherExtension, Extension},
};

/// A user-defined excitation of the bit, for
/// [`BitSettings::excitation`](crate::dynamics::BitSettings), under any law that cuts at a given
/// rate ([`BitLaw::Rate`](crate::dynamics::BitLaw), `DetournayDefourny`, `Table` and `Custom`).
///
/// It is added to the excitation of the law itself. The excitation object does not change. Its
/// `state` between steps consists of numbers, which the engine stores and writes to checkpoints: a
/// run resumes with the same bits. See the example `excitation`.
pub trait BitExcitation: fmt::Debug + Send + Sync {
    /// Name, by which a checkpoint knows the excitation again.
    fn name(&self) -> &str;

    /// Initial state of the excitation, with the same count of numbers in every run. None by
    /// default.
    fn initial_state(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Returns the excitation after the bit has turned through an angle, rad, at a time, s, both
    /// from the start of the run.
    fn shake(&self, state: &[f64], bit_angle_rad: f64, time_s: f64) -> Shake;

    /// Updates the state after each step. Does nothing by default.
    fn advance(&self, _state: &mut [f64], _step: &BitRockStep) {}
}

/// The excitation of [`BitSettings`](crate::dynamics::BitSettings).
#[derive(Debug, Clone, Serialize)]
pub struct CustomExcitation {
    /// The excitation; its name alone in the record of a run.
    #[serde(rename = "name", serialize_with = "name_of")]
    pub excitation: Arc<dyn BitExcitation>,
}

fn name_of<S: Serializer>(excitation: &Arc<dyn BitExcitation>, to: S) -> Result<S::Ok, S::Error> {
    excitation.name().serialize(to)
}

/// The same excitation, not one of the same name.
impl PartialEq for CustomExcitation {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.excitation, &other.excitation)
    }
}

impl CustomExcitation {
    /// An excitation for the settings.
    pub fn new(excitation: impl BitExcitation + 'static) -> Self {
        Self { excitation: Arc::new(excitation) }
    }
}

/// The excitation in a run.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct CustomShaker {
    excitation: Extension<dyn BitExcitation>,
    /// Additional depth of the front at the start, m, because the operation begins with its weight.
    start_m: f64,
    angle_rad: f64,
    time_s: f64,
}

impl CustomShaker {
    pub(super) fn new(custom: &CustomExcitation) -> Self {
        let excitation = &custom.excitation;
        let state = excitation.initial_state();
        Self {
            start_m: excitation.shake(&state, 0.0, 0.0).front_m,
            excitation: Extension::new(excitation, excitation.name(), state),
            angle_rad: 0.0,
            time_s: 0.0,
        }
    }

    /// Gives an excitation that has been read back its own.
    pub(super) fn attach(&mut self, custom: &CustomExcitation) -> Result<(), AnotherExtension> {
        let excitation = &custom.excitation;
        let (name, numbers) = (excitation.name(), excitation.initial_state().len());
        self.excitation.attach("the excitation of the bit", excitation, name, numbers)
    }

    /// Whether a stored excitation is one of these settings; a bit off bottom has none.
    pub(super) fn check(
        stored: Option<&Self>,
        custom: Option<&CustomExcitation>,
    ) -> Result<(), Damaged> {
        let fits = match (stored, custom) {
            (Some(stored), Some(_)) => stored.excitation.is_attached(),
            (stored, custom) => stored.is_none() && custom.is_none(),
        };
        ensure(fits, "the excitation of the bit")
    }

    /// The excitation after a turn and a time more.
    pub(super) fn next(&self, turn_rad: f64, dt: f64) -> Shake {
        let Some((excitation, state)) = self.excitation.get() else {
            return Shake::default();
        };
        let shake = excitation.shake(state, self.angle_rad + turn_rad, self.time_s + dt);
        Shake { front_m: shake.front_m - self.start_m, ..shake }
    }

    /// Continues by a step.
    pub(super) fn advance(&mut self, step: &BitRockStep) {
        self.angle_rad += step.bit_speed_rad_per_s * step.dt_s;
        self.time_s += step.dt_s;
        if let Some((excitation, state)) = self.excitation.get_mut() {
            excitation.advance(state, step);
        }
    }
}
