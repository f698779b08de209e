//! Checks of a fit.

use wholestring_judge::{CheckKind, Quantity, ReadingCheck, Severity};
use wholestring_plan::calibration::{
    Calibration, Channel, ErrorKind, LOSS, Outliers, Parameter, Point, Settings,
};
use wholestring_units::Dimension;

use super::{
    super::notes::{dimension as of_kind, size},
    text::{dimension, median, plural, share, shown, warning},
    units::others,
};
use crate::readings::Readings;

/// Given errors are too small if the sum of squares exceeds its expectation by this many standard
/// deviations; its cube root is nearly normal (Wilson and Hilferty 1931).
const TOO_FAR: f64 = 3.0;

/// Estimated errors beyond this fraction of the readings are not errors of an instrument, by
/// [`ErrorKind`]. Readings from a rig's daily reports scatter by 7 to 8 % of their weights.
const PLAUSIBLE: [f64; 3] = [0.08, 0.08, 0.35];

/// Estimated errors beyond this multiple of the plausible ones leave their readings without
/// information.
const NO_INFORMATION: f64 = 1.5;

/// A block weight below this fraction of the weights means that the readings exclude the block.
const NO_BLOCK: f64 = 0.01;

/// Returns the checks of a fit; `robust` marks the readings that a robust fit does not follow.
pub(in super::super) fn of_fit(
    data: &Readings,
    found: &Calibration,
    settings: &Settings,
    robust: Option<&Outliers>,
) -> Vec<ReadingCheck> {
    let mut checks: Vec<ReadingCheck> = bounds(found).collect();
    checks.extend(no_block(found, settings));
    checks.extend(estimated_errors(found));
    checks.extend(one_sided(data, found));
    checks.extend(found.confused.iter().map(|confused| {
        let sentence = format!(
            "the readings do not separate the {} from the {}: their correlation is {:.3}; keep \
             one of them fixed, or read at other depths",
            confused.first.words(),
            confused.second.words(),
            confused.correlation
        );
        let numbers = [confused.correlation, settings.correlated_beyond].map(Some);
        warning(CheckKind::NotToldApart, sentence).numbers(numbers)
    }));
    checks.extend(open_intervals(found));
    checks.extend(scatter(found));
    checks.extend(outliers(data, found, robust));
    if let Some(count) = robust.and_then(|robust| robust.too_many) {
        let all = found.points.len();
        let sentence = format!(
            "{count} of {all} readings are outliers of a robust fit ({LOSS}'s loss), too many to \
             be single faults; check units, block, mud, string and survey"
        );
        let numbers = [count as f64, 0.25 * all as f64].map(Some);
        checks.push(warning(CheckKind::TooManyOutliers, sentence).numbers(numbers));
    }
    checks.extend(band(found, settings));
    checks
}

/// Parameters at a bound, which otherwise would be negative.
fn bounds(found: &Calibration) -> impl Iterator<Item = ReadingCheck> {
    found.estimates.iter().filter(|estimate| estimate.at_bound).map(|estimate| {
        let why = match estimate.parameter {
            Parameter::BlockWeight => {
                "the weights are below the weight of the string alone in the mud; check mud, \
                 string, survey and the unit of the weights"
            }
            Parameter::BitTorque => {
                "the torques on bottom are below those expected from the torques off bottom"
            }
            _ => {
                "the readings are below the loads of the string without friction, or another \
                 parameter is wrong"
            }
        };
        let words = estimate.parameter.words();
        let sentence = format!("the {words} would be negative and is held at zero: {why}");
        warning(CheckKind::ReadingsNegative, sentence).numbers([Some(estimate.value), Some(0.0)])
    })
}

/// A fitted block weight that is close to zero.
fn no_block(found: &Calibration, settings: &Settings) -> Option<ReadingCheck> {
    let is = |estimate: &&wholestring_plan::calibration::Estimate| {
        estimate.parameter == Parameter::BlockWeight && !estimate.at_bound
    };
    let block = found.estimates.iter().find(is)?;
    let weights = found.points.iter().filter(|point| !point.reading.channel.is_torque());
    let size_N = median(weights.map(|weight| weight.reading.value.abs()).collect());
    (block.value < NO_BLOCK * size_N).then(|| {
        let sentence = format!(
            "the block weight is fitted as {}: the weights seem to exclude the block; results are \
             compared with hook loads without it (confidence {:.0} %)",
            shown(block.value, Dimension::Force),
            100.0 * settings.confidence
        );
        ReadingCheck::new(CheckKind::NoBlock, Severity::Note, sentence)
            .numbers([Some(block.value), Some(NO_BLOCK * size_N)])
    })
}

