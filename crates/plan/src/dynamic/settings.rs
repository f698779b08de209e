//! Dynamic runs of a plan.

use wholestring::{
    dynamics::{DynamicsSettings, HoistSetPoint, Precision, Schedule, ScheduleStep, Start},
    operation::Operation,
};

use super::Event;
use crate::FrictionLevel;

/// Time at rest before an event, s, in which the disturbance of the start is damped.
pub(super) const REST_S: f64 = 3.0;

/// Dynamic runs of a plan.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct DynamicPlan {
    /// Events whose peaks are computed.
    pub events: Vec<Event>,
    /// Set points that they lead to: trip speed, rotary speed, flow rate. Kind and depth are not
    /// used.
    pub set_points: Option<Operation>,
    /// Depths of the bit, m, increasing.
    pub bit_depths_m: Vec<f64>,
    /// Friction levels of the events.
    pub frictions: Vec<FrictionLevel>,
    /// Time in which the block reaches its speed, s.
    pub hoist_ramp_s: f64,
    /// Time in which the pumps reach their flow rate, s.
    pub pump_ramp_s: f64,
    /// Time in which the rotary reaches its speed, s.
    pub rotary_ramp_s: f64,
    /// Observation time after the ramp, s.
    pub watch_s: f64,
    /// Gel strength of the mud, Pa; `None` by default.
    pub gel_strength_Pa: Option<f64>,
    /// Operations of the campaign whose wear is computed from the friction work of the dynamics.
    pub wear: Vec<Operation>,
}

impl Default for DynamicPlan {
    /// No events; the friction is the expected one.
    fn default() -> Self {
        Self {
            events: Vec::new(),
            set_points: None,
            bit_depths_m: Vec::new(),
            frictions: vec![FrictionLevel::Expected],
            hoist_ramp_s: 2.0,
            pump_ramp_s: 10.0,
            rotary_ramp_s: 5.0,
            watch_s: 20.0,
            gel_strength_Pa: None,
            wear: Vec::new(),
        }
    }
}

impl DynamicPlan {
    /// Returns the time in which an event changes its set point, s.
    pub fn ramp_s(&self, event: Event) -> f64 {
        match event {
            Event::PickUpFromSlips | Event::SlackOffFromSlips => self.hoist_ramp_s,
            Event::BreakCirculation => self.pump_ramp_s,
            Event::BreakRotation => self.rotary_ramp_s,
        }
    }

    /// Returns the operation that an event leads to, with the bit at a depth, m; `None` without set
    /// points.
    pub(super) fn operation(&self, event: Event, bit_depth_m: f64) -> Option<Operation> {
        let set = self.set_points?;
        Some(Operation { kind: event.operation(), bit_depth_m, ..set })
    }

    /// Returns the settings of a run that begins at rest, ramps the event's set point to its value,
    /// and then watches. Its window is the time after the rest.
    pub(super) fn run(
        &self,
        event: Event,
        operation: &Operation,
        dynamics: &DynamicsSettings,
    ) -> DynamicsSettings {
        let ramp_s = self.ramp_s(event);
        let still = ScheduleStep {
            rotary_speed_rad_per_s: Some(0.0),
            hoist: Some(HoistSetPoint::BlockVelocity(0.0)),
            flow_rate_m3_per_s: Some(0.0),
            ..ScheduleStep::default()
        };
        let at = ScheduleStep { at_s: REST_S, ramp_s, ..ScheduleStep::default() };
        let moves = match event {
            Event::PickUpFromSlips | Event::SlackOffFromSlips => {
                let speed = operation.axial_velocity_m_per_s();
                ScheduleStep { hoist: Some(HoistSetPoint::BlockVelocity(speed)), ..at }
            }
            Event::BreakCirculation => {
                ScheduleStep { flow_rate_m3_per_s: Some(operation.flow_rate_m3_per_s), ..at }
            }
            Event::BreakRotation => {
                let speed = operation.rotary_speed_rad_per_s;
                ScheduleStep { rotary_speed_rad_per_s: Some(speed), ..at }
            }
        };
        DynamicsSettings {
            schedule: Schedule { steps: vec![still, moves] },
            hoist_control: None,
            start: Start::Prepared,
            settle_s: REST_S,
            steady: None,
            duration_s: ramp_s + self.watch_s,
            // A string that settles to rest needs double precision.
            precision: Precision::Double,
            probes: Vec::new(),
            ..dynamics.clone()
        }
    }
}
