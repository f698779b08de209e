//! Weights and torques at the surface that are physically impossible.
//!
//! Friction makes pick-up ≥ rotating ≥ slack-off (Johancsik, Friesen and Dawson 1984). A hook load
//! with a string in the hole is above zero, and so is the torque of a turning string. These checks
//! require only the readings; those that require the string are made where it is known.

use wholestring_judge::{CheckKind, Quantity, ReadingCheck, Rounding, Severity};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    readings::{ImportedReading, ImportedReadings},
    row_names::row_names,
};

/// Names of weights and torques in sentences, in the order of [`ImportedReadings::units`].
pub const CHANNEL_WORDS: [&str; 5] = [
    "pick-up weight",
    "slack-off weight",
    "rotating weight",
    "torque off bottom",
    "torque on bottom",
];

/// A column of readings.
struct Channel {
    name: &'static str,
    dimension: Dimension,
    /// Accepted and usual values as of the case's keys of this quantity, SI: `max_hook_load` and
    /// `top_drive_torque` of `[rig]`, `density` of `[mud]`.
    range: [f64; 2],
    usual: [f64; 2],
    get: fn(&ImportedReading) -> Option<f64>,
    put: fn(&mut ImportedReading) -> &mut Option<f64>,
}

const PICK_UP: usize = 0;
const SLACK_OFF: usize = 1;
const ROTATING: usize = 2;
const OFF_BOTTOM: usize = 3;
const ON_BOTTOM: usize = 4;

const CHANNELS: [Channel; 5] = [
    Channel {
        name: CHANNEL_WORDS[PICK_UP],
        dimension: Dimension::Force,
        range: [0.0, 1e8],
        usual: [1e4, 2e7],
        get: |reading| reading.pick_up_N,
        put: |reading| &mut reading.pick_up_N,
    },
    Channel {
        name: CHANNEL_WORDS[SLACK_OFF],
        dimension: Dimension::Force,
        range: [0.0, 1e8],
        usual: [1e4, 2e7],
        get: |reading| reading.slack_off_N,
        put: |reading| &mut reading.slack_off_N,
    },
    Channel {
        name: CHANNEL_WORDS[ROTATING],
        dimension: Dimension::Force,
        range: [0.0, 1e8],
        usual: [1e4, 2e7],
        get: |reading| reading.rotating_N,
        put: |reading| &mut reading.rotating_N,
    },
    Channel {
        name: CHANNEL_WORDS[OFF_BOTTOM],
        dimension: Dimension::Torque,
        range: [0.0, 1e6],
        usual: [0.0, 2e5],
        get: |reading| reading.torque_N_m,
        put: |reading| &mut reading.torque_N_m,
    },
    Channel {
        name: CHANNEL_WORDS[ON_BOTTOM],
        dimension: Dimension::Torque,
        range: [0.0, 1e6],
        usual: [0.0, 2e5],
        get: |reading| reading.torque_on_bottom_N_m,
        put: |reading| &mut reading.torque_on_bottom_N_m,
    },
];

/// Densities of the mud, which are checked as weights and torques are.
const DENSITY: Channel = Channel {
    name: "mud density",
    dimension: Dimension::Density,
    range: [0.0, 3000.0],
    usual: [600.0, 2600.0],
    get: |reading| reading.mud_density_kg_per_m3,
    put: |reading| &mut reading.mud_density_kg_per_m3,
};

/// Two columns of which the first has the larger loads.
struct Order {
    greater: usize,
    smaller: usize,
    /// The reason, in a sentence.
    why: &'static str,
    /// Fraction of the rows out of order above which the columns are wrong, which is an error;
    /// `None` if it is none.
    error_above: Option<f64>,
}

/// Reason for the order of weights.
const FRICTION: &str = "friction makes pick-up ≥ rotating ≥ slack-off";

/// Pairs of columns in order. A rotating weight below the slack-off weight is no error, because
/// pumping at the same time lifts the string. A weight on bit relieves the string of some friction,
/// so that a small torque of the bit may leave less torque on bottom in some rows.
const ORDER: [Order; 4] = [
    Order { greater: PICK_UP, smaller: SLACK_OFF, why: FRICTION, error_above: Some(0.5) },
    Order { greater: PICK_UP, smaller: ROTATING, why: FRICTION, error_above: Some(0.5) },
    Order { greater: ROTATING, smaller: SLACK_OFF, why: FRICTION, error_above: None },
    Order {
        greater: ON_BOTTOM,
        smaller: OFF_BOTTOM,
        why: "on bottom the torque of the bit adds to that of the string",
        error_above: Some(0.9),
    },
];

/// Relative difference above which two loads of a row are out of order: twice the error of a
/// weight indicator plus rounding to 5 klbf.
const OUT_OF_ORDER: f64 = 0.03;

