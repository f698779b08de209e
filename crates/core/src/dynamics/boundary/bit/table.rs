//! A law that was measured: rate of penetration and torque in a table of weight on bit and rotary
//! speed.

use serde::{Deserialize, Serialize};

use super::{
    cutters::SteadyCut,
    rate_segment::{RateSegment, depth_of_cut_m},
};

/// One line of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TablePoint {
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Rotary speed of the bit, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Rate of penetration, m/s.
    pub rate_of_penetration_m_per_s: f64,
    /// Torque, N·m.
    pub torque_N_m: f64,
    /// Standard deviation of the torque, N·m.
    pub torque_std_N_m: Option<f64>,
    /// Standard deviation of the weight on bit, N.
    pub weight_on_bit_std_N: Option<f64>,
}

/// Fault in a table.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TableFault {
    /// No lines.
    #[error("the table is empty")]
    Empty,
    /// A number that cannot be: negative or not finite, or a weight or a speed of zero.
    #[error("a number of line {line} is out of range")]
    Number {
        /// Which line, counted from one.
        line: usize,
    },
    /// Two lines of the same weight and speed.
    #[error("lines {first} and {second} are of the same weight on bit and rotary speed")]
    Twice {
        /// The first, counted from one.
        first: usize,
        /// The second.
        second: usize,
    },
    /// A weight and a speed that are both in the table, but not in one row.
    #[error("there is no line for {weight_on_bit_N} N at {rotary_speed_rad_per_s} rad/s")]
    Missing {
        /// The weight, N.
        weight_on_bit_N: f64,
        /// The speed, rad/s.
        rotary_speed_rad_per_s: f64,
    },
    /// A standard deviation that some lines have and others have not.
    #[error("a standard deviation is missing in line {line}")]
    Spread {
        /// The first line that differs from the one before, counted from one.
        line: usize,
    },
}

/// Rate of penetration and torque against weight on bit and rotary speed: every weight at every
/// speed.
///
/// Between the points it is bilinear. Nothing is cut without weight or without rotation, so that
/// below the least weight the rate and the torque go evenly to zero with the weight, and below the
/// least speed the rate goes to zero with the speed, while the torque stays. Above the largest
/// weight and the largest speed the values are those of the edge. All of this is outside, and
/// [`TableUse`] reports it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BitTable {
    weights_N: Vec<f64>,
    speeds_rad_per_s: Vec<f64>,
    /// These go by the weight, and for each weight by the speed.
    rate_m_per_s: Vec<f64>,
    torque_N_m: Vec<f64>,
    torque_std_N_m: Option<Vec<f64>>,
    weight_std_N: Option<Vec<f64>>,
}

/// Position of a speed among those of the table.
#[derive(Debug, Clone, Copy)]
struct Column {
    below: usize,
    above: usize,
    part: f64,
    /// Factor of the rate below the least speed.
    rate_factor: f64,
}

impl BitTable {
    /// The table of these points, in any order.
    ///
    /// # Errors
    /// Points that do not make a table.
    pub fn new(points: &[TablePoint]) -> Result<Self, TableFault> {
        if points.is_empty() {
            return Err(TableFault::Empty);
        }
        let valid = |p: &TablePoint| {
            let positive = [p.weight_on_bit_N, p.rotary_speed_rad_per_s];
            let others = [p.rate_of_penetration_m_per_s, p.torque_N_m];
            let spread = p.torque_std_N_m.iter().chain(&p.weight_on_bit_std_N);
            positive.iter().all(|x| x.is_finite() && *x > 0.0)
                && others.iter().chain(spread).all(|x| x.is_finite() && *x >= 0.0)
        };
        if let Some(at) = points.iter().position(|p| !valid(p)) {
            return Err(TableFault::Number { line: at + 1 });
        }
        let spreads =
            |p: &TablePoint| (p.torque_std_N_m.is_some(), p.weight_on_bit_std_N.is_some());
        if let Some(at) = points.iter().position(|p| spreads(p) != spreads(&points[0])) {
            return Err(TableFault::Spread { line: at + 1 });
        }
        let axis = |point: fn(&TablePoint) -> f64| {
            let mut values: Vec<f64> = points.iter().map(point).collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            values
        };
        let weights_N = axis(|p| p.weight_on_bit_N);
        let speeds_rad_per_s = axis(|p| p.rotary_speed_rad_per_s);
        let mut lines = Vec::with_capacity(points.len());
        for &weight_on_bit_N in &weights_N {
            for &rotary_speed_rad_per_s in &speeds_rad_per_s {
                let mut here = points.iter().enumerate().filter(|(_, p)| {
                    p.weight_on_bit_N == weight_on_bit_N
                        && p.rotary_speed_rad_per_s == rotary_speed_rad_per_s
                });
                let (first, point) = here
                    .next()
                    .ok_or(TableFault::Missing { weight_on_bit_N, rotary_speed_rad_per_s })?;
                if let Some((second, _)) = here.next() {
                    return Err(TableFault::Twice { first: first + 1, second: second + 1 });
                }
                lines.push(point);
            }
        }
        Ok(Self {
            rate_m_per_s: lines.iter().map(|p| p.rate_of_penetration_m_per_s).collect(),
            torque_N_m: lines.iter().map(|p| p.torque_N_m).collect(),
            torque_std_N_m: lines.iter().map(|p| p.torque_std_N_m).collect(),
            weight_std_N: lines.iter().map(|p| p.weight_on_bit_std_N).collect(),
            weights_N,
            speeds_rad_per_s,
        })
    }

