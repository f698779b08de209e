//! Set points of the driller.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring::{
    dynamics::{HoistSetPoint, ScheduleStep},
    operation::Operation,
};
use wholestring_case::MAX_FRICTION;
use wholestring_judge::{Quantity, Rounding};
use wholestring_units::{Dimension, number_text};

/// Set points of the driller; omitted ones stay unchanged.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields, default)]
#[schema(as = LiveSetPoints)]
pub struct SetPoints {
    /// Rotary speed at surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub rotary_speed_rad_per_s: Option<f64>,
    /// Speed of the block, positive downwards; replaces the autodriller.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub block_velocity_m_per_s: Option<f64>,
    /// Weight held by the autodriller; replaces a moving block.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub weight_on_bit_N: Option<f64>,
    /// Flow rate of the pumps.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub flow_rate_m3_per_s: Option<f64>,
    /// Kinetic friction coefficient of the whole hole.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub friction: Option<f64>,
    /// The top drive's controller: `pi`, `soft-torque` or `z-torque`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub controller: Option<String>,
    /// Time in which they are reached, s.
    pub ramp_s: f64,
}

/// The bounds of a line of `[[operation.schedule]]`, so that the actions can be saved.
pub const MAX_ROTARY_SPEED_RAD_PER_S: f64 = 1000.0 * PI / 30.0;
pub const MAX_BLOCK_VELOCITY_M_PER_S: f64 = 10.0;
pub const MAX_WEIGHT_ON_BIT_N: f64 = 5e6;
pub const MAX_FLOW_RATE_M3_PER_S: f64 = 0.5;
const MAX_RAMP_S: f64 = 86_400.0;

impl SetPoints {
    /// Whether nothing is set.
    pub fn is_empty(&self) -> bool {
        *self == Self { ramp_s: self.ramp_s, ..Self::default() }
    }

    /// Adds later set points; block and autodriller replace each other.
    pub(super) fn merge(&mut self, later: Self) {
        if later.block_velocity_m_per_s.is_some() || later.weight_on_bit_N.is_some() {
            self.block_velocity_m_per_s = later.block_velocity_m_per_s;
            self.weight_on_bit_N = later.weight_on_bit_N;
        }
        let Self { rotary_speed_rad_per_s, flow_rate_m3_per_s, friction, controller, .. } = later;
        self.rotary_speed_rad_per_s = rotary_speed_rad_per_s.or(self.rotary_speed_rad_per_s);
        self.flow_rate_m3_per_s = flow_rate_m3_per_s.or(self.flow_rate_m3_per_s);
        self.friction = friction.or(self.friction);
        self.controller = controller.or(self.controller.take());
        self.ramp_s = later.ramp_s;
    }

    /// The reason why an operation refuses these set points, as a sentence with marked quantities.
    pub(super) fn fault(&self, operation: &Operation) -> Option<String> {
        let ranges = [
            (
                "rotary speed",
                Dimension::RotarySpeed,
                self.rotary_speed_rad_per_s,
                [0.0, MAX_ROTARY_SPEED_RAD_PER_S],
            ),
            (
                "speed of the block",
                Dimension::TripSpeed,
                self.block_velocity_m_per_s,
                [-MAX_BLOCK_VELOCITY_M_PER_S, MAX_BLOCK_VELOCITY_M_PER_S],
            ),
            ("weight on bit", Dimension::Force, self.weight_on_bit_N, [0.0, MAX_WEIGHT_ON_BIT_N]),
            (
                "flow rate",
                Dimension::FlowRate,
                self.flow_rate_m3_per_s,
                [0.0, MAX_FLOW_RATE_M3_PER_S],
            ),
            ("ramp", Dimension::Time, Some(self.ramp_s), [0.0, MAX_RAMP_S]),
        ];
        for (name, dimension, value, [low, high]) in ranges {
            if let Some(value) = value
                && !(low..=high).contains(&value)
            {
                let text = |si| Quantity::new(dimension, si, Rounding::Four);
                let [value, low, high] = [value, low, high].map(text);
                return Some(format!(
                    "The {name} of {value} is out of range: expected {low} to {high}. It was not set"
                ));
            }
        }
        if let Some(friction) = self.friction.filter(|value| !(0.0..=MAX_FRICTION).contains(value))
        {
            return Some(format!(
                "The friction coefficient of {} is out of range: expected 0 to {MAX_FRICTION}. It \
                 was not set",
                number_text(friction)
            ));
        }
        let (kind, turns) = (operation.kind, self.rotary_speed_rad_per_s.unwrap_or(0.0) > 0.0);
        if turns && !kind.rotates() {
            return Some(format!("`{}` does not turn the string", kind.name()));
        }
        if self.weight_on_bit_N.is_some() && operation.weight_on_bit_now_N() <= 0.0 {
            return Some(format!("the bit of `{}` is off bottom: it has no weight", kind.name()));
        }
        if self.weight_on_bit_N.is_some() && self.block_velocity_m_per_s.is_some() {
            return Some("the hoist cannot keep a weight and a speed at the same time".to_owned());
        }
        None
    }

    /// The line of the schedule from now on; none if no line can express it.
    pub(super) fn line(&self, now_s: f64) -> Option<ScheduleStep> {
        let block = self.block_velocity_m_per_s.map(HoistSetPoint::BlockVelocity);
        let hoist = block.or(self.weight_on_bit_N.map(HoistSetPoint::WeightOnBit));
        let line = ScheduleStep {
            at_s: now_s,
            ramp_s: self.ramp_s,
            rotary_speed_rad_per_s: self.rotary_speed_rad_per_s,
            hoist,
            flow_rate_m3_per_s: self.flow_rate_m3_per_s,
            note: None,
        };
        let moves = line.rotary_speed_rad_per_s.is_some()
            || line.hoist.is_some()
            || line.flow_rate_m3_per_s.is_some();
        moves.then_some(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_later_holds_and_block_and_autodriller_replace_each_other() {
        let weight = SetPoints { weight_on_bit_N: Some(5e4), ..SetPoints::default() };
        let speed = SetPoints { rotary_speed_rad_per_s: Some(9.0), ramp_s: 2.0, ..weight.clone() };
        let block = SetPoints { block_velocity_m_per_s: Some(-0.1), ..SetPoints::default() };
        let mut all = weight;
        all.merge(speed);
        assert_eq!((all.rotary_speed_rad_per_s, all.ramp_s), (Some(9.0), 2.0));
        all.merge(block);
        assert_eq!((all.block_velocity_m_per_s, all.weight_on_bit_N), (Some(-0.1), None));
        assert_eq!(all.rotary_speed_rad_per_s, Some(9.0));
        assert!(SetPoints { ramp_s: 3.0, ..SetPoints::default() }.is_empty());
    }
}
