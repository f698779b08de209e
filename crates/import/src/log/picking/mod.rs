//! Weights and torques picked from a log against time.
//!
//! Rows arrive one after the other and are released with their stand, from slips to slips. The
//! first rows determine the ranges of hook loads, sensors and time steps. For each stand that ends,
//! [`motion`] determines the motion of the string, and [`steady`] the intervals of steady motion
//! with their sensor values. The method and the meaning of the numbers are described in the book:
//! "How weights are picked".

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
pub use counts::{BelowBottom, Counts, Trip, Work};
pub use estimate::Estimate;
pub use motion::Motion;
pub use picks::{Detail, Picks};
pub use thresholds::Thresholds;
pub use trace::{Channel, Trace};
pub use window::{Kind, Refusal, Refused, Window};

use wholestring_units::{Dimension, Unit, UnitSet};

use self::{
    beginning::Beginning,
    depths::Depths,
    picker::Picker,
    row::{AllOutside, RANGES, Row},
};
use super::Record;
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::Note,
};

/// Rows from which the log's properties are determined: two days at one row per second.
const BEGINNING: usize = 200_000;

/// Margin above the level in slips below which the string is not yet on the hook: the largest of a
/// fraction of the heaviest string, a number of spreads of the level, and a force, N.
const ON_HOOK: (f64, f64, f64) = (0.05, 6.0, 1e4);

