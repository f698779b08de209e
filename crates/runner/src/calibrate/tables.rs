//! The tables of a calibration.

use wholestring_plan::calibration::{
    Calibration, Channel, ErrorKind, Estimate, Parameter, Point, Settings, State,
};
use wholestring_results::{
    CALIBRATION, CALIBRATION_BANDS, CalibrationProfile, CalibrationSummary, CalibrationTables,
    ErrorFound, EstimateFound, ResultsError, ResultsFolder, Row as _, Table,
    calibration_dynamic_table,
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
        folder.write_table(DYNAMIC, &calibration_dynamic_table(&summary.dynamics), true)?;
    }
    summary.write(&folder.path().join("summary.json"))
}

/// A number as a weight or as a torque.
fn by_kind(channel: Channel, value: f64) -> [f64; 2] {
    if channel.is_torque() { [f64::NAN, value] } else { [value, f64::NAN] }
}

fn points<'a>(data: &Readings, found: &Calibration, case: impl Fn(usize) -> &'a str) -> Table {
    let mut table = Table::with_columns(CALIBRATION);
    let fitted = found.points.iter().zip(&data.places).map(|point| (point, 1.0));
    let held_out = found.held_out.iter().zip(&data.held_out_places).map(|point| (point, 0.0));
    for ((point, place), used) in fitted.chain(held_out) {
        let channel = point.reading.channel;
        let [measured_N, measured_N_m] = by_kind(channel, point.reading.value);
        let [predicted_N, predicted_N_m] = by_kind(channel, point.predicted);
        let [residual_N, residual_N_m] = by_kind(channel, point.reading.value - point.predicted);
        let [error_N, error_N_m] = by_kind(channel, point.predicted_error);
        let [low, high] = [-1.0, 1.0]
            .map(|sign| by_kind(channel, point.predicted + sign * point.reading_half_width));
        table.append(
            &[
                ("case", &[case(point.reading.setup)]),
                ("place", &[place]),
                ("reading", &[channel.name()]),
            ],
            &[
                ("used", &[used]),
                ("bit_depth_m", &[point.reading.bit_depth_m]),
                ("measured_N", &[measured_N]),
                ("predicted_N", &[predicted_N]),
                ("measured_N_m", &[measured_N_m]),
                ("predicted_N_m", &[predicted_N_m]),
                ("residual_N", &[residual_N]),
                ("predicted_error_N", &[error_N]),
                ("reading_low_N", &[low[0]]),
                ("reading_high_N", &[high[0]]),
                ("residual_N_m", &[residual_N_m]),
                ("predicted_error_N_m", &[error_N_m]),
                ("reading_low_N_m", &[low[1]]),
                ("reading_high_N_m", &[high[1]]),
                ("standardised", &[point.standardised]),
                ("outlier", &[f64::from(u8::from(point.outlier))]),
                ("within_band", &[f64::from(u8::from(point.within_band))]),
            ],
        );
    }
    table
}

fn bands<'a>(found: &Calibration, case: impl Fn(usize) -> &'a str) -> Table {
    let mut table = Table::with_columns(CALIBRATION_BANDS);
    for band in &found.bands {
        let kinds = [band.predicted, band.mean_half_width, band.reading_half_width]
            .map(|value| by_kind(band.channel, value));
        let [predicted, mean, reading] = kinds;
        let end = |half: [f64; 2], sign: f64| [0, 1].map(|k| predicted[k] + sign * half[k]);
        let (mean_low, mean_high) = (end(mean, -1.0), end(mean, 1.0));
        let (low, high) = (end(reading, -1.0), end(reading, 1.0));
        table.append(
            &[("case", &[case(band.setup)]), ("reading", &[band.channel.name()])],
            &[
                ("bit_depth_m", &[band.bit_depth_m]),
                ("predicted_N", &[predicted[0]]),
                ("mean_low_N", &[mean_low[0]]),
                ("mean_high_N", &[mean_high[0]]),
                ("reading_low_N", &[low[0]]),
                ("reading_high_N", &[high[0]]),
                ("predicted_N_m", &[predicted[1]]),
                ("mean_low_N_m", &[mean_low[1]]),
                ("mean_high_N_m", &[mean_high[1]]),
                ("reading_low_N_m", &[low[1]]),
                ("reading_high_N_m", &[high[1]]),
            ],
        );
    }
    table
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
