//! What limits are compared with beside the model.

use super::DesignFactors;
use crate::strength::PipeClass;

/// What is known of a component's strength beside its dimensions and yield strength.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ComponentRatings {
    /// Class of its wear.
    pub class: PipeClass,
    /// Make-up torque of its connections, N·m.
    pub make_up_torque_N_m: Option<f64>,
    /// Torque at which its tool joints yield, N·m.
    pub joint_torsional_yield_N_m: Option<f64>,
    /// Tension at which its tool joints yield, N.
    pub joint_tensile_yield_N: Option<f64>,
}

/// What is known of the rig beside hoist and rated torque.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RigRatings {
    /// Largest torque of the top drive, N·m, for a short time.
    pub top_drive_peak_torque_N_m: Option<f64>,
    /// Largest pressure of the pump, Pa.
    pub pump_pressure_Pa: Option<f64>,
}

/// What limits are compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitSettings {
    /// The factors that are required.
    pub factors: DesignFactors,
    /// Overpull that is asked for, N. Default 445 kN, 100,000 lbf: 50,000 to 100,000 lbf are commonly
    /// planned.
    pub overpull_N: f64,
    /// Of each component, from the bit up; those beyond the end have none.
    pub components: Vec<ComponentRatings>,
    /// Of the rig.
    pub rig: RigRatings,
}

impl Default for LimitSettings {
    fn default() -> Self {
        Self {
            factors: DesignFactors::default(),
            overpull_N: 444.822e3,
            components: Vec::new(),
            rig: RigRatings::default(),
        }
    }
}