/// Picks weights and torques from the rows of a log against time; `unit` is that of its hook loads,
/// for sentences.
///
/// It requires the weight of block and top drive in `choices`: `--value block-weight="25 tf"`.
///
/// # Errors
/// A row cannot be read, an indispensable sensor is missing, the log is against depth or too slow,
/// or the block's weight is missing or impossible.
pub fn pick(
    records: impl IntoIterator<Item = Result<Record, ImportError>>,
    file: &str,
    unit: &'static Unit,
    limits: &Thresholds,
    choices: &Choices,
) -> Result<Picks, ImportError> {
    let at = |kind| ImportError::new(file, None, kind);
    let units = if unit.is_field() { UnitSet::Field } else { UnitSet::Si };
    let mut clock = Clock { last_s: f64::NEG_INFINITY, without: 0, outside: AllOutside::default() };
    let mut records = records.into_iter();
    let mut first = Vec::new();
    let mut taken = 0_usize;
    for record in records.by_ref() {
        taken += 1;
        first.extend(clock.row(&record?));
        // For a log against depth, this many rows are enough, too.
        if first.len() == BEGINNING || taken == 2 * BEGINNING {
            break;
        }
    }
    let depths = Depths::of(&first, limits);
    first.iter_mut().for_each(|row| depths.give(row));
    let log = Beginning { tells_bottom: depths.tells_bottom(), ..Beginning::of(&first) };
    check(&log, limits).map_err(|kind| at(with_outside(kind, &clock.outside, units)))?;
    let unchanged_N = unchanged_N(&first);
    if unchanged_N == Some(0.0) {
        let sentence = "the hook load is 0 throughout; if another channel has the hook load, \
                        choose it with --pick hookload=CHANNEL";
        return Err(at(ImportErrorKind::Refused(sentence.to_owned())));
    }
    let block = BlockWeight::of(choices, &log, unit).map_err(at)?;
    let on_sensor_N = block.on_sensor_N();
    let (part, spreads, least_N) = ON_HOOK;
    let spread_N = log.slips.map_or(0.0, |level| level.spread_N);
    let over_N = (part * (log.heavy_N - on_sensor_N)).max(spreads * spread_N).max(least_N);
    let hook_from_N = on_sensor_N + over_N;
    if log.heavy_N <= hook_from_N {
        let kind = ImportErrorKind::Refused(format!(
            "the hook load shows no string: nineteen rows in twenty stay below {}, and {} are on \
             the sensor without a string{}",
            block::shown(log.heavy_N, unit),
            block::shown(on_sensor_N, unit),
            block.other_unit(&log, unit),
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
        units,
        file: file.to_owned(),
        notes: [
            depths.notes(),
            outside(&clock.outside, units),
            notes(&log, &counts, hook_from_N, unit, units),
        ]
        .concat(),
        block,
        step_s: log.step_s,
        windows: done.windows,
        is_unchanged: unchanged_N.is_some(),
        counts,
        overview: done.overview,
        details: done.details,
        same_depth_m: limits.same_depth_m,
        unit,
    })
}

/// Passes rows whose time increases.
struct Clock {
    last_s: f64,
    without: usize,
    outside: AllOutside,
}

impl Clock {
    fn row(&mut self, record: &Record) -> Option<Row> {
        if record.time_s > self.last_s && record.time_s.is_finite() {
            self.last_s = record.time_s;
            return Some(Row::of(record, &mut self.outside));
        }
        self.without += 1;
        None
    }
}

/// Whether weights can be picked from a log at all.
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
            "{what} is missing; if a channel has it, choose it with --pick {name}=CHANNEL"
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

/// Travel of the bit, m, over which the load on the hook changes in any log: three stands.
const TRAVEL_M: f64 = 90.0;

/// The hook load of a log in which it is one number at every depth of the bit, N.
fn unchanged_N(rows: &[Row]) -> Option<f64> {
    let span = |value: fn(&Row) -> f64| {
        let values = || rows.iter().map(value).filter(|value| value.is_finite());
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
    };
    let (least_N, most_N) = span(|row| row.hook_load_N);
    let (shallowest_m, deepest_m) = span(|row| row.bit_depth_m);
    let is_one = least_N == most_N && (deepest_m - shallowest_m > TRAVEL_M || most_N == 0.0);
    is_one.then_some(most_N)
}

/// Notes on values outside the range of any sensor.
fn outside(outside: &AllOutside, units: UnitSet) -> Vec<Note> {
    let notes = RANGES.iter().zip(outside).filter(|(_, outside)| outside.count > 0);
    let notes = notes.map(|((quantity, range), outside)| {
        let unit = quantity.dimension().unit_in(units);
        let digits = |value: f64| block::three_digits(unit.from_si(value));
        Note::LeftOut(format!(
            "{} of the {}, the first {} {}: outside the range of any rig, {} to {} {}; check the \
             unit and the null value of its channel",
            counts::plural(outside.count, "value"),
            quantity.words(),
            digits(outside.first),
            unit.symbol,
            digits(*range.start()),
            digits(*range.end()),
            unit.symbol,
        ))
    });
    notes.collect()
}

/// Adds the values outside the range of any sensor to an error, which may be due to them.
fn with_outside(kind: ImportErrorKind, values: &AllOutside, units: UnitSet) -> ImportErrorKind {
    let ImportErrorKind::Refused(sentence) = kind else { return kind };
    let notes = outside(values, units);
    let notes = notes.iter().map(|note| format!("; left out: {}", note.text()));
    ImportErrorKind::Refused(sentence + &notes.collect::<String>())
}

/// Warning of bit depths in metres under feet or the reverse: the bit moves with the block, and the
/// ratio of their travels is that of the units.
fn depths_in_other_unit(counts: &Counts) -> Option<Note> {
    /// Number of stands that prove it.
    const STANDS: usize = 3;
    /// Relative tolerance of the ratio: parts of a stand are cut off at slips.
    const NEAR: f64 = 0.05;
    const FOOT_M: f64 = 0.3048;
    let ratio = estimate::median(&mut counts.bit_over_block.clone())?;
    let near = |expected: f64| (ratio / expected - 1.0).abs() < NEAR;
    let (found, written) = match () {
        () if counts.bit_over_block.len() < STANDS => return None,
        () if near(FOOT_M) => ("metres", "feet"),
        () if near(1.0 / FOOT_M) => ("feet", "metres"),
        () => return None,
    };
    Some(Note::Warning(format!(
        "THE BIT MOVES {} TIMES AS FAR AS THE BLOCK in {}, which is the ratio of feet and metres: \
         are the depths in {found} and not in {written}, or is the block position in another unit?",
        block::three_digits(ratio),
        counts::plural(counts.bit_over_block.len(), "tripped stand"),
    )))
}

/// Notes on assumptions and omissions.
fn notes(
    log: &Beginning,
    counts: &Counts,
    hook_from_N: f64,
    unit: &Unit,
    units: UnitSet,
) -> Vec<Note> {
    let mut notes = vec![Note::Read(format!(
        "the string is on the hook where the hook load is over {}",
        block::shown(hook_from_N, unit)
    ))];
    if !log.has.block {
        let text = "no sensor gives the position of the block; it is assumed to move with the \
             depth of the bit";
        notes.push(Note::Assumed(text.to_owned()));
    }
    match (log.has.rotary, log.idle_torque_N_m) {
        (true, _) => {}
        (false, Some(idle)) => notes.push(Note::Assumed(format!(
            "no sensor gives the rotary speed; the string is assumed to turn where the torque \
             exceeds {}, a tenth of the value that one row in twenty exceeds",
            block::shown(idle, Dimension::Torque.unit_in(units))
        ))),
        (false, None) => notes.push(Note::LeftOut(
            "all windows, because neither rotary speed nor torque shows whether the string turns"
                .to_owned(),
        )),
    }
    if !log.has.torque {
        notes.push(Note::LeftOut("torques, because the log has none".to_owned()));
    }
    notes.extend(depths_in_other_unit(counts));
    if counts.below_bottom.rows > 0 {
        let unit = Dimension::Length.unit_in(units);
        notes.push(Note::LeftOut(format!(
            "{} of {} rows on the hook, because the bit is below the bottom of the hole, by up to \
             {} {}; check the channels of bit depth and hole depth, and their units",
            counts.below_bottom.rows,
            counts.below_bottom.of_rows,
            block::three_digits(unit.from_si(counts.below_bottom.by_m)),
            unit.symbol,
        )));
    }
    if counts.rows_without_time > 0 {
        let text = "rows without a time, or with one that is not after that of the row before";
        notes.push(Note::LeftOut(format!("{} {text}", counts.rows_without_time)));
    }
    if counts.gaps > 0 {
        notes.push(Note::Read(format!("gaps in the log: {}; a stand ends at a gap", counts.gaps)));
    }
    notes
}