/// Estimated errors far beyond those of an instrument: the band then contains every reading, and
/// readings of that kind carry no information.
fn estimated_errors(found: &Calibration) -> impl Iterator<Item = ReadingCheck> {
    let large =
        found.errors.iter().filter_map(move |error| {
            let size = size(found, error.kind);
            let limit = PLAUSIBLE[error.kind.place()] * size;
            (!error.given && error.value > limit).then(|| {
            let instrument = match error.kind {
                ErrorKind::Torque => "a torque reading has an error of 2 to 10 %",
                _ => "a weight indicator has an error of 1 to 3 %",
            };
            let little = match error.value > NO_INFORMATION * limit {
                true => ", they contribute almost nothing to the fit",
                false => "",
            };
            let causes = match error.kind {
                ErrorKind::Torque => "check the columns, units, torque on bit, string and survey",
                _ => "likely causes are the weights of block or pipe, the mud, the pumps, and the \
                      hole and survey of the case; check columns and units too",
            };
            let sentence = format!(
                "the {} deviate from the fit by {} (their standard error, estimated), {}, whereas \
                 {instrument}: the model does not explain them{little}, and readings within so \
                 wide a band are no agreement{}; {causes}, or give the error",
                error.kind.name(),
                shown(error.value, of_kind(error.kind)),
                of_values(error.value / size.max(1e-9)),
                ends(found, error.kind),
            );
            warning(CheckKind::EstimatedError, sentence).numbers([Some(error.value), Some(limit)])
        })
        });
    large.collect::<Vec<_>>().into_iter()
}

/// Deviations of the shallowest and the deepest rotating weights from the fit, in words: an error of
/// the block is the same at all depths, one of the pipe or the mud is not.
fn ends(found: &Calibration, kind: ErrorKind) -> String {
    let points = found.points.iter().filter(|point| point.reading.channel.error() == kind);
    let by_depth = |a: &&Point, b: &&Point| a.reading.bit_depth_m.total_cmp(&b.reading.bit_depth_m);
    let (shallowest, deepest) = (points.clone().min_by(by_depth), points.max_by(by_depth));
    let (ErrorKind::Rotating, Some(shallowest), Some(deepest)) = (kind, shallowest, deepest) else {
        return String::new();
    };
    let deviation = |point: &Point| {
        let off_N = point.reading.value - point.predicted;
        format!(
            "{} {} it with the bit at {}",
            shown(off_N.abs(), Dimension::Force),
            if off_N < 0.0 { "below" } else { "above" },
            Quantity::depth(point.reading.bit_depth_m),
        )
    };
    format!(" ({}, {})", deviation(shallowest), deviation(deepest))
}

/// A relative deviation of readings in words.
fn of_values(part: f64) -> String {
    let text = share(part);
    if text.ends_with('%') { format!("{text} of their values") } else { text }
}

/// Torques of a column of which nearly all are above, or nearly all below, those of the fit, in
/// which weights determine the friction: most probably the unit of the column is wrong.
fn one_sided(data: &Readings, found: &Calibration) -> impl Iterator<Item = ReadingCheck> {
    /// Smallest number of torques of a column.
    const FEWEST: usize = 5;
    /// Deviation of the median from 1 below which torques are in the right unit.
    const OFF: f64 = 0.15;
    /// Deviation from 1 in the right unit.
    const NEAR: f64 = 0.08;
    let channels = Channel::ALL.into_iter().filter(|channel| channel.is_torque());
    let checks = channels.filter_map(|channel| {
        let own = found.points.iter().zip(&data.places);
        let own: Vec<_> = own.filter(|(point, _)| point.reading.channel == channel).collect();
        let ratios = || own.iter().map(|(point, _)| point.reading.value / point.predicted);
        let ratio = median(ratios().collect());
        // Small torques may be on the other side by their noise, a fifth of them at most.
        let beyond = ratios().filter(|own| (*own > 1.0) == (ratio > 1.0)).count();
        if own.len() < FEWEST || 5 * beyond < 4 * own.len() || (ratio - 1.0).abs() < OFF {
            return None;
        }
        let places: Vec<String> = own.iter().map(|(_, place)| (*place).clone()).collect();
        // The check before the fit found the unit.
        let is_known = |check: &ReadingCheck| {
            check.check.kind == CheckKind::ReadingsUnit
                && places.iter().all(|place| check.lines.contains(place))
        };
        if data.checks.iter().any(is_known) {
            return None;
        }
        let heading = data.units[channel as usize]?;
        let unit = others(Dimension::Torque, heading)
            .into_iter()
            .map(|(unit, factor)| (unit, (ratio * factor - 1.0).abs()))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|(_, off)| *off < NEAR && *off < (ratio - 1.0).abs());
        let advice = match unit {
            Some((unit, off)) => format!(
                "in {} instead of {} they would agree within {:.0} % at the median. Is that the \
                 unit?",
                unit.symbol,
                heading.symbol,
                (100.0 * off).max(1.0)
            ),
            None => "check their unit, the torque on bit, and the string".to_owned(),
        };
        let sentence = format!(
            "the {} are {} those of the fit in {beyond} of {} rows, {ratio:.2} times as large at \
             the median: {advice}",
            plural(channel),
            if ratio > 1.0 { "above" } else { "below" },
            own.len(),
        );
        Some(
            warning(CheckKind::ReadingsUnit, sentence).numbers([Some(ratio), Some(1.0)]).on(places),
        )
    });
    checks.collect::<Vec<_>>().into_iter()
}

