//! From rows to stands: times when the string hangs in slips, and times on the hook.

use super::{estimate::median, row::Row, thresholds::Thresholds};

/// A part of a log.
pub(super) enum Part {
    /// The string on the hook, from slips to slips.
    Stand(Vec<Row>),
    /// The string in slips.
    Slips(Slips),
    /// A period of the log without values.
    Gap,
}

/// The string in slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slips {
    pub(super) from_s: f64,
    pub(super) to_s: f64,
    /// Travel of the block between its lowest and highest position, m.
    pub(super) way_m: f64,
    /// Median hook load, N.
    pub(super) hook_load_N: f64,
}

/// Maximum number of rows of a stand: some days at one row per second. A longer stand is read in
/// parts.
const LONGEST_STAND: usize = 200_000;

/// Maximum number of hook loads in slips for the median.
const LOADS: usize = 512;

/// Time of hook loads above the level that ends slips, s: a spike is shorter.
const LIFTED_S: f64 = 3.0;

/// Separates rows in slips from rows on the hook.
pub(super) struct Rig {
    limits: Thresholds,
    /// Hook load above which the string hangs on the hook, N.
    hook_from_N: f64,
    /// Gap after which a new stand begins, s.
    gap_s: f64,
    state: State,
    /// Rows that indicate the other state, but may be a spike.
    pending: Vec<Row>,
    last_s: f64,
}

enum State {
    Hook(Vec<Row>),
    Slips { from_s: f64, to_s: f64, low_m: f64, high_m: f64, loads: Vec<f64>, seen: usize },
}

impl Rig {
    pub(super) fn new(limits: Thresholds, hook_from_N: f64, step_s: f64) -> Self {
        Self {
            limits,
            hook_from_N,
            gap_s: (20.0 * step_s).max(60.0),
            state: State::Hook(Vec::new()),
            pending: Vec::new(),
            last_s: f64::NEG_INFINITY,
        }
    }

    /// Adds a row, and passes on the parts that end with it.
    pub(super) fn push(&mut self, row: Row, mut part: impl FnMut(Part)) {
        if row.time_s - self.last_s > self.gap_s && self.last_s.is_finite() {
            self.finish(&mut part);
            part(Part::Gap);
        }
        self.last_s = row.time_s;
        let is_low = row.hook_load_N <= self.hook_from_N;
        match &mut self.state {
            State::Hook(rows) if is_low => {
                self.pending.push(row);
                if lasts(&self.pending, self.limits.slips_s) {
                    let rows = std::mem::take(rows);
                    if !rows.is_empty() {
                        part(Part::Stand(rows));
                    }
                    self.state = State::slips(&self.pending);
                    self.pending.clear();
                }
            }
            State::Hook(rows) => {
                // A sensor dropout.
                rows.extend(self.pending.drain(..).map(|low| Row { hook_load_N: f64::NAN, ..low }));
                rows.push(row);
                if rows.len() >= LONGEST_STAND {
                    part(Part::Stand(std::mem::take(rows)));
                }
            }
            State::Slips { .. } if is_low || row.hook_load_N.is_nan() => {
                let spikes = std::mem::take(&mut self.pending);
                for spike in &spikes {
                    self.state.add(&Row { hook_load_N: f64::NAN, ..*spike });
                }
                self.state.add(&row);
            }
            State::Slips { .. } => {
                self.pending.push(row);
                if lasts(&self.pending, LIFTED_S) {
                    let rows = std::mem::take(&mut self.pending);
                    let ended = std::mem::replace(&mut self.state, State::Hook(rows));
                    ended.end(&mut part);
                }
            }
        }
    }

    /// Passes on the part in which the log ends.
    pub(super) fn finish(&mut self, mut part: impl FnMut(Part)) {
        self.pending.clear();
        std::mem::replace(&mut self.state, State::Hook(Vec::new())).end(&mut part);
    }
}

/// Whether rows last this long, and are more than one.
fn lasts(rows: &[Row], time_s: f64) -> bool {
    matches!(rows, [first, .., last] if last.time_s - first.time_s >= time_s)
}

impl State {
    fn slips(rows: &[Row]) -> Self {
        let from_s = rows[0].time_s;
        let mut slips = State::Slips {
            from_s,
            to_s: from_s,
            low_m: f64::INFINITY,
            high_m: f64::NEG_INFINITY,
            loads: Vec::new(),
            seen: 0,
        };
        rows.iter().for_each(|row| slips.add(row));
        slips
    }

    fn add(&mut self, row: &Row) {
        let State::Slips { to_s, low_m, high_m, loads, seen, .. } = self else { return };
        *to_s = row.time_s;
        // `min` and `max` ignore NaN.
        *low_m = low_m.min(row.block_m);
        *high_m = high_m.max(row.block_m);
        if row.hook_load_N.is_finite() {
            // Of long periods the latest values are kept.
            if loads.len() < LOADS {
                loads.push(row.hook_load_N);
            } else {
                loads[*seen % LOADS] = row.hook_load_N;
            }
            *seen += 1;
        }
    }

    fn end(self, part: &mut impl FnMut(Part)) {
        match self {
            State::Hook(rows) if rows.is_empty() => {}
            State::Hook(rows) => part(Part::Stand(rows)),
            State::Slips { from_s, to_s, low_m, high_m, mut loads, .. } => {
                let way_m = (high_m - low_m).max(0.0);
                let hook_load_N = median(&mut loads).unwrap_or(f64::NAN);
                part(Part::Slips(Slips { from_s, to_s, way_m, hook_load_N }));
            }
        }
    }
}