/// Factor between the weights of two columns above which their units probably differ.
const OTHER_UNIT: f64 = 2.5;

impl ImportedReadings {
    /// Returns measured readings without the impossible ones, and the findings on them, in these
    /// units. Loads computed by another program are not checked.
    pub fn measured(mut self, units: UnitSet) -> (Self, Vec<ReadingCheck>) {
        let mut checks = Vec::new();
        let is_empty =
            |reading: &ImportedReading| CHANNELS.iter().all(|by| (by.get)(reading).is_none());
        let had_values = !self.readings.iter().all(is_empty);
        for channel in CHANNELS.iter().chain([&DENSITY]) {
            checks.extend(zeros(&mut self.readings, channel));
            checks.extend(negatives(&mut self.readings, channel, units));
            checks.extend(impossible(&mut self.readings, channel, units));
            checks.extend(unusual(&self.readings, channel, units));
        }
        let is_error = |check: &ReadingCheck| check.check.severity == Severity::Error;
        if self.readings.iter().all(is_empty) && !checks.iter().any(is_error) {
            checks.push(nothing_left(&self.readings, had_values));
        }
        match frozen(&self.readings, units) {
            Some(check) => checks.push(check),
            None => checks.extend(order(&self.readings, units)),
        }
        (self, checks)
    }
}

/// The refusal of a file of which no weight and no torque is left.
fn nothing_left(readings: &[ImportedReading], had_values: bool) -> ReadingCheck {
    let places: Vec<String> = readings.iter().map(|reading| reading.place.clone()).collect();
    let rows = row_names(&places);
    let why = match had_values {
        true => format!("all are 0, in {rows}; a zero is not a reading"),
        false => format!("{rows} have none"),
    };
    let sentence = format!("no weight and no torque is left of the readings: {why}");
    ReadingCheck::new(CheckKind::NoReadings, Severity::Error, sentence).on(places)
}

/// Finds zeros in a column and removes them.
fn zeros(readings: &mut [ImportedReading], channel: &Channel) -> Option<ReadingCheck> {
    let values = readings.iter().filter_map(channel.get);
    let (count, zeros) =
        values.fold((0, 0), |(count, zeros), value| (count + 1, zeros + usize::from(value == 0.0)));
    if zeros == 0 {
        return None;
    }
    let mut places = Vec::new();
    for reading in readings.iter_mut().filter(|reading| (channel.get)(reading) == Some(0.0)) {
        *(channel.put)(reading) = None;
        places.push(reading.place.clone());
    }
    let (name, rows) = (channel.name, row_names(&places));
    let why = match channel.dimension {
        Dimension::Torque => "a string that turns has torque",
        Dimension::Density => "no mud is without density, and that of the case is used",
        _ => "a string in the hole has weight",
    };
    let sentence = match (zeros == count, zeros) {
        (true, 1) => {
            format!("the {name} is 0 in {rows}: {why}, and a zero is not a reading; left out")
        }
        (true, _) => format!(
            "the {name} is 0 in all {count} rows ({rows}): {why}, and a zero is not a reading; \
             the column is left out"
        ),
        (false, _) => format!(
            "the {name} is 0 in {rows}, {zeros} of {count} rows: {why}, and a zero is not a \
             reading; left out"
        ),
    };
    Some(
        ReadingCheck::new(CheckKind::ReadingsZero, Severity::Warning, sentence)
            .numbers([Some(0.0), None])
            .on(places),
    )
}

/// Finds negative values in a column and removes them; a column with negative values only is
/// refused.
fn negatives(
    readings: &mut [ImportedReading],
    channel: &Channel,
    units: UnitSet,
) -> Option<ReadingCheck> {
    let values = || readings.iter().filter_map(channel.get);
    let count = values().count();
    let negative: Vec<f64> = values().filter(|value| *value < 0.0).collect();
    if negative.is_empty() {
        return None;
    }
    let formatted = |value: &f64| formatted(channel, *value, units);
    let least = negative.iter().copied().fold(f64::INFINITY, f64::min);
    let all = negative.len() == count;
    let is_negative =
        |reading: &ImportedReading| (channel.get)(reading).is_some_and(|value| value < 0.0);
    let places: Vec<String> = readings
        .iter()
        .filter(|reading| is_negative(reading))
        .map(|reading| reading.place.clone())
        .collect();
    let (name, rows) = (channel.name, row_names(&places));
    let written = match &negative[..] {
        [one] => format!("is {}", formatted(one)),
        [first, .., last] => format!("is negative, {} to {}", formatted(first), formatted(last)),
        [] => String::new(),
    };
    let sentence = match all {
        true => format!(
            "the {name} {written} in every row that has one ({rows}): hook loads and torques are \
             more than zero; change the sign of the column, or leave it out"
        ),
        false => format!(
            "the {name} {written} in {rows}, {} of {count} rows: the sign is wrong, or it is not \
             a reading; left out",
            negative.len()
        ),
    };
    if !all {
        for reading in readings.iter_mut().filter(|reading| is_negative(reading)) {
            *(channel.put)(reading) = None;
        }
    }
    Some(
        ReadingCheck::new(
            CheckKind::ReadingsNegative,
            if all { Severity::Error } else { Severity::Warning },
            sentence,
        )
        .numbers([Some(least), Some(0.0)])
        .on(places)
        .in_units(units),
    )
}

