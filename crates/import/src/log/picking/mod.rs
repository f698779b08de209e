//! Weights and torques picked from a log against time.
//!
//! Rows come one after the other and are let go with their stand: from slips to slips. What hook
//! loads, sensors and time steps are like, the first rows tell. Of each stand that ends,
//! [`motion`] tells what the string did, [`steady`] where it did so steadily and what sensors said
//! there. How it is done, and what the numbers mean, stands in the book: "How weights are picked".

mod beginning;
mod block;
mod counts;
mod depths;
mod estimate;
mod motion;
mod part;
mod picker;
mod picks;
mod rig;
mod row;
mod steady;
mod thresholds;
mod trace;
mod window;

pub use block::BlockWeight;
pub use counts::{Counts, Trip, Work};
pub use estimate::Estimate;
pub use motion::Motion;
pub use picks::{Detail, Picks};
pub use thresholds::Thresholds;
pub use trace::{Channel, Trace};
pub use window::{Kind, Refusal, Refused, Window};

use wholestring_units::Unit;

use self::{beginning::Beginning, depths::Depths, picker::Picker, row::Row};
use super::Record;
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::Note,
};

/// Rows by which the rest is understood: two days of a row a second.
const BEGINNING: usize = 200_000;

/// Over the level in slips so much of the heaviest string is not yet a string on the hook, nor so
/// many spreads of the level, nor so much, N.
const ON_HOOK: (f64, f64, f64) = (0.05, 6.0, 1e4);

/// Picks weights and torques of the rows of a log against time; `unit` is that of its hook loads, for
/// sentences.
///
/// It asks `choices` for the weight of block and top drive: `--value block-weight="25 tf"`.
///
/// # Errors
/// A row cannot be read, a sensor without which nothing is told is missing, the log is against depth
/// or too slow, or the block's weight is not said or cannot be.
pub fn pick(
    records: impl IntoIterator<Item = Result<Record, ImportError>>,
    file: &str,
    unit: &'static Unit,
    limits: &Thresholds,
    choices: &Choices,
) -> Result<Picks, ImportError> {
    let at = |kind| ImportError::new(file, None, kind);
    let mut clock = Clock { last_s: f64::NEG_INFINITY, without: 0 };
    let mut records = records.into_iter();
    let mut first = Vec::new();
    let mut taken = 0_usize;
    for record in records.by_ref() {
        taken += 1;
        first.extend(clock.row(&record?));
        // Of a log against depth, too, so many are enough.
        if first.len() == BEGINNING || taken == 2 * BEGINNING {
            break;
        }
    }
    let depths = Depths::of(&first, limits);
    first.iter_mut().for_each(|row| depths.give(row));
    let log = Beginning { tells_bottom: depths.tells_bottom(), ..Beginning::of(&first) };
    check(&log, limits).map_err(at)?;
    let block = BlockWeight::of(choices, &log, unit).map_err(at)?;
    let on_sensor_N = block.on_sensor_N();
    let (part, spreads, least_N) = ON_HOOK;
    let spread_N = log.slips.map_or(0.0, |level| level.spread_N);
    let over_N = (part * (log.heavy_N - on_sensor_N)).max(spreads * spread_N).max(least_N);
    let hook_from_N = on_sensor_N + over_N;
    if log.heavy_N <= hook_from_N {
        let kind = ImportErrorKind::Refused(format!(
            "the hook load shows no string: nineteen rows in twenty stay below {}, where {} hang on \
             the sensor without one",
            block::shown(log.heavy_N, unit),
            block::shown(on_sensor_N, unit),
        ));
        return Err(at(kind));
    }
    let mut picker = Picker::new(limits, &log, &block, hook_from_N);
    first.drain(..).for_each(|row| picker.push(row));
    drop(first);
    for record in records {
        if let Some(mut row) = clock.row(&record?) {
            depths.give(&mut row);
            picker.push(row);
        }
        if picker.done.counts.stands > picker::STANDS {
            let kind = ImportErrorKind::TooMuch {
                found: format!("more than {} stands", picker::STANDS),
                most: picker::STANDS.to_string(),
            };
            return Err(at(kind));
        }
    }
    let done = picker.finish();
    let mut counts = done.counts;
    counts.rows_without_time = clock.without;
    Ok(Picks {
        file: file.to_owned(),
        notes: [depths.notes(), notes(&log, &counts, hook_from_N, unit)].concat(),
        block,
        step_s: log.step_s,
        windows: done.windows,
        counts,
        overview: done.overview,
        details: done.details,
        same_depth_m: limits.same_depth_m,
        unit,
    })
}

/// Lets rows pass whose time grows.
struct Clock {
    last_s: f64,
    without: usize,
}

impl Clock {
    fn row(&mut self, record: &Record) -> Option<Row> {
        if record.time_s > self.last_s && record.time_s.is_finite() {
            self.last_s = record.time_s;
            return Some(Row::of(record));
        }
        self.without += 1;
        None
    }
}

/// Whether weights can be picked of a log at all.
fn check(log: &Beginning, limits: &Thresholds) -> Result<(), ImportErrorKind> {
    if !log.has.time {
        return Err(ImportErrorKind::Refused(
            "no row has a time; weights are picked from a log against time, which shows when the \
             string moves and turns"
                .to_owned(),
        ));
    }
    let needed = [
        (log.has.hook_load, "the hook load", "hookload"),
        (log.has.bit_depth, "the depth of the bit", "bit-depth"),
        (log.has.hole_depth, "the depth of the hole", "hole-depth"),
    ];
    if let Some((_, what, name)) = needed.into_iter().find(|(has, ..)| !has) {
        return Err(ImportErrorKind::Refused(format!(
            "{what} is missing; if a channel has it, say which: --pick {name}=CHANNEL"
        )));
    }
    if log.step_s.is_nan() {
        return Err(ImportErrorKind::Missing { what: "a second row with a time".to_owned() });
    }
    if log.step_s > limits.slowest_s {
        return Err(ImportErrorKind::Refused(format!(
            "it has a row every {:.0} s; steady motion is seen in rows no more than {} s apart",
            log.step_s, limits.slowest_s
        )));
    }
    Ok(())
}

/// What was assumed and left out.
fn notes(log: &Beginning, counts: &Counts, hook_from_N: f64, unit: &Unit) -> Vec<Note> {
    let mut notes = vec![Note::Read(format!(
        "the string is on the hook where the hook load is over {}",
        block::shown(hook_from_N, unit)
    ))];
    if !log.has.block {
        let text = "no sensor tells where the block is; it moves as the depth of the bit does";
        notes.push(Note::Assumed(text.to_owned()));
    }
    match (log.has.rotary, log.idle_torque_N_m) {
        (true, _) => {}
        (false, Some(idle)) => notes.push(Note::Assumed(format!(
            "no sensor tells the rotary speed; the string turns where the torque is over {:.2} kN.m, \
             a tenth of what one row in twenty reaches",
            1e-3 * idle
        ))),
        (false, None) => notes.push(Note::LeftOut(
            "all windows, for neither rotary speed nor torque tells whether the string turns"
                .to_owned(),
        )),
    }
    if !log.has.torque {
        notes.push(Note::LeftOut("torques, for there is none in the log".to_owned()));
    }
    if counts.rows_without_time > 0 {
        let text = "rows without a time, or with one that does not come after the row before";
        notes.push(Note::LeftOut(format!("{} {text}", counts.rows_without_time)));
    }
    if counts.gaps > 0 {
        notes.push(Note::Read(format!(
            "the log is silent {} times; a stand does not go on over a silence",
            counts.gaps
        )));
    }
    notes
}
