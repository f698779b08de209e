//! The peak of a series, and the series.

use serde::{Deserialize, Serialize};
use wholestring::{
    dynamics::Frame,
    operation::Event,
    outcome::{Profile, TimeSeries},
};
use wholestring_judge::CheckKind;

use super::settings::REST_S;

/// Time before the event over which the value at rest is averaged, s.
const BEFORE_S: f64 = 0.5;

/// Part of the watch at its end over which the steady value is averaged.
const END: f64 = 0.25;

/// Direction of a peak relative to the value at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Toward {
    /// Towards larger values.
    More,
    /// Towards smaller values.
    Less,
    /// Towards the steady value.
    Steady,
}

/// Peak of a quantity in an event.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Peak {
    /// Value before the event.
    pub at_rest: f64,
    /// Value farthest from that at rest at any sample, in the direction of the change.
    pub peak: f64,
    /// Time of the peak, s from the beginning of the event.
    pub time_s: f64,
    /// Steady value: the mean over the last quarter of the watch.
    pub steady: f64,
    /// Steady value less the mean over the quarter before.
    pub drift: f64,
}

impl Peak {
    /// Returns the peak over the steady value; `None` where that is zero.
    pub fn ratio(&self) -> Option<f64> {
        let ratio = self.peak / self.steady;
        ratio.is_finite().then_some(ratio)
    }

    /// Returns the excess of the peak over the steady value, as a part of the change; `None`
    /// without a change.
    pub fn overshoot(&self) -> Option<f64> {
        let change = self.steady - self.at_rest;
        let least = 1e-6 * self.steady.abs().max(self.at_rest.abs());
        (change.abs() > least).then(|| (self.peak - self.steady) / change)
    }

    /// Returns the peak of samples at times from the beginning of the event, s, of which the last
    /// `watch_s` are the watch.
    pub(super) fn of(
        times_s: &[f64],
        values: &[f64],
        watch_s: f64,
        toward: Toward,
    ) -> Option<Self> {
        let pairs = || times_s.iter().copied().zip(values.iter().copied());
        let mean = |from_s: f64, to_s: f64| {
            let within = pairs().filter(|(time_s, _)| *time_s > from_s && *time_s <= to_s);
            let (sum, count) =
                within.fold((0.0, 0.0), |(sum, n), (_, value)| (sum + value, n + 1.0));
            (count > 0.0).then_some(sum / count)
        };
        let end_s = *times_s.last()?;
        let part_s = END * watch_s;
        let at_rest = mean(-BEFORE_S, 0.0)?;
        let steady = mean(end_s - part_s, end_s)?;
        let before = mean(end_s - 2.0 * part_s, end_s - part_s)?;
        let after = pairs().filter(|(time_s, _)| *time_s > 0.0);
        let up = match toward {
            Toward::More => true,
            Toward::Less => false,
            Toward::Steady => steady >= at_rest,
        };
        let far = |(_, value): &(f64, f64)| if up { *value } else { -*value };
        let (time_s, peak) = after.max_by(|a, b| far(a).total_cmp(&far(b)))?;
        Some(Self { at_rest, peak, time_s, steady, drift: steady - before })
    }
}

/// An event at surface, sample by sample.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct History {
    /// Time from the beginning of the event, s.
    pub time_s: Vec<f64>,
    /// Hook load without block, N.
    pub hook_load_N: Vec<f64>,
    /// Torque at the top of the string, N·m.
    pub surface_torque_N_m: Vec<f64>,
    /// Pressure of the pump, Pa; `None` without a rheology.
    pub pump_pressure_Pa: Vec<Option<f64>>,
    /// Speed of the block, m/s, positive downwards.
    pub block_velocity_m_per_s: Vec<f64>,
    /// Rotary speed at surface, rad/s.
    pub rotary_speed_rad_per_s: Vec<f64>,
    /// Flow rate of the pumps, m³/s.
    pub flow_rate_m3_per_s: Vec<f64>,
}

