//! Checks of a fit.

use wholestring_judge::{CheckKind, ReadingCheck, Severity};
use wholestring_plan::calibration::{
    Calibration, ErrorKind, LOSS, Outliers, Parameter, Point, Settings,
};
use wholestring_units::{Dimension, UnitSet};

use super::{
    super::notes::{dimension as of_kind, size},
    text::{dimension, median, shown, warning, whole},
};
use crate::readings::Readings;

/// Given errors are too small where the sum of squares lies so many standard deviations beyond what
/// it should be, its cube root being nearly normal (Wilson and Hilferty 1931).
const TOO_FAR: f64 = 3.0;

/// Estimated errors beyond this part of what was read are no errors of an instrument, by [`ErrorKind`].
const PLAUSIBLE: [f64; 3] = [0.1, 0.1, 0.35];

/// A block of less than this part of the weights is none.
const NO_BLOCK: f64 = 0.01;

/// Checks of a fit, with the readings that a robust fit does not follow.
pub(in super::super) fn of_fit(
    data: &Readings,
    found: &Calibration,
    settings: &Settings,
    robust: Option<&Outliers>,
    units: UnitSet,
) -> Vec<ReadingCheck> {
    let mut checks: Vec<ReadingCheck> = bounds(found).collect();
    checks.extend(no_block(found, settings, units));
    checks.extend(estimated_errors(found, units));
    checks.extend(found.confused.iter().map(|of| {
        let sentence = format!(
            "the readings do not tell the {} from the {}: their correlation is {:.3}; hold one of them, or \
             read at other depths",
            of.first.words(),
            of.second.words(),
            of.correlation
        );
        let numbers = [of.correlation, settings.correlated_beyond].map(Some);
        warning(CheckKind::NotToldApart, sentence).numbers(numbers)
    }));
    checks.extend(open_intervals(found));
    checks.extend(scatter(found));
    checks.extend(outliers(data, found, robust, units));
    if let Some(count) = robust.and_then(|of| of.too_many) {
        let all = found.points.len();
        let sentence = format!(
            "{count} of {all} readings are off in a robust fit ({LOSS}'s loss): that is no matter of single \
             outliers; look at units, block, mud, string and survey"
        );
        let numbers = [count as f64, 0.25 * all as f64].map(Some);
        checks.push(warning(CheckKind::TooManyOutliers, sentence).numbers(numbers));
    }
    checks.extend(band(found, settings));
    checks
}

/// Numbers that would be negative.
fn bounds(found: &Calibration) -> impl Iterator<Item = ReadingCheck> {
    found.estimates.iter().filter(|of| of.at_bound).map(|of| {
        let why = match of.parameter {
            Parameter::BlockWeight => {
                "the weights are less than the string alone weighs in the mud: mud, string, survey or the unit of \
                 the weights is another"
            }
            Parameter::BitTorque => "torques on bottom are less than those off it would make them",
            _ => {
                "the readings are below what the string weighs or turns with, or another number is off"
            }
        };
        let words = of.parameter.words();
        let sentence = format!("the {words} would be negative and is held at zero: {why}");
        warning(CheckKind::ReadingsNegative, sentence).numbers([Some(of.value), Some(0.0)])
    })
}

/// A block that was looked for, and is none.
fn no_block(found: &Calibration, settings: &Settings, units: UnitSet) -> Option<ReadingCheck> {
    let is = |of: &&wholestring_plan::calibration::Estimate| {
        of.parameter == Parameter::BlockWeight && !of.at_bound
    };
    let block = found.estimates.iter().find(is)?;
    let weights = found.points.iter().filter(|of| !of.reading.channel.is_torque());
    let size_N = median(weights.map(|of| of.reading.value.abs()).collect());
    (block.value < NO_BLOCK * size_N).then(|| {
        let sentence = format!(
            "the block weight comes to {}: the weights seem not to hold the block; results are compared with hook \
             loads without it (confidence {:.0} %)",
            shown(block.value, Dimension::Force, units),
            100.0 * settings.confidence
        );
        ReadingCheck::new(CheckKind::NoBlock, Severity::Note, sentence)
            .numbers([Some(block.value), Some(NO_BLOCK * size_N)])
    })
}