/// A value with its unit, in powers of ten if it is far beyond any gauge.
fn formatted(channel: &Channel, value: f64, units: UnitSet) -> String {
    let unit = channel.dimension.unit_in(units);
    let number = unit.from_si(value);
    match number.abs() < 1e7 {
        true => Quantity::new(channel.dimension, value, Rounding::Five).to_string(),
        false => format!("{number:.3e} {}", unit.symbol),
    }
}

/// Finds a few values that no rig can measure and removes them. If most are impossible, the unit of
/// the column is wrong, which is checked against the string.
fn impossible(
    readings: &mut [ImportedReading],
    channel: &Channel,
    units: UnitSet,
) -> Option<ReadingCheck> {
    let [_, most] = channel.range;
    let count = readings.iter().filter_map(channel.get).count();
    let is_impossible =
        |reading: &ImportedReading| (channel.get)(reading).is_some_and(|value| value > most);
    let outside = readings.iter().filter(|reading| is_impossible(reading));
    let places: Vec<String> = outside.clone().map(|reading| reading.place.clone()).collect();
    let largest = outside.filter_map(channel.get).fold(0.0, f64::max);
    if places.is_empty() || 2 * places.len() > count {
        return None;
    }
    for reading in readings.iter_mut().filter(|reading| is_impossible(reading)) {
        *(channel.put)(reading) = None;
    }
    let sentence = format!(
        "the {} is up to {} in {}, {} of {count} rows: no rig measures more than {}; left out",
        channel.name,
        formatted(channel, largest, units),
        row_names(&places),
        places.len(),
        formatted(channel, most, units),
    );
    Some(
        ReadingCheck::new(CheckKind::ReadingsUnit, Severity::Warning, sentence)
            .numbers([Some(largest), Some(most)])
            .on(places)
            .in_units(units),
    )
}

/// Reports values outside the usual ones, which are kept.
fn unusual(
    readings: &[ImportedReading],
    channel: &Channel,
    units: UnitSet,
) -> Option<ReadingCheck> {
    let [least, most] = channel.usual;
    let value = |reading: &&ImportedReading| (channel.get)(reading).unwrap_or(least);
    let side = |value: f64| match value {
        value if value < 0.0 => None,
        value if value < least => Some("small"),
        value if value > most => Some("large"),
        _ => None,
    };
    let outside = readings.iter().filter(|reading| side(value(reading)).is_some());
    let outside: Vec<&ImportedReading> = outside.collect();
    let first = outside.first().map(value)?;
    let places: Vec<String> = outside.iter().map(|reading| reading.place.clone()).collect();
    let sentence = format!(
        "the {} is unusually {} in {}: {}; usual are {} to {}; check its unit",
        channel.name,
        side(first).unwrap_or("large"),
        row_names(&places),
        formatted(channel, first, units),
        formatted(channel, least, units),
        formatted(channel, most, units),
    );
    Some(
        ReadingCheck::new(CheckKind::ReadingsUnit, Severity::Warning, sentence)
            .numbers([Some(first), Some(if first < least { least } else { most })])
            .on(places)
            .in_units(units),
    )
}

/// Finds pairs of columns in the wrong order, in most rows or in some.
fn order(readings: &[ImportedReading], units: UnitSet) -> Vec<ReadingCheck> {
    let checks = ORDER.iter().filter_map(|order| out_of_order(readings, order, units));
    let mut checks: Vec<ReadingCheck> = checks.collect();
    // Columns that are swapped contradict all others.
    if checks.iter().any(|check| check.check.severity == Severity::Error) {
        checks.retain(|check| check.check.severity == Severity::Error);
    }
    checks
}

