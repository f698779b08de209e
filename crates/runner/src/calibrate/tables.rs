//! The tables of a calibration.

use wholestring_plan::calibration::{
    Calibration, Channel, ErrorKind, Estimate, Parameter, Point, Settings, State,
};
use wholestring_results::{
    CalibrationBand, CalibrationProfile, CalibrationReading, CalibrationSummary, CalibrationTables,
    DynamicCheck, ErrorFound, EstimateFound, ResultsError, ResultsFolder, Row as _, Table,
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
    let tables = CalibrationTables {
        points: points(data, found, case),
        bands: bands(found, case),
        profiles: profiles(found),
    };
    // Their CSV files also contain the numbers of the pictures.
    let beyond = [("outlier_beyond".to_owned(), summary.outlier_beyond)];
    for (name, table, picture) in [
        (POINTS, &tables.points, with_lines(&tables.points, &beyond)),
        (BANDS, &tables.bands, with_rows(&tables.bands, &read(data, found, case))),
        (PROFILES, &tables.profiles, with_rows(&tables.profiles, &ends(found))),
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

/// A number as a weight or as a torque.
fn by_kind(channel: Channel, value: f64) -> [Option<f64>; 2] {
    if channel.is_torque() { [None, Some(value)] } else { [Some(value), None] }
}

fn points<'a>(data: &Readings, found: &Calibration, case: impl Fn(usize) -> &'a str) -> Table {
    let fitted = found.points.iter().zip(&data.places).map(|point| (point, true));
    let held_out = found.held_out.iter().zip(&data.held_out_places).map(|point| (point, false));
    let rows = fitted.chain(held_out).map(|((point, place), used)| {
        let channel = point.reading.channel;
        let [measured_N, measured_N_m] = by_kind(channel, point.reading.value);
        let [predicted_N, predicted_N_m] = by_kind(channel, point.predicted);
        let [residual_N, residual_N_m] = by_kind(channel, point.reading.value - point.predicted);
        let [error_N, error_N_m] = by_kind(channel, point.predicted_error);
        let [low, high] = [-1.0, 1.0]
            .map(|sign| by_kind(channel, point.predicted + sign * point.reading_half_width));
        CalibrationReading {
            case: case(point.reading.setup).to_owned(),
            place: place.clone(),
            reading: channel.name().to_owned(),
            used,
            bit_depth_m: point.reading.bit_depth_m,
            measured_N,
            predicted_N,
            residual_N,
            predicted_error_N: error_N,
            reading_low_N: low[0],
            reading_high_N: high[0],
            measured_N_m,
            predicted_N_m,
            residual_N_m,
            predicted_error_N_m: error_N_m,
            reading_low_N_m: low[1],
            reading_high_N_m: high[1],
            standardised: point.standardised,
            outlier: point.outlier,
            within_band: point.within_band,
        }
    });
    CalibrationReading::table(rows)
}

fn bands<'a>(found: &Calibration, case: impl Fn(usize) -> &'a str) -> Table {
    let rows = found.bands.iter().map(|band| {
        let load = |value: f64| by_kind(band.channel, value);
        let ends =
            |half_width: f64| [-1.0, 1.0].map(|sign| load(band.predicted + sign * half_width));
        let [predicted_N, predicted_N_m] = load(band.predicted);
        let [mean_low, mean_high] = ends(band.mean_half_width);
        let [reading_low, reading_high] = ends(band.reading_half_width);
        CalibrationBand {
            case: case(band.setup).to_owned(),
            reading: band.channel.name().to_owned(),
            bit_depth_m: band.bit_depth_m,
            predicted_N,
            mean_low_N: mean_low[0],
            mean_high_N: mean_high[0],
            reading_low_N: reading_low[0],
            reading_high_N: reading_high[0],
            predicted_N_m,
            mean_low_N_m: mean_low[1],
            mean_high_N_m: mean_high[1],
            reading_low_N_m: reading_low[1],
            reading_high_N_m: reading_high[1],
        }
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
