//! A coefficient of friction of the caller's own.

use std::{fmt, sync::Arc};

use serde::{Serialize, Serializer};

use crate::well::Friction;

/// The coefficient of friction between string and wall: a law of the caller's own, for
/// [`DynamicsSettings::friction_coefficient`](crate::dynamics::DynamicsSettings).
///
/// Before each step the engine requests the coefficient of every node that touches the wall, or
/// will touch it at its present velocity. Contact force and sliding velocity are those at the end
/// of the previous step: the coefficient lags by one step, the friction does not. The step uses the
/// coefficient like that of the hole: friction stops a node but never reverses it, and dissipates
/// energy but never supplies any, however the coefficient varies.
///
/// The lag counts where the coefficient changes with the sliding speed `v` (m/s). With
/// `q = dt N |dμ/dv|/m` (step `dt`, contact force `N`, mass of the node `m`) the rate at which the
/// speed settles, or breaks away, is wrong by a part of `q/2`; a coefficient that grows with the
/// speed makes it alternate from step to step where `q > 1`. A node of 100 kg pressed on the wall
/// with 1 kN has `q = 0.05` in a step of 0.5 ms where the coefficient changes by 0.1 within 1 cm/s.
/// A coefficient that falls with the speed makes sliding unstable, in the model as in the hole:
/// that is how a string sticks and slips. See `docs/src/theory/friction.md`.
///
/// A prepared start places the string with the hole's own coefficients, as the soft string has
/// them. The law object does not change. Its `state` between steps consists of numbers for each
/// node, which the engine stores and writes to checkpoints: a run resumes with the same bits. See
/// the example `friction_law`.
pub trait FrictionCoefficient: fmt::Debug + Send + Sync {
    /// Name, by which a checkpoint knows the law again.
    fn name(&self) -> &str;

    /// Initial state of the law at each node, with the same count of numbers in every run. None by
    /// default.
    fn initial_state(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Coefficient of axial friction, zero or more; around the hole it is multiplied by the
    /// section's [ratio](Friction::around). One that is negative, infinite or not a number ends the
    /// run as [diverged](crate::dynamics::Diverged). `state` belongs to the node. The method is not
    /// called for a node that is off the wall.
    fn coefficient(&self, state: &mut [f64], contact: &SlidingContact) -> f64;
}

/// A node of the string on the wall, as the step before has left it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingContact {
    /// Length of the step that follows, s.
    pub dt_s: f64,
    /// Measured depth, m.
    pub md_m: f64,
    /// Position on the string: distance from the bit along the unloaded string, m.
    pub from_bit_m: f64,
    /// Contact force, N; zero where the step before was the run's first or left it off the wall.
    pub normal_force_N: f64,
    /// Sliding velocity along the hole, m/s, positive towards the bit.
    pub axial_velocity_m_per_s: f64,
    /// Sliding velocity around the hole, m/s, positive clockwise looking down.
    pub circumferential_velocity_m_per_s: f64,
    /// The coefficients of the hole section.
    pub friction: Friction,
}

impl SlidingContact {
    /// Sliding speed, m/s.
    pub fn sliding_speed_m_per_s(&self) -> f64 {
        libm::hypot(self.axial_velocity_m_per_s, self.circumferential_velocity_m_per_s)
    }
}

/// The law of [`DynamicsSettings`](crate::dynamics::DynamicsSettings).
#[derive(Debug, Clone, Serialize)]
pub struct CustomFriction {
    /// The law; its name alone in the record of a run.
    #[serde(rename = "name", serialize_with = "name_of")]
    pub law: Arc<dyn FrictionCoefficient>,
}

fn name_of<S: Serializer>(law: &Arc<dyn FrictionCoefficient>, to: S) -> Result<S::Ok, S::Error> {
    law.name().serialize(to)
}

/// The same law, not one of the same name.
impl PartialEq for CustomFriction {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.law, &other.law)
    }
}

impl CustomFriction {
    /// A law for the settings.
    pub fn new(law: impl FrictionCoefficient + 'static) -> Self {
        Self { law: Arc::new(law) }
    }
}
