//! Processes a log row by row, and picks windows from each stand as it ends.

use super::{
    beginning::Beginning,
    block::BlockWeight,
    counts::{Counts, Trip, Work},
    motion::Moving,
    picks::Detail,
    rig::{Part, Rig, Slips},
    row::Row,
    steady::{Found, Judge},
    thresholds::Thresholds,
    trace::Trace,
    window::{Kind, Refused, Window},
};

/// Maximum number of points of the drawn log.
const OVERVIEW: usize = 4096;

/// Maximum number of points of a drawn stand.
const STAND: usize = 256;

/// Maximum number of stands that are drawn.
const DRAWN: usize = 12;

/// Maximum number of stands of a log: no well has had as many.
pub(super) const STANDS: usize = 100_000;

/// Minimum travel of the bit in a tripped stand, m: half a joint.
const TRIPPED_M: f64 = 4.5;

/// Minimum advance of the bottom in a drilled stand, m.
const DRILLED_M: f64 = 0.5;

/// Processes a log row by row.
pub(super) struct Picker<'a> {
    limits: &'a Thresholds,
    log: &'a Beginning,
    judge: Judge<'a>,
    rig: Rig,
    pub(super) done: Done,
}

/// Results so far.
pub(super) struct Done {
    pub(super) windows: Vec<Window>,
    pub(super) counts: Counts,
    pub(super) overview: Trace,
    pub(super) details: Vec<Detail>,
    /// Interval between drawn stands, counted over stands with windows.
    every: usize,
    /// Number of stands with windows.
    picked: usize,
    trip: Option<Trip>,
}

impl<'a> Picker<'a> {
    pub(super) fn new(
        limits: &'a Thresholds,
        log: &'a Beginning,
        block: &BlockWeight,
        hook_from_N: f64,
    ) -> Self {
        let judge =
            Judge { limits, log, on_sensor_N: block.on_sensor_N(), added_N: block.added_N() };
        Self {
            limits,
            log,
            judge,
            rig: Rig::new(*limits, hook_from_N, log.step_s),
            done: Done {
                windows: Vec::new(),
                counts: Counts::default(),
                overview: Trace::new(OVERVIEW),
                details: Vec::new(),
                every: 1,
                picked: 0,
                trip: None,
            },
        }
    }

    pub(super) fn push(&mut self, row: Row) {
        let Self { limits, log, judge, rig, done } = self;
        done.counts.rows += 1;
        done.overview.push(&row);
        rig.push(row, |part| done.part(part, judge, log, limits));
    }

    pub(super) fn finish(mut self) -> Done {
        let Self { limits, log, judge, ref mut rig, ref mut done } = self;
        rig.finish(|part| done.part(part, &judge, log, limits));
        done.counts.end_trip(&mut done.trip);
        self.done
    }
}

impl Done {
    fn part(&mut self, part: Part, judge: &Judge<'_>, log: &Beginning, limits: &Thresholds) {
        match part {
            Part::Gap => self.counts.gaps += 1,
            Part::Slips(slips) => self.slips(&slips, limits),
            Part::Stand(rows) => self.stand(&rows, judge, log, limits),
        }
    }

    fn slips(&mut self, slips: &Slips, limits: &Thresholds) {
        let lasts_s = slips.to_s - slips.from_s;
        if slips.way_m >= limits.connection_m {
            self.counts.connections += 1;
            self.counts.connections_s += lasts_s;
        } else {
            self.counts.slips_alone += 1;
            self.counts.slips_alone_s += lasts_s;
        }
    }

    fn stand(&mut self, rows: &[Row], judge: &Judge<'_>, log: &Beginning, limits: &Thresholds) {
        let moving = Moving::of(rows, log, limits);
        for (pair, motion) in rows.windows(2).zip(&moving.motion) {
            let lasts_s = pair[1].time_s - pair[0].time_s;
            *self.counts.motions_s.entry(*motion).or_default() += lasts_s;
        }
        self.counts.below_bottom(rows, limits.below_bottom_m);
        let (work, from_m, to_m) = work(rows);
        self.counts.stand(work, from_m, to_m, &mut self.trip);
        if matches!(work, Work::TrippedOut | Work::TrippedIn) {
            self.counts.bit_over_block.extend(over_block(rows, (to_m - from_m).abs()));
        }
        let stand = self.counts.stands;
        let found = judge.windows(&moving, stand);
        let refused: Vec<Refused> = found.iter().filter_map(|window| window.err()).collect();
        for refusal in &refused {
            *self.counts.refused.entry((refusal.kind, refusal.why)).or_default() += 1;
        }
        let windows = best(&found);
        if windows.is_empty() {
            return;
        }
        for window in &windows {
            *self.counts.accepted.entry(window.kind).or_default() += 1;
            if let Some(why) = window.torque_refusal {
                *self.counts.refused_torques.entry(why).or_default() += 1;
            }
        }
        if self.picked.is_multiple_of(self.every) {
            if self.details.len() == DRAWN {
                let mut place = 0;
                self.details.retain(|_| {
                    place += 1;
                    place % 2 == 1
                });
                self.every *= 2;
            }
            if self.picked.is_multiple_of(self.every) {
                let mut trace = Trace::new(STAND);
                rows.iter().for_each(|row| trace.push(row));
                let windows = windows.clone();
                self.details.push(Detail { stand, work, trace, windows, refused });
            }
        }
        self.picked += 1;
        self.windows.extend(windows);
    }
}

/// Travel of the bit over that of the block, where the block moves.
fn over_block(rows: &[Row], bit_m: f64) -> Option<f64> {
    let heights = rows.iter().map(|row| row.block_m).filter(|height_m| height_m.is_finite());
    let (low_m, high_m) = heights
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| {
            (low.min(height), high.max(height))
        });
    let block_m = high_m - low_m;
    (block_m.is_finite() && block_m >= TRIPPED_M).then_some(bit_m / block_m)
}

/// The window of each kind with the smallest error.
fn best(found: &[Found]) -> Vec<Window> {
    let best = Kind::ALL.into_iter().filter_map(|kind| {
        let own = found.iter().flatten().filter(|pick| pick.kind == kind);
        own.min_by(|a, b| a.error().total_cmp(&b.error())).copied()
    });
    let mut best: Vec<Window> = best.collect();
    best.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
    best
}

/// Work done with a stand, and the bit depth before and after.
fn work(rows: &[Row]) -> (Work, f64, f64) {
    let ends = |depth: fn(&Row) -> f64| {
        let first = rows.iter().map(depth).find(|depth_m| depth_m.is_finite());
        let last = rows.iter().rev().map(depth).find(|depth_m| depth_m.is_finite());
        (first.unwrap_or(f64::NAN), last.unwrap_or(f64::NAN))
    };
    let (from_m, to_m) = ends(|row| row.bit_depth_m);
    let (bottom, deeper) = ends(|row| row.hole_depth_m);
    let work = if deeper - bottom >= DRILLED_M {
        Work::Drilled
    } else if from_m - to_m >= TRIPPED_M {
        Work::TrippedOut
    } else if to_m - from_m >= TRIPPED_M {
        Work::TrippedIn
    } else {
        Work::Other
    };
    (work, from_m, to_m)
}
