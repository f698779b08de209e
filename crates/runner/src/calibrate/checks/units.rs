//! Columns in another unit than their headings.
//!
//! In the right unit some friction factor and some block weight match the weights; in another unit
//! none does, and a factor between two units corrects them.

use wholestring_judge::{CheckKind, Quantity, ReadingCheck, Severity};
use wholestring_plan::calibration::Channel;

use wholestring_units::{Dimension, Unit, significant};

use super::{
    text::{dimension, median, plural, share, shown, words},
    trial::{Block, MOST, Trial, rows, weight_rows},
};
use crate::{error::Error, readings::Readings};

/// Weights with a larger misfit than this in the unit of their heading are tested in other units.
const POOR: f64 = 0.08;
/// In the right unit the misfit is at most this, and smaller by this factor.
const GOOD: f64 = 0.04;
const BETTER: f64 = 3.0;

/// Upper limit of the weight of a block with top drive, N.
const HEAVIEST_BLOCK_N: f64 = 2.5e6;

/// A foot, m.
const FOOT_M: f64 = 0.3048;

/// Smallest number of readings from which a unit is identified.
const FEWEST: usize = 4;

/// Range of friction factors in holes; a torque that requires more than the upper is in another
/// unit.
const USUAL: [f64; 2] = [0.05, 0.7];
const POSSIBLE: [f64; 2] = [0.03, 1.0];

/// Torque per unit of friction over the string's weight, m; below it the hole is too straight to
/// identify a unit from torques.
const SIDE_FORCE_M: f64 = 0.008;

/// A unit within this relative difference of that of the heading, such as kilodecanewtons under
/// tonnes, is not proposed. Units within the smaller difference are the same.
const ALIKE: f64 = 0.03;
const SAME: f64 = 1e-6;

/// The unit is in doubt if friction from torques over friction from drag is this close to the ratio
/// of N·m and ft·lbf, and the readings scatter no more than this.
const NEAR: f64 = 0.04;
const EVEN: f64 = 0.05;

/// The unit is proposed only if that ratio is within this many standard errors of the median, or
/// within the error of reading a torque, and the rotating weights match within this part.
const ERRORS: f64 = 3.0;
const READ: f64 = 0.01;
const ROTATING: f64 = 0.03;