    /// The points, by weight and for each weight by speed.
    pub fn points(&self) -> Vec<TablePoint> {
        let speeds = &self.speeds_rad_per_s;
        let point = |i: usize| TablePoint {
            weight_on_bit_N: self.weights_N[i / speeds.len()],
            rotary_speed_rad_per_s: speeds[i % speeds.len()],
            rate_of_penetration_m_per_s: self.rate_m_per_s[i],
            torque_N_m: self.torque_N_m[i],
            torque_std_N_m: self.torque_std_N_m.as_ref().map(|std| std[i]),
            weight_on_bit_std_N: self.weight_std_N.as_ref().map(|std| std[i]),
        };
        (0..self.rate_m_per_s.len()).map(point).collect()
    }

    /// Least and largest weight on bit, N.
    pub fn weights_N(&self) -> [f64; 2] {
        [self.weights_N[0], self.weights_N[self.weights_N.len() - 1]]
    }

    /// Least and largest rotary speed, rad/s.
    pub fn speeds_rad_per_s(&self) -> [f64; 2] {
        let speeds = &self.speeds_rad_per_s;
        [speeds[0], speeds[speeds.len() - 1]]
    }

    /// Whether the table knows the spread of the torque.
    pub fn spreads_torque(&self) -> bool {
        self.torque_std_N_m.is_some()
    }

    /// Whether the table knows the spread of the weight on bit.
    pub fn spreads_weight(&self) -> bool {
        self.weight_std_N.is_some()
    }

    /// Standard deviation of the weight on bit, N, where the table knows it.
    pub(super) fn weight_std_N(&self, weight_N: f64, speed_rad_per_s: f64) -> Option<f64> {
        let std = self.weight_std_N.as_ref()?;
        Some(self.at(std, weight_N, speed_rad_per_s))
    }

    /// Standard deviation of the torque over its mean, where the table knows it.
    pub(super) fn torque_fluctuation(&self, weight_N: f64, speed_rad_per_s: f64) -> Option<f64> {
        let std = self.torque_std_N_m.as_ref()?;
        let mean = self.at(&self.torque_N_m, weight_N, speed_rad_per_s);
        let std = self.at(std, weight_N, speed_rad_per_s);
        Some(if mean > 0.0 { std / mean } else { 0.0 })
    }

