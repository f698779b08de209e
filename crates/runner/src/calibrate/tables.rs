//! The tables of a calibration.

use wholestring_plan::calibration::{
    Calibration, ErrorKind, Estimate, Parameter, Point, Settings, State,
};
use wholestring_results::{
    CalibrationBand, CalibrationProfile, CalibrationReading, CalibrationSummary, DynamicCheck,
    ErrorFound, EstimateFound, ResultsError, ResultsFolder, Row as _, Table,
};

use crate::{
    picture_table::{Entry, Row, with_lines, with_rows},
    readings::Readings,
};

/// Names of the tables, without their extensions.
pub(super) const POINTS: &str = "calibration";
pub(super) const BANDS: &str = "calibration_bands";
pub(super) const PROFILES: &str = "calibration_profiles";
const DYNAMIC: &str = "calibration_dynamic";

/// Writes the summary and all tables, also as CSV, because the page links to them.
pub(super) fn write(
    folder: &ResultsFolder,
    data: &Readings,
    summary: &CalibrationSummary,
    found: &Calibration,
) -> Result<(), ResultsError> {
    let case = |setup: usize| summary.cases[data.cases[setup]].as_str();
    let [points, bands, profiles] =
        [points(data, found, case), bands(found, case), profiles(found)];
    // Their CSV files also contain the numbers of the pictures.
    let beyond = [("outlier_beyond".to_owned(), summary.outlier_beyond)];
    for (name, table, picture) in [
        (POINTS, &points, with_lines(&points, &beyond)),
        (BANDS, &bands, with_rows(&bands, &read(data, found, case))),
        (PROFILES, &profiles, with_rows(&profiles, &ends(found))),
    ] {
        folder.write_table(name, table, false)?;
        picture.write_csv(&folder.path().join(format!("{name}.csv")))?;
    }
    if summary.dynamics.is_empty() {
        for ending in ["parquet", "csv"] {
            folder.remove(&format!("{DYNAMIC}.{ending}"))?;
        }
    } else {
        folder.write_table(DYNAMIC, &DynamicCheck::table(&summary.dynamics), true)?;
    }
    summary.write(&folder.path().join("summary.json"))
}

fn points<'a>(data: &Readings, found: &Calibration, case: impl Fn(usize) -> &'a str) -> Table {
    let fitted = found.points.iter().zip(&data.places).map(|point| (point, true));
    let held_out = found.held_out.iter().zip(&data.held_out_places).map(|point| (point, false));
    let rows = fitted.chain(held_out).map(|((point, place), used)| {
        let half_width = point.reading_half_width;
        CalibrationReading {
            case: case(point.reading.setup).to_owned(),
            place: place.clone(),
            reading: point.reading.channel.name().to_owned(),
            used,
            bit_depth_m: point.reading.bit_depth_m,
            measured: point.reading.value,
            predicted: point.predicted,
            residual: point.reading.value - point.predicted,
            predicted_error: point.predicted_error,
            reading_low: point.predicted - half_width,
            reading_high: point.predicted + half_width,
            standardised: point.standardised,
            outlier: point.outlier,
            within_band: point.within_band,
        }
    });
    CalibrationReading::table(rows)
}

fn bands<'a>(found: &Calibration, case: impl Fn(usize) -> &'a str) -> Table {
    let rows = found.bands.iter().map(|band| CalibrationBand {
        case: case(band.setup).to_owned(),
        reading: band.channel.name().to_owned(),
        bit_depth_m: band.bit_depth_m,
        predicted: band.predicted,
        mean_low: band.predicted - band.mean_half_width,
        mean_high: band.predicted + band.mean_half_width,
        reading_low: band.predicted - band.reading_half_width,
        reading_high: band.predicted + band.reading_half_width,
    });
    CalibrationBand::table(rows)
}

fn profiles(found: &Calibration) -> Table {
    let rows = found.estimates.iter().flat_map(|estimate| {
        estimate.profile.iter().map(|point| CalibrationProfile {
            parameter: estimate.parameter.name().to_owned(),
            value: point.value,
            excess: point.excess,
            parabola: point.parabola,
        })
    });
    CalibrationProfile::table(rows)
}

