//! Motion of the string, row by row.

use super::{beginning::Beginning, row::Row, thresholds::Thresholds};

/// Motion of the string.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Motion {
    /// Moves up, off bottom, without rotation.
    PickUp,
    /// Moves down, off bottom, without rotation.
    SlackOff,
    /// Turns off bottom without axial motion.
    Rotating,
    /// Turns on bottom.
    Drilling,
    /// Is on bottom and does not turn.
    OnBottom,
    /// Turns off bottom and moves.
    Reaming,
    /// Is stationary off bottom.
    Still,
    /// Changes from one motion to another, or the sensors do not determine it.
    Between,
}

impl Motion {
    /// Every motion, in the order of a table.
    pub const ALL: [Motion; 8] = [
        Motion::PickUp,
        Motion::SlackOff,
        Motion::Rotating,
        Motion::Drilling,
        Motion::OnBottom,
        Motion::Reaming,
        Motion::Still,
        Motion::Between,
    ];

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Motion::PickUp => "up without rotation",
            Motion::SlackOff => "down without rotation",
            Motion::Rotating => "rotating off bottom",
            Motion::Drilling => "rotating on bottom",
            Motion::OnBottom => "on bottom without rotation",
            Motion::Reaming => "moving with rotation",
            Motion::Still => "still off bottom",
            Motion::Between => "changing, or unknown",
        }
    }
}

/// The rows of a stand with single spikes of positions removed, and their speeds and motions.
pub(super) struct Moving<'a> {
    pub(super) rows: &'a [Row],
    /// Speed of the block, positive upwards, m/s.
    pub(super) speed: Vec<f64>,
    pub(super) motion: Vec<Motion>,
    /// Height of the block, or the travel of the bit where no sensor gives the height, m.
    pub(super) height: Vec<f64>,
}

/// Half of the time span over which a speed is computed, s.
const HALF_SPAN_S: f64 = 2.0;

/// Number of rows on either side over which a speed is computed.
pub(super) fn half_span(step_s: f64) -> usize {
    (HALF_SPAN_S / step_s).round().clamp(1.0, 100.0) as usize
}

impl<'a> Moving<'a> {
    pub(super) fn of(rows: &'a [Row], log: &Beginning, limits: &Thresholds) -> Self {
        let height = smooth(rows, |row| if log.has.block { row.block_m } else { -row.bit_depth_m });
        let above = smooth(rows, Row::height_m);
        let turning = smooth(rows, |row| row.rotary_rad_per_s.abs());
        let torque = if log.has.rotary { Vec::new() } else { smooth(rows, |row| row.torque_N_m) };
        let speed = speeds(rows, &height, log.step_s);
        let motion = (0..rows.len()).map(|at| {
            let turns = match (log.has.rotary, log.idle_torque_N_m) {
                (true, _) if turning[at] >= limits.turns_rad_per_s => Some(true),
                (true, _) if turning[at] <= limits.still_rad_per_s => Some(false),
                (false, Some(idle)) if torque[at].is_finite() => Some(torque[at] > idle),
                _ => None,
            };
            let moves = speed[at].abs() >= limits.moves_m_per_s;
            let stands = speed[at].abs() <= limits.stands_m_per_s;
            let off = above[at] > limits.off_bottom_m;
            let on = (-limits.below_bottom_m..limits.on_bottom_m).contains(&above[at]);
            match turns {
                Some(false) if off && moves && speed[at] > 0.0 => Motion::PickUp,
                Some(false) if off && moves => Motion::SlackOff,
                Some(false) if off && stands => Motion::Still,
                Some(true) if off && moves => Motion::Reaming,
                Some(true) if off && stands => Motion::Rotating,
                Some(true) if on => Motion::Drilling,
                Some(false) if on => Motion::OnBottom,
                _ => Motion::Between,
            }
        });
        let mut motion: Vec<Motion> = motion.collect();
        bridge(&mut motion, (3.0 / log.step_s).round().max(1.0) as usize);
        Self { rows, speed, motion, height }
    }

    /// Stretches of one motion: the motion, its first row, and the row after its last.
    pub(super) fn runs(&self) -> Vec<(Motion, usize, usize)> {
        let mut runs = Vec::new();
        let mut first = 0;
        for chunk in self.motion.chunk_by(|a, b| a == b) {
            runs.push((chunk[0], first, first + chunk.len()));
            first += chunk.len();
        }
        runs
    }
}

/// Running median of three: removes single spikes and keeps trends.
fn smooth(rows: &[Row], value: impl Fn(&Row) -> f64) -> Vec<f64> {
    let values: Vec<f64> = rows.iter().map(value).collect();
    let middle = |at: usize| {
        if at == 0 || at + 1 >= values.len() {
            return values[at];
        }
        let [a, b, c] = [values[at - 1], values[at], values[at + 1]];
        // A missing row between two equal ones takes their value.
        if b.is_nan() {
            0.5 * (a + c)
        } else if (a + c).is_nan() {
            b
        } else {
            a.max(b).min(a.min(b).max(c))
        }
    };
    (0..values.len()).map(middle).collect()
}

/// Speeds over a few seconds; NaN across a gap.
fn speeds(rows: &[Row], height: &[f64], step_s: f64) -> Vec<f64> {
    let half = half_span(step_s);
    let last = rows.len().saturating_sub(1);
    let speed = |at: usize| {
        let (from, to) = (at.saturating_sub(half), (at + half).min(last));
        let span_s = rows[to].time_s - rows[from].time_s;
        let is_gap = span_s > 2.0 * (2 * half) as f64 * step_s;
        if is_gap || from == to { f64::NAN } else { (height[to] - height[from]) / span_s }
    };
    (0..rows.len()).map(speed).collect()
}

/// Assigns a few differing rows between two runs of one motion to that motion.
fn bridge(motion: &mut [Motion], most: usize) {
    let mut at = 0;
    while at < motion.len() {
        let end = at + motion[at..].iter().take_while(|other| **other == motion[at]).count();
        let before = at.checked_sub(1).map(|before| motion[before]);
        if end - at <= most && before.is_some() && before == motion.get(end).copied() {
            let neighbour = motion[end];
            motion[at..end].fill(neighbour);
        }
        at = end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_odd_rows_are_bridged_and_no_more() {
        use Motion::{Between as B, PickUp as P, Still as S};
        let mut motion = [P, P, B, P, P, S, S, S, P, B];
        bridge(&mut motion, 2);
        assert_eq!(motion, [P, P, P, P, P, S, S, S, P, B]);
    }
}