    /// Whether a weight and a speed are within the table.
    pub fn holds(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> bool {
        let within = |value: f64, [least, largest]: [f64; 2]| (least..=largest).contains(&value);
        within(weight_on_bit_N, self.weights_N())
            && within(rotary_speed_rad_per_s, self.speeds_rad_per_s())
    }

    /// Steady drilling of the bit under a weight on bit, at a speed.
    pub fn steady(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let column = self.column(rotary_speed_rad_per_s);
        let rate = column.rate_factor * self.down(&self.rate_m_per_s, weight_on_bit_N, column);
        SteadyCut {
            depth_of_cut_m: depth_of_cut_m(rate, rotary_speed_rad_per_s),
            torque_N_m: self.down(&self.torque_N_m, weight_on_bit_N, column),
            rate_of_penetration_m_per_s: rate,
        }
    }

    /// The rate of penetration against the weight at a speed, from point to point.
    pub(super) fn segments(&self, speed_rad_per_s: f64) -> impl Iterator<Item = RateSegment> {
        let column = self.column(speed_rad_per_s);
        let rate = move |i: usize| column.rate_factor * self.across(&self.rate_m_per_s, i, column);
        let last = self.weights_N.len() - 1;
        let rising = (0..=last).map(move |i| {
            // Without weight nothing is cut: the first stretch begins at zero.
            let (from_N, from_m_per_s) = match i {
                0 => (0.0, 0.0),
                _ => (self.weights_N[i - 1], rate(i - 1)),
            };
            let to_N = self.weights_N[i];
            RateSegment {
                from_N,
                to_N,
                from_m_per_s,
                slope_m_per_s_per_N: (rate(i) - from_m_per_s) / (to_N - from_N),
            }
        });
        let edge = RateSegment {
            from_N: self.weights_N[last],
            to_N: f64::INFINITY,
            from_m_per_s: rate(last),
            slope_m_per_s_per_N: 0.0,
        };
        rising.chain([edge])
    }

    /// A value under a weight at a speed.
    fn at(&self, values: &[f64], weight_N: f64, speed_rad_per_s: f64) -> f64 {
        self.down(values, weight_N, self.column(speed_rad_per_s))
    }

    fn column(&self, speed_rad_per_s: f64) -> Column {
        let speeds = &self.speeds_rad_per_s;
        let above = speeds.partition_point(|s| *s < speed_rad_per_s);
        let edge =
            |at: usize, rate_factor: f64| Column { below: at, above: at, part: 0.0, rate_factor };
        // Below the least speed the rate goes to zero with the speed; above the largest it stays.
        if above == 0 {
            edge(0, (speed_rad_per_s / speeds[0]).max(0.0))
        } else if above == speeds.len() {
            edge(above - 1, 1.0)
        } else {
            Column {
                below: above - 1,
                above,
                part: (speed_rad_per_s - speeds[above - 1]) / (speeds[above] - speeds[above - 1]),
                rate_factor: 1.0,
            }
        }
    }

    /// A value of the weight number `row`, between the speeds.
    fn across(&self, values: &[f64], row: usize, at: Column) -> f64 {
        let row = &values[row * self.speeds_rad_per_s.len()..];
        row[at.below] + at.part * (row[at.above] - row[at.below])
    }

    /// A value between the weights.
    fn down(&self, values: &[f64], weight_N: f64, at: Column) -> f64 {
        let weights = &self.weights_N;
        let above = weights.partition_point(|w| *w < weight_N);
        if above == weights.len() {
            return self.across(values, above - 1, at);
        }
        // Below the least weight, straight to zero.
        let (from_N, from) = match above {
            0 => (0.0, 0.0),
            _ => (weights[above - 1], self.across(values, above - 1, at)),
        };
        let to = self.across(values, above, at);
        from + (weight_N.max(0.0) - from_N) / (weights[above] - from_N) * (to - from)
    }
}

/// Count and extent of the excursions of a bit on the rock outside its table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TableUse {
    /// Part of the time on the rock that the bit was outside its table, in weight or in speed.
    #[serde(with = "crate::finite")]
    pub outside_fraction: f64,
    /// Least and largest weight on bit of the bit on the rock, N.
    #[serde(with = "crate::finite::pair")]
    pub weights_N: [f64; 2],
    /// Least and largest weight on bit of the table, N.
    #[serde(with = "crate::finite::pair")]
    pub table_weights_N: [f64; 2],
    /// Least and largest rotary speed of the bit on the rock, rad/s.
    #[serde(with = "crate::finite::pair")]
    pub speeds_rad_per_s: [f64; 2],
    /// Least and largest rotary speed of the table, rad/s.
    #[serde(with = "crate::finite::pair")]
    pub table_speeds_rad_per_s: [f64; 2],
}

/// Counts where the bit is.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Counter {
    steps: u64,
    outside: u64,
    weights_N: [f64; 2],
    speeds_rad_per_s: [f64; 2],
}

impl Counter {
    pub(super) fn new() -> Self {
        const NONE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];
        Self { steps: 0, outside: 0, weights_N: NONE, speeds_rad_per_s: NONE }
    }

    /// Notes a weight and a speed; a bit off the rock is nowhere.
    pub(super) fn count(&mut self, table: &BitTable, weight_N: f64, speed_rad_per_s: f64) {
        if weight_N <= 0.0 {
            return;
        }
        let widen = |range: &mut [f64; 2], value: f64| {
            *range = [range[0].min(value), range[1].max(value)];
        };
        widen(&mut self.weights_N, weight_N);
        widen(&mut self.speeds_rad_per_s, speed_rad_per_s);
        self.steps += 1;
        self.outside += u64::from(!table.holds(weight_N, speed_rad_per_s));
    }

    /// Counted excursions; none for a bit that was never on the rock.
    pub(super) fn table_use(&self, table: &BitTable) -> Option<TableUse> {
        (self.steps > 0).then(|| TableUse {
            outside_fraction: self.outside as f64 / self.steps as f64,
            weights_N: self.weights_N,
            table_weights_N: table.weights_N(),
            speeds_rad_per_s: self.speeds_rad_per_s,
            table_speeds_rad_per_s: table.speeds_rad_per_s(),
        })
    }
}
