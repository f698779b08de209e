//! Checks of a fit.

use wholestring_plan::calibration::{
    Calibration, ErrorKind, LOSS, Outliers, Parameter, Point, Settings,
};
use wholestring_tabular::{CheckSeverity, ReadingCheck};
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
    checks.extend(found.confused.iter().map(|of| ReadingCheck {
        value: Some(of.correlation),
        limit: Some(settings.correlated_beyond),
        ..warning(
            "not_told_apart",
            format!(
                "the readings do not tell the {} from the {}: their correlation is {:.3}; hold one of them, or \
                 read at other depths",
                of.first.words(),
                of.second.words(),
                of.correlation
            ),
        )
    }));
    checks.extend(open_intervals(found));
    checks.extend(scatter(found));
    checks.extend(outliers(data, found, robust, units));
    if let Some(count) = robust.and_then(|of| of.too_many) {
        checks.push(ReadingCheck {
            value: Some(count as f64),
            limit: Some(0.25 * found.points.len() as f64),
            ..warning(
                "too_many_outliers",
                format!(
                    "{count} of {} readings are off in a robust fit ({LOSS}'s loss): that is no matter of single \
                     outliers; look at units, block, mud, string and survey",
                    found.points.len()
                ),
            )
        });
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
        ReadingCheck {
            value: Some(of.value),
            limit: Some(0.0),
            ..warning(
                "negative",
                format!("the {} would be negative and is held at zero: {why}", of.parameter.words()),
            )
        }
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
    (block.value < NO_BLOCK * size_N).then(|| ReadingCheck {
        kind: "no_block",
        severity: CheckSeverity::Note,
        places: Vec::new(),
        value: Some(block.value),
        limit: Some(NO_BLOCK * size_N),
        sentence: format!(
            "the block weight comes to {}: the weights seem not to hold the block; results are compared with hook \
             loads without it (confidence {:.0} %)",
            shown(block.value, Dimension::Force, units),
            100.0 * settings.confidence
        ),
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
            ReadingCheck {
                value: Some(of.value),
                limit: Some(limit),
                ..warning(
                    "estimated_error",
                    format!(
                        "the {} miss the fit by {} (their standard error, estimated), {:.0} % of what they are, \
                         where {instrument}: the model does not describe them, they tell next to nothing here, and \
                         readings within a band so wide are no agreement; look at the columns, units, block, \
                         mud, pumps, string and survey, or give the error",
                        of.kind.name(),
                        shown(of.value, of_kind(of.kind), units),
                        100.0 * of.value / size.max(1e-9),
                    ),
                )
            }
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
        warning(
            "open_interval",
            format!(
                "{which} of the interval of the {} was not found{reach}: the readings hardly tell it",
                of.parameter.words()
            ),
        )
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
    (z > TOO_FAR).then(|| ReadingCheck {
        value: Some(times),
        limit: Some(1.0),
        ..warning(
            "scatter",
            format!(
                "the readings scatter {times:.1} times as much as their errors say: the model does not describe \
                 this well, or the errors are too small; so are those of what was found"
            ),
        )
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
    ReadingCheck {
        kind: "outlier",
        severity: CheckSeverity::Warning,
        places: vec![place.to_owned()],
        value: Some(point.reading.value),
        limit: Some(point.predicted),
        sentence: format!(
            "outlier: {} of {} with the bit at {} ({place}), where {} is expected, {:.1} {errors} off",
            channel.name().replace('_', "-"),
            quantity(point.reading.value),
            whole(point.reading.bit_depth_m, units),
            quantity(point.predicted),
            point.standardised
        ),
    }
}

/// More readings out of the band than it leaves out.
fn band(found: &Calibration, settings: &Settings) -> Option<ReadingCheck> {
    let beyond = found.points.iter().filter(|of| !of.within_band).count();
    let part = beyond as f64 / found.points.len() as f64;
    let allowed = 1.0 - settings.band_confidence;
    (part > 2.0 * allowed && beyond > 3).then(|| ReadingCheck {
        value: Some(part),
        limit: Some(allowed),
        ..warning(
            "band",
            format!(
                "{beyond} of {} readings lie outside the band of {:.0} %",
                found.points.len(),
                100.0 * settings.band_confidence
            ),
        )
    })
}