/// Readings, in rows below the bands.
fn read<'a>(
    data: &Readings,
    found: &Calibration,
    case: impl Fn(usize) -> &'a str,
) -> Vec<Row<'static>> {
    let fitted = found.points.iter().zip(&data.places).map(|point| (point, 1.0));
    let held_out = found.held_out.iter().zip(&data.held_out_places).map(|point| (point, 0.0));
    let row = |((point, place), used): ((&Point, &String), f64)| {
        let reading = &point.reading;
        let unit = if reading.channel.is_torque() { "measured_N_m" } else { "measured_N" };
        vec![
            ("case", Entry::Word(case(reading.setup).to_owned())),
            ("reading", Entry::Word(reading.channel.name().to_owned())),
            ("bit_depth_m", Entry::Number(reading.bit_depth_m)),
            (unit, Entry::Number(reading.value)),
            ("used", Entry::Number(used)),
            ("place", Entry::Word(place.clone())),
        ]
    };
    fitted.chain(held_out).map(row).collect()
}

/// Ends of the intervals, in rows below the profiles.
fn ends(found: &Calibration) -> Vec<Row<'static>> {
    let ends_of = |estimate: &Estimate| {
        let ends = estimate.interval.into_iter().zip(["lower", "upper"]);
        let row = |(end, which): (Option<f64>, &str)| {
            Some(vec![
                ("parameter", Entry::Word(estimate.parameter.name().to_owned())),
                ("value", Entry::Number(end?)),
                ("interval_end", Entry::Word(which.to_owned())),
            ])
        };
        ends.filter_map(row).collect::<Vec<_>>()
    };
    found.estimates.iter().flat_map(ends_of).collect()
}

/// Fitted parameters with their values.
pub(super) fn estimates(found: &Calibration) -> Vec<EstimateFound> {
    let estimate = |estimate: &wholestring_plan::calibration::Estimate| EstimateFound {
        parameter: estimate.parameter.name().to_owned(),
        words: estimate.parameter.words().to_owned(),
        value: estimate.value,
        standard_error: estimate.standard_error,
        interval: estimate.interval,
        at_bound: estimate.at_bound,
    };
    found.estimates.iter().map(estimate).collect()
}

/// Errors of the readings.
pub(super) fn errors(found: &Calibration) -> Vec<ErrorFound> {
    let error = |error: &wholestring_plan::calibration::ReadingError| ErrorFound {
        readings: error.kind.name().to_owned(),
        is_torque: error.kind == ErrorKind::Torque,
        standard_error: error.value,
        given: error.given,
        count: error.readings,
        chi2: error.chi2,
    };
    found.errors.iter().map(error).collect()
}

/// Parameters that are kept fixed.
pub(super) fn held(settings: &Settings) -> Vec<(String, f64)> {
    let State { factors, block_weight_N, bit_torque_N_m } = settings.held;
    let looked_for = |parameter: Parameter| settings.parameters.contains(&parameter);
    let by_section = factors.sections.iter().any(Option::is_some);
    let everywhere = looked_for(Parameter::Friction) || by_section;
    let around = by_section || looked_for(Parameter::FrictionAround) || settings.around_follows();
    let sections = factors.sections.iter().enumerate().filter_map(|(section, own)| {
        let [along, around] = (*own)?;
        let follows = settings.around_follows();
        Some([
            (Parameter::Section(section), along, false),
            (
                Parameter::SectionAround(section),
                around,
                follows && looked_for(Parameter::Section(section)),
            ),
        ])
    });
    let sections: Vec<_> = sections.flatten().collect();
    [
        (Parameter::Cased, factors.cased, everywhere),
        (Parameter::Open, factors.open, everywhere),
        (Parameter::CasedAround, factors.cased_around, around),
        (Parameter::OpenAround, factors.open_around, around),
        (Parameter::BlockWeight, block_weight_N, false),
        (Parameter::BitTorque, bit_torque_N_m, false),
    ]
    .into_iter()
    .chain(sections)
    .filter(|(parameter, _, otherwise)| !looked_for(*parameter) && !otherwise)
    .map(|(parameter, value, _)| (parameter.name().to_owned(), value))
    .collect()
}
