//! Checks of weights against the block and the string.

use wholestring_judge::{CheckKind, ReadingCheck, Severity};
use wholestring_plan::calibration::Channel;
use wholestring_tabular::row_names;
use wholestring_units::Dimension;

use super::{
    text::{dimension, median, plural, shown, words},
    trial::{Block, MOST, Trial, rows, weight_rows},
    units::is_free,
};
use crate::readings::Readings;

/// A block held at the case's weight is reported as wrong if the misfit exceeds this fraction of
/// the weights and also this multiple of the misfit with a fitted block.
const OFF: f64 = 0.03;
const WORSE: f64 = 2.5;

/// Smallest number of weights from which a block is identified.
const FEWEST: usize = 4;

/// A pick-up or rotating weight below this fraction of the string's buoyed weight is no reading: the
/// rest is the error of the string's weight, of the mud, and of the weight indicator.
const LIGHT: f64 = 0.75;

/// Readings are left out if they are less than this fraction of their column; otherwise a fitted
/// block cannot explain the column, and a block that is held is wrong.
const FEW: f64 = 0.5;

/// Friction that changes no weight by more than this fraction, and that causes less than this
/// fraction of the torques, is not identified by either.
const WEIGHT_CHANGE: f64 = 0.003;
const TORQUE_CHANGE: f64 = 0.2;

/// Compares the block weight of the case with that in the readings.
pub(super) fn of_case(data: &Readings, trial: &Trial) -> Option<ReadingCheck> {
    let Block::Held(held_N) = trial.block else { return None };
    let rows = weight_rows(data);
    if rows.len() < FEWEST {
        return None;
    }
    let (held, free) =
        (trial.misfit(data, &rows, 1.0, trial.block), trial.misfit(data, &rows, 1.0, Block::Any));
    if held.part < OFF || held.part < WORSE * free.part {
        return None;
    }
    let size_N = median(rows.iter().map(|&row| data.readings[row].value.abs()).collect());
    let force = |force_N: f64| shown(force_N, Dimension::Force);
    let off_N = free.block_N - held_N;
    let without = free.block_N.abs() < (0.2 * held_N).max(0.02 * size_N);
    let (kind, sentence) = match without {
        true => (
            CheckKind::BlockNotInReadings,
            format!(
                "the weights are {} below the expected values, about the weight of the block, {}: \
                 they seem to exclude the block. Add it to the readings, or fit the block weight \
                 (`--block-weight`)",
                force(-off_N),
                force(held_N),
            ),
        ),
        false => (
            CheckKind::BlockWeight,
            format!(
                "the weights are {} {} the expected values with the case's block of {}; a block \
                 of {} would match them. Check `block_weight`, the weight indicator, the mud and \
                 the string, or fit the block weight (`--block-weight`)",
                force(off_N.abs()),
                if off_N > 0.0 { "above" } else { "below" },
                force(held_N),
                force(free.block_N),
            ),
        ),
    };
    Some(
        ReadingCheck::new(kind, Severity::Warning, sentence)
            .numbers([Some(free.block_N), Some(held_N)]),
    )
}

/// A block in some kinds of weights only: they differ by at least this fraction of the weights, and
/// those without it have less than this fraction of it.
const DIFFER: f64 = 0.05;
const NONE: f64 = 0.25;

/// Detects a block that some kinds of weights contain and others do not, such as pick-up weights of
/// the indicator next to slack-off weights from which the block was subtracted. Friction and one
/// block explain both only in part.
pub(super) fn in_some(data: &Readings, trial: &Trial) -> Option<ReadingCheck> {
    let rows = weight_rows(data);
    let count = |channel| rows.iter().filter(|&&row| data.readings[row].channel == channel).count();
    if [Channel::PickUp, Channel::SlackOff].into_iter().any(|channel| count(channel) < FEWEST) {
        return None;
    }
    let (together, apart) = (trial.misfit(data, &rows, 1.0, Block::Any), trial.misfit_apart(data));
    let size_N = median(rows.iter().map(|&row| data.readings[row].value.abs()).collect());
    let largest_N = apart.blocks_N.iter().map(|(_, block_N)| *block_N).fold(0.0, f64::max);
    if together.part < WORSE * apart.part || largest_N < DIFFER * size_N {
        return None;
    }
    let lacks = |block_N: f64| block_N.abs() < NONE * largest_N;
    let holds = |block_N: f64| block_N > (1.0 - NONE) * largest_N;
    let (without, with): (Vec<_>, Vec<_>) =
        apart.blocks_N.iter().partition(|(_, block_N)| lacks(*block_N));
    if without.is_empty() || with.is_empty() || !with.iter().all(|(_, block_N)| holds(*block_N)) {
        return None;
    }
    let named = |channels: &[(Channel, f64)]| {
        let names: Vec<String> = channels.iter().map(|(channel, _)| plural(*channel)).collect();
        names.join(" and the ")
    };
    let force = |force_N: f64| shown(force_N, Dimension::Force);
    let off: Vec<String> = without
        .iter()
        .map(|(channel, block_N)| {
            format!(
                "the {} {} {}",
                plural(*channel),
                force(block_N.abs()),
                if *block_N < 0.0 { "below" } else { "above" }
            )
        })
        .collect();
    let sentence = format!(
        "the {} alone appear to contain the block: they are {} above the loads of the string, {}. \
         Give all weights with the block or all without it",
        named(&with),
        force(with.iter().map(|(_, block_N)| *block_N).sum::<f64>() / with.len() as f64),
        off.join(", "),
    );
    let held_N = match trial.block {
        Block::Held(held_N) => Some(held_N),
        Block::Free | Block::Any => None,
    };
    Some(
        ReadingCheck::new(CheckKind::BlockNotInReadings, Severity::Warning, sentence)
            .numbers([Some(largest_N), held_N]),
    )
}