/// Errors that were estimated and are far beyond those of an instrument: then nothing is out of the band, and the
/// readings of that kind tell nothing.
fn estimated_errors(found: &Calibration, units: UnitSet) -> impl Iterator<Item = ReadingCheck> {
    let large = found.errors.iter().filter_map(move |of| {
        let size = size(found, of.kind);
        let limit = PLAUSIBLE[of.kind.place()] * size;
        (!of.given && of.value > limit).then(|| {
            let instrument = match of.kind {
                ErrorKind::Torque => "a torque is read to 2 to 10 %",
                _ => "a weight indicator errs by 1 to 3 %",
            };
            let sentence = format!(
                "the {} miss the fit by {} (their standard error, estimated), {:.0} % of what they are, \
                 where {instrument}: the model does not describe them, they tell next to nothing here, and \
                 readings within a band so wide are no agreement; look at the columns, units, block, \
                 mud, pumps, string and survey, or give the error",
                of.kind.name(),
                shown(of.value, of_kind(of.kind), units),
                100.0 * of.value / size.max(1e-9),
            );
            warning(CheckKind::EstimatedError, sentence).numbers([Some(of.value), Some(limit)])
        })
    });
    large.collect::<Vec<_>>().into_iter()
}

/// Intervals without an end.
fn open_intervals(found: &Calibration) -> impl Iterator<Item = ReadingCheck> {
    found.estimates.iter().filter(|of| of.interval.contains(&None)).map(|of| {
        let which = match of.interval {
            [None, None] => "the ends",
            [None, _] => "the lower end",
            _ => "the upper end",
        };
        let reach = match (of.profile.first(), of.profile.last()) {
            (Some(first), Some(last)) if of.parameter.is_factor() => format!(
                ": the strings were solved with factors from {:.3} to {:.3}, and the readings rule out none of them \
                 on that side",
                first.value, last.value
            ),
            _ => String::new(),
        };
        let sentence = format!(
            "{which} of the interval of the {} was not found{reach}: the readings hardly tell it",
            of.parameter.words()
        );
        warning(CheckKind::OpenInterval, sentence)
    })
}

/// Given errors that are too small.
fn scatter(found: &Calibration) -> Option<ReadingCheck> {
    let given = found.errors.iter().all(|of| of.given);
    let freedom = found.degrees_of_freedom as f64;
    if !given || freedom <= 0.0 {
        return None;
    }
    let spread = 2.0 / (9.0 * freedom);
    let z = (libm::cbrt(found.chi2 / freedom) - (1.0 - spread)) / spread.sqrt();
    let times = (found.chi2 / freedom).sqrt();
    (z > TOO_FAR).then(|| {
        let sentence = format!(
            "the readings scatter {times:.1} times as much as their errors say: the model does not describe \
             this well, or the errors are too small; so are those of what was found"
        );
        warning(CheckKind::Scatter, sentence).numbers([Some(times), Some(1.0)])
    })
}

/// Readings beyond what their errors allow, by the fit or by the robust one.
fn outliers(
    data: &Readings,
    found: &Calibration,
    robust: Option<&Outliers>,
    units: UnitSet,
) -> Vec<ReadingCheck> {
    let is_robust = |row: usize| robust.is_some_and(|of| of.outlier.get(row) == Some(&true));
    let rows = found.points.iter().zip(&data.places).enumerate();
    let fitted = rows.filter(|(row, (of, _))| of.outlier || is_robust(*row));
    let fitted = fitted.map(|(_, (of, place))| outlier(of, place, "standard errors", units));
    fitted.collect()
}

fn outlier(point: &Point, place: &str, errors: &str, units: UnitSet) -> ReadingCheck {
    let channel = point.reading.channel;
    let quantity = |value: f64| shown(value, dimension(channel), units);
    let sentence = format!(
        "outlier: {} of {} with the bit at {} ({place}), where {} is expected, {:.1} {errors} off",
        channel.name().replace('_', "-"),
        quantity(point.reading.value),
        whole(point.reading.bit_depth_m, units),
        quantity(point.predicted),
        point.standardised
    );
    ReadingCheck::new(CheckKind::Outlier, Severity::Warning, sentence)
        .numbers([Some(point.reading.value), Some(point.predicted)])
        .on(vec![place.to_owned()])
}

/// More readings out of the band than it leaves out.
fn band(found: &Calibration, settings: &Settings) -> Option<ReadingCheck> {
    let beyond = found.points.iter().filter(|of| !of.within_band).count();
    let part = beyond as f64 / found.points.len() as f64;
    let allowed = 1.0 - settings.band_confidence;
    (part > 2.0 * allowed && beyond > 3).then(|| {
        let sentence = format!(
            "{beyond} of {} readings lie outside the band of {:.0} %",
            found.points.len(),
            100.0 * settings.band_confidence
        );
        warning(CheckKind::Band, sentence).numbers([Some(part), Some(allowed)])
    })
}