/// The other units of a dimension, each with the factor that corrects numbers written in it; of
/// units with the same factor the first.
pub(super) fn others(dimension: Dimension, heading: &Unit) -> Vec<(&'static Unit, f64)> {
    let mut others: Vec<(&'static Unit, f64)> = Vec::new();
    for unit in dimension.units() {
        let factor = unit.factor / heading.factor;
        let known = others.iter().any(|(_, other)| (other / factor - 1.0).abs() < SAME);
        if (factor - 1.0).abs() > ALIKE && !known {
            others.push((unit, factor));
        }
    }
    others
}

/// Units by their symbols, such as `klbf` or `klbf or t`.
fn named(units: &[&'static Unit]) -> String {
    units.iter().take(2).map(|unit| unit.symbol).collect::<Vec<_>>().join(" or ")
}

fn error(data: &Readings, rows: &[usize], sentence: String) -> ReadingCheck {
    ReadingCheck::new(CheckKind::ReadingsUnit, Severity::Error, sentence)
        .on(rows.iter().map(|&row| data.places[row].clone()).collect())
}

/// Detects weights in another unit: all of them, or one column.
pub(super) fn weights(data: &Readings, trial: &Trial) -> Vec<ReadingCheck> {
    let all = weight_rows(data);
    if all.len() < FEWEST {
        return Vec::new();
    }
    let headings = Channel::ALL.map(|channel| data.units[channel as usize]);
    let mut used = all.iter().filter_map(|&row| headings[data.readings[row].channel as usize]);
    let Some(heading) = used.next() else { return Vec::new() };
    let is_one = used.all(|unit| unit == heading);
    let as_is = trial.misfit(data, &all, 1.0, trial.block);
    if is_one && as_is.part > POOR {
        let met = others(Dimension::Force, heading)
            .into_iter()
            .map(|(unit, factor)| (unit, factor, trial.misfit(data, &all, factor, trial.block)));
        let mut met: Vec<_> = met
            .filter(|(_, _, misfit)| {
                misfit.part < GOOD
                    && misfit.part * BETTER < as_is.part
                    && misfit.block_N < HEAVIEST_BLOCK_N
            })
            .collect();
        met.sort_by(|a, b| a.2.part.total_cmp(&b.2.part));
        if let Some(&(unit, factor, best)) = met.first() {
            let row = all[all.len() / 2];
            let reading = &data.readings[row];
            let force = |force_N: f64| shown(force_N, Dimension::Force);
            let likely: Vec<_> = met
                .iter()
                .filter(|candidate| candidate.2.part < 2.0 * best.part)
                .map(|candidate| candidate.0)
                .collect();
            let sentence = format!(
                "the weights seem not to be in {}, the unit of their headings: with {} they deviate \
                 by {} or more from the loads of the string in this hole, but in {} they match \
                 within {:.1} % (a factor of {}); {}: a {} of {} with the bit at \
                 {}, where {} is expected. Is the unit {}?",
                heading.symbol,
                trial.block.left_open(),
                share(as_is.part),
                unit.symbol,
                100.0 * best.part.max(1e-3),
                wholestring_units::number_text((1e4 * factor).round() / 1e4),
                data.places[row],
                words(reading.channel),
                force(reading.value),
                Quantity::depth(reading.bit_depth_m),
                force(trial.load(row, best.friction) + best.block_N),
                named(&likely),
            );
            return vec![error(data, &all, sentence)];
        }
    }
    let channels = [Channel::PickUp, Channel::SlackOff, Channel::Rotating];
    channels.into_iter().filter_map(|channel| column(data, trial, channel, headings)).collect()
}

/// Detects bit depths in metres under feet, or in feet under metres: the weights match none of the
/// loads at these depths, and those at the others well. `at` solves the strings with the depths
/// multiplied by a factor; `None` if one of them does not fit in its hole.
pub(super) fn depths(
    data: &Readings,
    trial: &Trial,
    at: impl Fn(f64) -> Result<Option<Trial>, Error>,
) -> Result<Option<ReadingCheck>, Error> {
    let all = weight_rows(data);
    let as_is = trial.misfit(data, &all, 1.0, trial.block);
    if all.len() < FEWEST || as_is.part <= GOOD {
        return Ok(None);
    }
    let heading = all.iter().find_map(|&row| data.units[data.readings[row].channel as usize]);
    // Weights grow with depth, so that a unit of force may explain them too.
    let by_force = heading.into_iter().flat_map(|heading| others(Dimension::Force, heading));
    let by_force = by_force
        .map(|(_, factor)| trial.misfit(data, &all, factor, trial.block))
        .filter(|misfit| misfit.block_N < HEAVIEST_BLOCK_N)
        .fold(as_is.part, |least, misfit| least.min(misfit.part));
    for (factor, heading, unit) in [(1.0 / FOOT_M, "ft", "m"), (FOOT_M, "m", "ft")] {
        let Some(other) = at(factor)? else { continue };
        let misfit = other.misfit(data, &all, 1.0, trial.block);
        let is_plausible = misfit.part < GOOD && misfit.block_N < HEAVIEST_BLOCK_N;
        if !is_plausible || misfit.part * BETTER >= as_is.part || misfit.part * 2.0 >= by_force {
            continue;
        }
        let row = all[all.len() / 2];
        let sentence = format!(
            "the bit depths seem not to be in {heading}, the unit of their heading: with {} the \
             weights deviate by {} or more from the loads of the string at these \
             depths, but with the depths in {unit} they match within {:.1} % (a factor of {}); {}: \
             a {} of {} with the bit at {}, where {} is expected. Is the unit {unit}?",
            trial.block.left_open(),
            share(as_is.part),
            100.0 * misfit.part.max(1e-3),
            wholestring_units::number_text((1e4 * factor).round() / 1e4),
            data.places[row],
            words(data.readings[row].channel),
            shown(data.readings[row].value, Dimension::Force),
            Quantity::depth(data.readings[row].bit_depth_m),
            shown(trial.load(row, misfit.friction) + misfit.block_N, Dimension::Force),
        );
        return Ok(Some(error(data, &all, sentence)));
    }
    Ok(None)
}

/// Detects a column of weights in another unit than the others.
fn column(
    data: &Readings,
    trial: &Trial,
    channel: Channel,
    headings: [Option<&'static Unit>; 5],
) -> Option<ReadingCheck> {
    /// Relative deviation of the column, and the largest deviation in the right unit.
    const OFF: f64 = 0.3;
    const ON: f64 = 0.1;
    let own = rows(data, |row_channel| row_channel == channel);
    let other = rows(data, |row_channel| row_channel != channel && !row_channel.is_torque());
    if own.len() + 1 < FEWEST || other.len() < FEWEST {
        return None;
    }
    let met = trial.misfit(data, &other, 1.0, trial.block);
    let expected = |row: usize| trial.load(row, met.friction) + met.block_N;
    let size = median(own.iter().map(|&row| expected(row)).collect()).max(1e-9);
    let off = |factor: f64| {
        let off = own.iter().map(|&row| (factor * data.readings[row].value - expected(row)).abs());
        median(off.collect()) / size
    };
    let heading = headings[channel as usize]?;
    if met.part > GOOD || off(1.0) < OFF {
        return None;
    }
    let others = others(Dimension::Force, heading).into_iter();
    let best = others.map(|(unit, factor)| (unit, off(factor)));
    let (unit, part) = best.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|best| best.1 < ON)?;
    let sentence = format!(
        "the {} seem not to be in {}, the unit of their heading: the other weights match within \
         {:.1} %, these deviate by {}, and in {} by {:.1} %. Is the unit {}?",
        plural(channel),
        heading.symbol,
        100.0 * met.part.max(1e-3),
        share(off(1.0)),
        unit.symbol,
        100.0 * part,
        unit.symbol,
    );
    Some(error(data, &own, sentence))
}

/// Detects torques in another unit: they require a friction factor outside the usual range.
pub(super) fn torques(data: &Readings, trial: &Trial) -> Vec<ReadingCheck> {
    let channels = [Channel::OffBottomTorque, Channel::OnBottomTorque];
    channels.into_iter().filter_map(|channel| torque(data, trial, channel)).collect()
}

fn torque(data: &Readings, trial: &Trial, channel: Channel) -> Option<ReadingCheck> {
    let own = rows(data, |row_channel| row_channel == channel);
    let heading = data.units[channel as usize]?;
    let bit_N_m = match channel {
        Channel::OnBottomTorque => trial.bit_torque_N_m?,
        _ => 0.0,
    };
    let slope = |row: usize| trial.load(row, MOST) / MOST;
    let weight_N = median(own.iter().map(|&row| trial.weights_N[row]).collect());
    if own.len() < 3
        || median(own.iter().map(|&row| slope(row)).collect()) < SIDE_FORCE_M * weight_N
    {
        return None;
    }
    let frictions = |factor: f64| -> Vec<f64> {
        let slope = |&row: &usize| (factor * data.readings[row].value - bit_N_m) / slope(row);
        own.iter().map(slope).collect()
    };
    let friction = median(frictions(1.0));
    let rounded = |value: f64| wholestring_units::number_text((1e3 * value).round() / 1e3);
    if (USUAL[0]..=USUAL[1]).contains(&friction) {
        // Without a good match of the weights the model cannot be used to test torques.
        by_weights(data, trial)?;
        return as_feet(data, trial, &own, (heading, bit_N_m));
    }
    let target = by_weights(data, trial).unwrap_or(0.25).max(0.05);
    let candidates = others(Dimension::Torque, heading).into_iter();
    let candidates = candidates.map(|(unit, factor)| (unit, factor, median(frictions(factor))));
    let mut likely: Vec<_> =
        candidates.filter(|candidate| (USUAL[0]..=USUAL[1]).contains(&candidate.2)).collect();
    let far = |friction: f64| libm::log(friction / target).abs();
    likely.sort_by(|a, b| far(a.2).total_cmp(&far(b.2)));
    let row = own[own.len() / 2];
    let (unit, factor, would) = *likely.first()?;
    let sentence = format!(
        "the {} require a friction factor of {}, outside the range of any hole; in {} it would \
         be {} (a factor of {}). {}: {} with the bit at {}, where {} is expected with a friction \
         of {}. Is the unit {}?",
        plural(channel),
        rounded(friction),
        unit.symbol,
        rounded(would),
        wholestring_units::number_text(significant(factor, 4)),
        data.places[row],
        shown(data.readings[row].value, dimension(channel)),
        Quantity::depth(data.readings[row].bit_depth_m),
        shown(slope(row) * target + bit_N_m, dimension(channel)),
        rounded(target),
        named(&likely.iter().map(|likely| likely.0).collect::<Vec<_>>()),
    );
    let mut check = error(data, &own, sentence);
    if (POSSIBLE[0]..=POSSIBLE[1]).contains(&friction) {
        check.check.severity = Severity::Warning;
    }
    check.check.value = Some(friction);
    check.check.limit = Some(if friction > target { USUAL[1] } else { USUAL[0] });
    Some(check)
}

/// Friction factor that follows from pick-up and slack-off weights, if these are matched well.
fn by_weights(data: &Readings, trial: &Trial) -> Option<f64> {
    let all = weight_rows(data);
    let has = |channel| all.iter().any(|&row| data.readings[row].channel == channel);
    let met = trial.misfit(data, &all, 1.0, trial.block);
    (has(Channel::PickUp) && has(Channel::SlackOff) && met.part < EVEN).then_some(met.friction)
}

/// Detects torques whose friction differs from that of the weights by the ratio of N·m and ft·lbf.
/// At each depth the drag, pick-up minus slack-off weight, gives a friction factor independent of
/// the block.
fn as_feet(
    data: &Readings,
    trial: &Trial,
    own: &[usize],
    (heading, bit_N_m): (&Unit, f64),
) -> Option<ReadingCheck> {
    let at = |row: usize, channel: Channel| {
        let here = &data.readings[row];
        let is = |row: &&usize| {
            let other = &data.readings[**row];
            (other.setup, other.bit_depth_m, other.channel)
                == (here.setup, here.bit_depth_m, channel)
        };
        (0..data.readings.len()).collect::<Vec<_>>().iter().find(is).copied()
    };
    let ratio = |&row: &usize| {
        let (up, down) = (at(row, Channel::PickUp)?, at(row, Channel::SlackOff)?);
        let drag_N = data.readings[up].value - data.readings[down].value;
        let drag_N = |friction: f64| trial.load(up, friction) - trial.load(down, friction) - drag_N;
        let (mut low, mut high) = (0.0, MOST);
        if drag_N(low) > 0.0 || drag_N(high) < 0.0 {
            return None;
        }
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            if drag_N(middle) < 0.0 { low = middle } else { high = middle }
        }
        let by_torque = (data.readings[row].value - bit_N_m) * MOST / trial.load(row, MOST);
        Some(by_torque / low).filter(|ratio| ratio.is_finite() && low > 0.02)
    };
    let ratios: Vec<f64> = own.iter().filter_map(ratio).collect();
    let middle = median(ratios.clone());
    let apart = median(ratios.iter().map(|ratio| (ratio - middle).abs()).collect());
    let feet = |(_, factor): &&(&'static Unit, f64)| {
        (0.7..1.4).contains(factor) && (middle * factor - 1.0).abs() < NEAR
    };
    if ratios.len() < FEWEST || apart > EVEN * middle {
        return None;
    }
    let others = others(Dimension::Torque, heading);
    let (unit, factor) = others.iter().find(feet)?;
    // Standard error of a median of normal errors, from their median deviation.
    let spread = 1.2533 * 1.4826 * apart / (ratios.len() as f64).sqrt() / middle;
    let rotating = rows(data, |channel| channel == Channel::Rotating);
    let agrees = !rotating.is_empty()
        && trial.misfit(data, &rotating, 1.0, trial.block).part < ROTATING
        && (middle * factor - 1.0).abs() < (ERRORS * spread).max(READ);
    let advice = match agrees {
        true => format!(
            "it would be the same if they were in {} instead of {}. Is that the unit?",
            unit.symbol, heading.symbol
        ),
        false => "the model does not explain both; check the weights of pipe and block, the mud, \
                  the well, and the units"
            .to_owned(),
    };
    let sentence = format!(
        "the {} require {middle:.2} times the friction of the pick-up and slack-off weights: \
         {advice}",
        plural(data.readings[*own.first()?].channel),
    );
    let mut check = error(data, own, sentence);
    check.check.severity = Severity::Warning;
    (check.check.value, check.check.limit) = (Some(middle), Some(1.0));
    Some(check)
}

/// Whether the block weight is free, which is the case if it is fitted.
pub(super) fn is_free(block: Block) -> bool {
    matches!(block, Block::Free)
}