/// Leaves out hook loads below the block's weight or far below the string's, if they are few. Many
/// far below the string's are an error: no block and no friction gives them.
pub(super) fn below(data: &mut Readings, trial: &Trial) -> Vec<ReadingCheck> {
    let mut checks = Vec::new();
    let mut out = vec![false; data.readings.len()];
    for channel in [Channel::PickUp, Channel::SlackOff, Channel::Rotating] {
        let own = rows(data, |row_channel| row_channel == channel);
        let least_N = |row: usize| match trial.block {
            Block::Held(block_N) if block_N > 0.0 => block_N,
            _ if channel == Channel::SlackOff => 0.0,
            _ => LIGHT * trial.weights_N[row],
        };
        let low: Vec<usize> =
            own.iter().copied().filter(|&row| data.readings[row].value < least_N(row)).collect();
        let Some(&first) = low.first() else { continue };
        let is_few = (low.len() as f64) < FEW * own.len() as f64;
        if !is_few && !is_free(trial.block) {
            continue;
        }
        let places: Vec<String> = low.iter().map(|&row| data.places[row].clone()).collect();
        let force = |force_N: f64| shown(force_N, Dimension::Force);
        let why = match is_free(trial.block) {
            true => format!("the string alone weighs {}", force(trial.weights_N[first])),
            false => format!("the block alone weighs {}", force(least_N(first))),
        };
        let last = low[low.len() - 1];
        let values = match low.len() {
            1 => format!("is {}", force(data.readings[first].value)),
            _ => format!(
                "is {} to {}",
                force(data.readings[first].value),
                force(data.readings[last].value)
            ),
        };
        let why = match (is_free(trial.block), low.len()) {
            (true, 1) => format!("{why} in the mud"),
            (true, _) => format!("{why} to {} in the mud", force(trial.weights_N[last])),
            _ => why,
        };
        let check = if is_few {
            low.iter().for_each(|&row| out[row] = true);
            let noun = match low.len() {
                1 => "it is no valid reading and is left out",
                _ => "they are no valid readings and are left out",
            };
            let sentence = format!(
                "the {} {values} in {}, although {why}: {noun}",
                words(channel),
                row_names(&places)
            );
            ReadingCheck::new(CheckKind::BelowBlock, Severity::Warning, sentence)
        } else {
            let sentence = format!(
                "the {} {values} in {}, {} of {} readings, although {why}: too few remain; check \
                 the unit of the weights, the string, the mud and the survey",
                words(channel),
                row_names(&places),
                low.len(),
                own.len(),
            );
            ReadingCheck::new(CheckKind::BelowBlock, Severity::Error, sentence)
        };
        let numbers = [data.readings[first].value, least_N(first)].map(Some);
        checks.push(check.numbers(numbers).on(places));
    }
    let mut keep = out.iter().map(|out| !out);
    data.readings.retain(|_| keep.next().unwrap_or(true));
    let mut keep = out.iter().map(|out| !out);
    data.places.retain(|_| keep.next().unwrap_or(true));
    checks
}

/// Reports readings on which friction has no effect: rotating weights alone, which do not depend on
/// axial friction, or a hole with too little side force.
pub(super) fn no_friction(data: &Readings, trial: &Trial) -> Option<ReadingCheck> {
    if let Some(first) = data.readings.first()
        && data.readings.iter().all(|reading| reading.channel == Channel::Rotating)
    {
        let sentence = "the readings are rotating weights alone, on which friction has no effect: \
                        a string that turns off bottom has no axial friction. Give pick-up or \
                        slack-off weights or torques too; or keep every friction factor fixed \
                        (`--hold`) and fit the block weight alone (`--block-weight`)";
        let check = ReadingCheck::new(CheckKind::NoFriction, Severity::Error, sentence.to_owned());
        return Some(check.numbers([Some(0.0), Some(first.value)]));
    }
    let change = |row: usize| {
        let reading = &data.readings[row];
        let change = (trial.load(row, MOST) - trial.load(row, 0.0)).abs();
        let enough = if reading.channel.is_torque() { TORQUE_CHANGE } else { WEIGHT_CHANGE };
        (row, change, change / (enough * reading.value.abs().max(1e-9)))
    };
    let (row, most, share) =
        (0..data.readings.len()).map(change).max_by(|a, b| a.2.total_cmp(&b.2))?;
    if share >= 1.0 {
        return None;
    }
    let reading = &data.readings[row];
    let quantity = |value: f64| shown(value, dimension(reading.channel));
    let sentence = format!(
        "friction has no effect on the readings: a factor of {MOST} would change the {} of {} \
         ({}) by {:.1} %, and the others by less, because the hole is so straight that the string \
         hardly touches it. Read with the bit in a curved or inclined part to find the friction",
        words(reading.channel),
        quantity(reading.value),
        data.places[row],
        100.0 * most / reading.value.abs().max(1e-9),
    );
    let check = ReadingCheck::new(CheckKind::NoFriction, Severity::Error, sentence);
    Some(check.numbers([Some(most), Some(reading.value)]))
}
