//! What a plan asks of the dynamics.

use wholestring::{
    dynamics::{DynamicsSettings, HoistSetPoint, Precision, Schedule, ScheduleStep, Start},
    operation::Operation,
};

use super::Event;
use crate::FrictionLevel;

/// How long the string hangs at rest before an event, s: what the start stirs up is damped meanwhile.
pub(super) const REST_S: f64 = 3.0;

/// What a plan asks of the dynamics.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct DynamicPlan {
    /// Events whose peaks are looked for.
    pub events: Vec<Event>,
    /// Set points that they lead to: trip speed, rotary speed, flow rate. Kind and depth do not count.
    pub set_points: Option<Operation>,
    /// Depths of the bit, m, growing.
    pub bit_depths_m: Vec<f64>,
    /// Frictions that they are looked for with.
    pub frictions: Vec<FrictionLevel>,
    /// Time in which the block comes to its speed, s.
    pub hoist_ramp_s: f64,
    /// Time in which the pumps come to their flow rate, s.
    pub pump_ramp_s: f64,
    /// Time in which the rotary comes to its speed, s.
    pub rotary_ramp_s: f64,
    /// How long the string is watched after that, s.
    pub watch_s: f64,
    /// Gel strength of the mud, Pa; none by default.
    pub gel_strength_Pa: Option<f64>,
    /// Operations of the campaign whose wear is the dynamics' work of friction.
    pub wear: Vec<Operation>,
}

impl Default for DynamicPlan {
    /// Nothing is asked; what is asked is looked at with the friction that is expected.
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
    /// Time in which an event brings its set point to its value, s.
    pub fn ramp_s(&self, event: Event) -> f64 {
        match event {
            Event::PickUpFromSlips | Event::SlackOffFromSlips => self.hoist_ramp_s,
            Event::BreakCirculation => self.pump_ramp_s,
            Event::BreakRotation => self.rotary_ramp_s,
        }
    }

    /// The operation that an event leads to, with the bit at a depth, m; none where no set points are given.
    pub(super) fn operation(&self, event: Event, bit_depth_m: f64) -> Option<Operation> {
        let set = self.set_points?;
        Some(Operation { kind: event.operation(), bit_depth_m, ..set })
    }

    /// The settings of a run that begins at rest, has the event's set point come to its value, and watches. Its
    /// window is what comes after the rest.
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
            // A string that comes to rest needs all digits.
            precision: Precision::Double,
            probes: Vec::new(),
            ..dynamics.clone()
        }
    }
}