fn out_of_order(
    readings: &[ImportedReading],
    order: &Order,
    units: UnitSet,
) -> Option<ReadingCheck> {
    let (greater, smaller) = (&CHANNELS[order.greater], &CHANNELS[order.smaller]);
    let both = readings.iter().filter_map(|reading| {
        Some((reading, (greater.get)(reading)?, (smaller.get)(reading)?))
            .filter(|(_, greater, smaller)| *greater > 0.0 && *smaller > 0.0)
    });
    let both: Vec<_> = both.collect();
    let wrong: Vec<_> = both.iter().filter(|pair| pair.2 > pair.1 * (1.0 + OUT_OF_ORDER)).collect();
    let worst = wrong.iter().max_by(|a, b| (a.2 / a.1).total_cmp(&(b.2 / b.1)))?;
    let places: Vec<String> = wrong.iter().map(|pair| pair.0.place.clone()).collect();
    let part = wrong.len() as f64 / both.len() as f64;
    let is_error = order.error_above.is_some_and(|limit| part > limit);
    let is_torque = greater.dimension == Dimension::Torque;
    let mut sentence = format!(
        "the {} is below the {} in {} of {} rows ({}), by most in {}: {} below {}; {}",
        greater.name,
        smaller.name,
        wrong.len(),
        both.len(),
        row_names(&places),
        worst.0.place,
        formatted(greater, worst.1, units),
        formatted(smaller, worst.2, units),
        order.why,
    );
    // Torques off bottom may be small, so that a large ratio shows no other unit.
    sentence += match (is_error, !is_torque && worst.2 / worst.1 > OTHER_UNIT) {
        (true, true) => ": is one of the columns in another unit?",
        (true, false) => ": are the columns swapped?",
        (false, _) if is_torque => {
            ": check the columns, and whether the string was off bottom and at the same speed"
        }
        (false, _) if part > 0.5 => {
            ": are the columns swapped, or do the pumps lift the string while it rotates?"
        }
        (false, _) => ": these rows contradict themselves; check them",
    };
    let (kind, severity) = match is_error {
        true => (CheckKind::ReadingsSwapped, Severity::Error),
        false => (CheckKind::OrderOfLoads, Severity::Warning),
    };
    let check = ReadingCheck::new(kind, severity, sentence);
    Some(check.numbers([Some(worst.1), Some(worst.2)]).on(places).in_units(units))
}

/// Smallest number of rows in which a sensor that does not change is recognised, and the smallest
/// change of the bit's depth over the largest: a string of this length more has another weight.
const FROZEN_ROWS: usize = 3;
const FROZEN_DEPTHS: f64 = 0.2;

/// Finds weights that are one number in every row and column: the sensor was frozen, because the
/// weight of a string grows with the depth of the bit, and friction separates pick-up and slack-off.
fn frozen(readings: &[ImportedReading], units: UnitSet) -> Option<ReadingCheck> {
    let weights = |reading: &ImportedReading| {
        let channels = CHANNELS.iter().filter(|channel| channel.dimension == Dimension::Force);
        channels.filter_map(|channel| (channel.get)(reading)).collect::<Vec<f64>>()
    };
    let rows: Vec<&ImportedReading> =
        readings.iter().filter(|reading| !weights(reading).is_empty()).collect();
    let first = *weights(rows.first()?).first()?;
    let depths = || rows.iter().map(|reading| reading.bit_depth_m);
    let (least_m, most_m) = (depths().fold(f64::INFINITY, f64::min), depths().fold(0.0, f64::max));
    if rows.len() < FROZEN_ROWS
        || most_m - least_m < FROZEN_DEPTHS * most_m
        || rows.iter().flat_map(|reading| weights(reading)).any(|weight| weight != first)
    {
        return None;
    }
    let names: Vec<&str> = CHANNELS
        .iter()
        .filter(|channel| channel.dimension == Dimension::Force)
        .filter(|channel| rows.iter().any(|reading| (channel.get)(reading).is_some()))
        .map(|channel| channel.name.trim_end_matches(" weight"))
        .collect();
    let weights_are = match &names[..] {
        [one] => format!("{one} weight is"),
        [others @ .., last] => format!("{} and {last} weights are", others.join(", ")),
        [] => return None,
    };
    let places: Vec<String> = rows.iter().map(|reading| reading.place.clone()).collect();
    let sentence = format!(
        "the {weights_are} {} in all {} rows ({}), with the bit at {} to {}: the sensor seems frozen, \
         because the hook load changes with the depth of the bit; leave these weights out, or \
         read another channel",
        formatted(&CHANNELS[PICK_UP], first, units),
        rows.len(),
        row_names(&places),
        Quantity::depth(least_m),
        Quantity::depth(most_m),
    );
    // A single column may be rounded to steps as coarse as its changes.
    let severity = if names.len() > 1 { Severity::Error } else { Severity::Warning };
    let check = ReadingCheck::new(CheckKind::NoReadings, severity, sentence);
    Some(check.numbers([Some(first), None]).on(places).in_units(units))
}
