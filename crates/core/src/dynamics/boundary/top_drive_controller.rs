//! A controller of the top drive of the caller's own.

use std::{fmt, sync::Arc};

use serde::{Deserialize, Serialize, Serializer};

use crate::dynamics::boundary::extension::{AnotherExtension, Extension};

/// A user-defined controller of the top drive, for
/// [`TopDriveSettings::Custom`](crate::dynamics::TopDriveSettings).
///
/// It acts once a step, as a digital controller does, on the values at the step's beginning: a gain
/// of more than the drive's inertia over half a step is not stable. The controller object does not
/// change. Its `state` between steps consists of numbers, which the engine stores and writes to
/// checkpoints: a run resumes with the same bits. See the example `top_drive_controller`.
pub trait TopDriveController: fmt::Debug + Send + Sync {
    /// Name, by which a checkpoint knows the controller again.
    fn name(&self) -> &str;

    /// Initial state of the controller, with the same count of numbers in every run. The string is
    /// held with `torque_N_m` when the run begins, so an integral part starts at that torque.
    fn initial_state(&self, torque_N_m: f64) -> Vec<f64>;

    /// Torque of the drive over the step that follows, N·m, clockwise looking down the hole. The
    /// drive gives no more than its limit.
    fn torque_N_m(&self, state: &mut [f64], reading: &TopDriveReading) -> f64;
}

/// Inputs of a controller of the top drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopDriveReading {
    /// Length of the step that follows, s.
    pub dt_s: f64,
    /// Speed that the driller has set, rad/s.
    pub set_rad_per_s: f64,
    /// Speed of the drive, rad/s.
    pub speed_rad_per_s: f64,
    /// Torque of the string on the drive, N·m, positive where it holds it back.
    pub string_torque_N_m: f64,
    /// Largest torque that the drive gives, N·m; infinite without a limit.
    pub torque_limit_N_m: f64,
}

/// A drive with inertia under a controller of the caller's own.
#[derive(Debug, Clone, Serialize)]
pub struct CustomTopDrive {
    /// Moment of inertia of everything that turns with the string at its speed, kg·m².
    pub inertia_kg_m2: f64,
    /// The controller of the torque; only its name is in the record of a run.
    #[serde(rename = "name", serialize_with = "name_of")]
    pub controller: Arc<dyn TopDriveController>,
    /// Largest torque that it gives, N·m; `None` sets no limit.
    pub torque_limit_N_m: Option<f64>,
}

fn name_of<S: Serializer>(law: &Arc<dyn TopDriveController>, to: S) -> Result<S::Ok, S::Error> {
    law.name().serialize(to)
}

/// The same controller, not one of the same name.
impl PartialEq for CustomTopDrive {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.controller, &other.controller)
            && self.inertia_kg_m2 == other.inertia_kg_m2
            && self.torque_limit_N_m == other.torque_limit_N_m
    }
}

/// The controller in a run.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct CustomDrive {
    controller: Extension<dyn TopDriveController>,
    limit_N_m: f64,
}

impl CustomDrive {
    /// The controller of a drive that holds the string with a torque.
    pub(super) fn new(custom: &CustomTopDrive, torque_N_m: f64) -> Self {
        let controller = &custom.controller;
        let state = controller.initial_state(torque_N_m);
        Self {
            controller: Extension::new(controller, controller.name(), state),
            limit_N_m: custom.torque_limit_N_m.unwrap_or(f64::INFINITY),
        }
    }

    /// Gives a controller that has been read back its own.
    pub(super) fn attach(&mut self, custom: &CustomTopDrive) -> Result<(), AnotherExtension> {
        let controller = &custom.controller;
        let numbers = controller.initial_state(0.0).len();
        let role = "the controller of the top drive";
        self.controller.attach(role, controller, controller.name(), numbers)
    }

    /// Torque of the drive over a step, N·m, and whether it is at its limit.
    pub(super) fn torque_N_m(
        &mut self,
        set_rad_per_s: f64,
        speed_rad_per_s: f64,
        string_torque_N_m: f64,
        dt_s: f64,
    ) -> (f64, bool) {
        let reading = TopDriveReading {
            dt_s,
            set_rad_per_s,
            speed_rad_per_s,
            string_torque_N_m,
            torque_limit_N_m: self.limit_N_m,
        };
        let demand_N_m = match self.controller.get_mut() {
            Some((controller, state)) => controller.torque_N_m(state, &reading),
            None => string_torque_N_m,
        };
        let limit = self.limit_N_m;
        (demand_N_m.clamp(-limit, limit), demand_N_m.abs() > limit)
    }
}