/// Intervals without a bound on one side.
fn open_intervals(found: &Calibration) -> impl Iterator<Item = ReadingCheck> {
    found.estimates.iter().filter(|estimate| estimate.interval.contains(&None)).map(|estimate| {
        let which = match estimate.interval {
            [None, None] => "the ends",
            [None, _] => "the lower end",
            _ => "the upper end",
        };
        let reach = match (estimate.profile.first(), estimate.profile.last()) {
            (Some(first), Some(last)) if estimate.parameter.is_factor() => format!(
                ": the strings were solved with factors from {:.3} to {:.3}, and the readings rule out none of them \
                 on that side",
                first.value, last.value
            ),
            _ => String::new(),
        };
        let sentence = format!(
            "{which} of the interval of the {} was not found{reach}: the readings hardly \
             determine it",
            estimate.parameter.words()
        );
        warning(CheckKind::OpenInterval, sentence)
    })
}

/// Given errors that are too small.
fn scatter(found: &Calibration) -> Option<ReadingCheck> {
    let all_given = found.errors.iter().all(|error| error.given);
    let freedom = found.degrees_of_freedom as f64;
    if !all_given || freedom <= 0.0 {
        return None;
    }
    let spread = 2.0 / (9.0 * freedom);
    let z = (libm::cbrt(found.chi2 / freedom) - (1.0 - spread)) / spread.sqrt();
    let times = (found.chi2 / freedom).sqrt();
    (z > TOO_FAR).then(|| {
        let sentence = format!(
            "the readings scatter {times:.1} times as much as their errors allow: the model does \
             not describe this well, or the errors are too small, and so are those of the results"
        );
        warning(CheckKind::Scatter, sentence).numbers([Some(times), Some(1.0)])
    })
}

/// Readings that deviate by more than their errors allow, by the fit or by the robust fit.
fn outliers(data: &Readings, found: &Calibration, robust: Option<&Outliers>) -> Vec<ReadingCheck> {
    let is_robust =
        |row: usize| robust.is_some_and(|robust| robust.outlier.get(row) == Some(&true));
    let rows = found.points.iter().zip(&data.places).enumerate();
    let fitted = rows.filter(|(row, (point, _))| point.outlier || is_robust(*row));
    fitted.map(|(_, (fitted, place))| outlier(fitted, place)).collect()
}

/// A reading that is an outlier of the fit, or of the robust fit only: the standard errors of the fit
/// are those of all readings, wrong ones included, so that they may hide it.
fn outlier(point: &Point, place: &str) -> ReadingCheck {
    let channel = point.reading.channel;
    let quantity = |value: f64| shown(value, dimension(channel));
    let sentence = format!(
        "outlier: {} of {} with the bit at {} ({place}), where {} is expected, {:.1} standard \
         errors off{}",
        channel.name().replace('_', "-"),
        quantity(point.reading.value),
        Quantity::depth(point.reading.bit_depth_m),
        quantity(point.predicted),
        point.standardised,
        match point.outlier {
            true => String::new(),
            false => format!("; an outlier by the smaller scale of the fit with {LOSS}'s loss"),
        }
    );
    ReadingCheck::new(CheckKind::Outlier, Severity::Warning, sentence)
        .numbers([Some(point.reading.value), Some(point.predicted)])
        .on(vec![place.to_owned()])
}

/// More readings outside the band than its confidence implies.
fn band(found: &Calibration, settings: &Settings) -> Option<ReadingCheck> {
    let beyond = found.points.iter().filter(|point| !point.within_band).count();
    let part = beyond as f64 / found.points.len() as f64;
    let allowed = 1.0 - settings.band_confidence;
    (part > 2.0 * allowed && beyond > 3).then(|| {
        let sentence = format!(
            "{beyond} of {} readings are outside the band of {:.0} %",
            found.points.len(),
            100.0 * settings.band_confidence
        );
        warning(CheckKind::Band, sentence).numbers([Some(part), Some(allowed)])
    })
}
