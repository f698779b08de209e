//! Outliers among the readings: the fits with and without them.

use wholestring_judge::{CheckKind, ReadingCheck};
use wholestring_plan::calibration::{
    Calibration, CalibrationError, LOSS, Outliers, Settings, outliers,
};
use wholestring_results::OutlierComparison;

use super::{
    checks,
    search::{Predictions, Search},
    tables,
};
use crate::{error::Error, readings::Readings};

/// Readings that a robust fit by the soft string does not follow; `None` if there is no such fit.
pub(super) fn robust(
    search: &Search<'_>,
    data: &Readings,
    settings: &Settings,
) -> Result<Option<Outliers>, Error> {
    let model = Predictions {
        assemblies: &data.assemblies,
        stiff: None,
        cancellation: search.cancellation,
        observer: &crate::observer::Silent,
    };
    let settings = Settings { outlier_beyond: search.fit.outlier_beyond, ..settings.clone() };
    match outliers(&model, &data.readings, &settings) {
        Ok(found) => Ok(Some(found)),
        Err(CalibrationError::Interrupted) => Err(Error::Interrupted),
        // The fit itself reports the reason.
        Err(_) => Ok(None),
    }
}

/// The fit of the result with its readings, and the estimates of the other fit.
pub(super) struct Fits {
    pub(super) data: Readings,
    pub(super) found: Calibration,
    pub(super) comparison: Option<OutlierComparison>,
}

/// Fits all readings, and those without the outliers. An outlier is beyond the bound in the fit of
/// all readings or in the robust fit, to which those of the former are added.
pub(super) fn fits(
    search: &Search<'_>,
    data: Readings,
    settings: &Settings,
    robust: Option<&mut Outliers>,
) -> Result<Fits, Error> {
    let left_out = search.fit.without_outliers;
    let all = match search.calibration(&data, settings, !left_out) {
        Err(error) if !left_out || matches!(error, Error::Interrupted) => return Err(error),
        found => found.ok(),
    };
    let parted = robust.and_then(|robust| {
        if let (Some(all), None) = (&all, robust.too_many) {
            let marks = robust.outlier.iter_mut().zip(&all.points);
            marks.for_each(|(mark, point)| *mark |= point.outlier);
        }
        Parted::of(&data, robust)
    });
    let compared = |outliers: Vec<String>, found: &Calibration| OutlierComparison {
        loss: LOSS.to_owned(),
        outliers,
        left_out,
        estimates: tables::estimates(found),
    };
    match (parted, all) {
        (Some(parted), Some(all)) if !left_out => {
            // If too few readings are left, there is no fit for comparison.
            let comparison = match search.calibration(&parted.without, settings, false) {
                Err(Error::Interrupted) => return Err(Error::Interrupted),
                found => found.ok().map(|found| compared(parted.outliers, &found)),
            };
            Ok(Fits { data, found: all, comparison })
        }
        (None, Some(found)) if !left_out => Ok(Fits { data, found, comparison: None }),
        (parted, all) => {
            let (data, outliers) = match parted {
                Some(parted) => (parted.without, Some(parted.outliers)),
                None => (data, None),
            };
            let found = search.calibration(&data, settings, true)?;
            let comparison = outliers.zip(all).map(|(outliers, all)| compared(outliers, &all));
            Ok(Fits { data, found, comparison })
        }
    }
}

/// Readings without their outliers, which are held out.
struct Parted {
    without: Readings,
    outliers: Vec<String>,
}

impl Parted {
    /// `None` if there are no outliers.
    fn of(data: &Readings, robust: &Outliers) -> Option<Self> {
        if !robust.outlier.contains(&true) {
            return None;
        }
        let mut without = Readings { readings: Vec::new(), places: Vec::new(), ..data.clone() };
        let mut outliers = Vec::new();
        let rows = data.readings.iter().zip(&data.places);
        for ((reading, place), is) in rows.zip(&robust.outlier) {
            let (readings, places) = match is {
                false => (&mut without.readings, &mut without.places),
                true => (&mut without.held_out, &mut without.held_out_places),
            };
            readings.push(*reading);
            places.push(place.clone());
            if *is {
                let name = reading.channel.name().replace('_', "-");
                outliers.push(format!("{name} of {place}"));
            }
        }
        Some(Self { without, outliers })
    }
}

/// Check that the fit with the outliers differs from that without them.
pub(super) fn check(comparison: Option<&OutlierComparison>) -> Option<ReadingCheck> {
    let comparison = comparison?;
    let count = comparison.outliers.len();
    let (noun, verb) = if count == 1 { ("outlier", "is") } else { ("outliers", "are") };
    let sentence = match comparison.left_out {
        true => format!(
            "{count} {noun} ({}) {verb} left out of the fit; all readings are shown for comparison",
            comparison.outliers.join(", ")
        ),
        false => format!(
            "{count} {noun} ({}) {verb} in the fit; the results without {} are shown for \
             comparison, and `--without-outliers` leaves {} out",
            comparison.outliers.join(", "),
            if count == 1 { "it" } else { "them" },
            if count == 1 { "it" } else { "them" },
        ),
    };
    Some(
        checks::warning(CheckKind::Outliers, sentence)
            .numbers([Some(count as f64), None])
            .on(comparison.outliers.clone()),
    )
}