impl History {
    /// Returns the history from half a second before the event on.
    pub(super) fn of(series: &TimeSeries) -> Self {
        let first = series.time_s.partition_point(|time_s| *time_s <= REST_S - BEFORE_S);
        Self {
            time_s: series.time_s[first..].iter().map(|time_s| time_s - REST_S).collect(),
            hook_load_N: series.hook_load_N[first..].to_vec(),
            surface_torque_N_m: series.surface_torque_N_m[first..].to_vec(),
            pump_pressure_Pa: series.pump_pressure_Pa[first..].to_vec(),
            block_velocity_m_per_s: series.block_velocity_m_per_s[first..].to_vec(),
            rotary_speed_rad_per_s: series.rotary_speed_rad_per_s[first..].to_vec(),
            flow_rate_m3_per_s: series.flow_rate_m3_per_s[first..].to_vec(),
        }
    }
}

// The largest tension and torque of every node during an event.

/// Extremes of each node, from the surface down.
#[derive(Debug, Default)]
pub(super) struct Extremes {
    /// Depths of the nodes before they move, m.
    md_m: Vec<f64>,
    most_tension_N: Vec<f64>,
    torque_N_m: Vec<[f64; 2]>,
}

impl Extremes {
    /// Adds a frame.
    pub(super) fn see(&mut self, frame: &Frame) {
        if self.md_m.is_empty() {
            // The upper end of a string that is longer than the hole to its bit, by its stretch, is
            // at the surface.
            self.md_m = frame.md_m.iter().map(|md_m| md_m.max(0.0)).collect();
        }
        self.most_tension_N.resize(frame.tension_N.len(), f64::NEG_INFINITY);
        self.torque_N_m.resize(frame.torque_N_m.len(), [f64::INFINITY, f64::NEG_INFINITY]);
        for (most, now) in self.most_tension_N.iter_mut().zip(&frame.tension_N) {
            *most = most.max(*now);
        }
        for ([least, most], now) in self.torque_N_m.iter_mut().zip(&frame.torque_N_m) {
            (*least, *most) = (least.min(*now), most.max(*now));
        }
    }

    /// Returns the profile with these in place of its percentiles, which exclude short peaks, and
    /// with the depths of the string at rest.
    pub(super) fn in_profile(self, profile: &Profile) -> Profile {
        if self.most_tension_N.len() != profile.md_m.len() {
            return profile.clone();
        }
        Profile {
            md_m: self.md_m,
            tension_p95_N: self.most_tension_N,
            torque_p05_N_m: self.torque_N_m.iter().map(|ends| ends[0]).collect(),
            torque_p95_N_m: self.torque_N_m.iter().map(|ends| ends[1]).collect(),
            ..profile.clone()
        }
    }
}

// The limits of an event.

/// Whether the peak of an event is compared with a limit: limits that do not depend on a peak are
/// left to the plan's states of equilibrium.
pub(super) const fn bears_on(event: Event, kind: CheckKind) -> bool {
    use CheckKind::{
        Hoist, MakeUp, Overpull, PumpPressure, Tension, TensionAndTorsion, TopDrivePeak, Torsion,
        VonMises,
    };
    match kind {
        Tension | VonMises | Hoist | Overpull => true,
        Torsion | TensionAndTorsion | MakeUp | TopDrivePeak => event.turns(),
        PumpPressure => event.circulates(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A load that rises from 100 to 200, with a sample of 260 on the way.
    #[test]
    fn a_peak_is_what_is_farthest_from_rest() {
        let times_s: Vec<f64> = (0..=140).map(|i| 0.1 * f64::from(i) - 4.0).collect();
        let value = |time_s: f64| match time_s {
            t if t <= 0.0 => 100.0,
            t if (t - 1.0).abs() < 0.05 => 260.0,
            _ => 200.0,
        };
        let values: Vec<f64> = times_s.iter().map(|t| value(*t)).collect();
        let peak = Peak::of(&times_s, &values, 8.0, Toward::Steady).expect("samples");
        assert!((peak.time_s - 1.0).abs() < 1e-9);
        assert_eq!((peak.at_rest, peak.peak, peak.steady, peak.drift), (100.0, 260.0, 200.0, 0.0));
        assert_eq!((peak.ratio(), peak.overshoot()), (Some(1.3), Some(0.6)));
        // Without a change there is no overshoot; without a value there is no ratio.
        let still = Peak::of(&times_s, &vec![0.0; times_s.len()], 8.0, Toward::More);
        let still = still.expect("samples");
        assert_eq!((still.ratio(), still.overshoot()), (None, None));
    }
}
