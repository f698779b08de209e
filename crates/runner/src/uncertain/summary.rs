//! Statistics of the samples: scatter of each quantity and its sensitivity to the inputs, in tables
//! and in sentences.

use std::cmp::Reverse;

use wholestring::outcome::ModelKind;
use wholestring_plan::uncertainty::{Bands, Distribution, attribute};
use wholestring_results::{
    ResultsError, ResultsFolder, Row as _, Table, UncertainBand, UncertainKey, UncertainOwed,
    UncertainSample, UncertainStop, UncertainSummary, UncertainTables,
};
use wholestring_units::{Dimension, UnitSet};

use super::{Quantity, Sampled, Sampler};

/// Statistics of the solved samples.
pub(crate) fn summary(
    sampler: &Sampler<'_>,
    model: ModelKind,
    quantities: &[Quantity],
    frictions: &[Option<f64>],
    sampled: &[Option<Sampled>],
) -> UncertainSummary {
    let uncertain = sampler.uncertain;
    let solved: Vec<(&Vec<f64>, &Sampled)> = sampler
        .points
        .iter()
        .zip(sampled)
        .filter_map(|(point, sampled)| Some((point, sampled.as_ref()?)))
        .collect();
    let points: Vec<Vec<f64>> = solved.iter().map(|(point, _)| (*point).clone()).collect();
    let distributions = uncertain.distributions();
    let band = |(place, quantity): (usize, &Quantity)| {
        let answers =
            solved.iter().map(|(_, sampled)| sampled.answers.get(place).copied().flatten());
        let answers: Vec<f64> = answers.map(|answer| answer.unwrap_or(f64::NAN)).collect();
        band(quantity, &answers, &points, &distributions)
    };
    let mut reasons: Vec<(String, usize)> = Vec::new();
    for message in solved.iter().filter_map(|(_, sampled)| sampled.message.as_ref()) {
        match reasons.iter_mut().find(|(reason, _)| reason == message) {
            Some((_, count)) => *count += 1,
            None => reasons.push((message.clone(), 1)),
        }
    }
    reasons.sort_by_key(|(_, count)| Reverse(*count));
    UncertainSummary {
        model,
        samples: uncertain.samples,
        solved: solved.len(),
        lacking: solved.iter().filter(|(_, sampled)| sampled.lacking > 0).count(),
        reasons,
        seed: uncertain.seed,
        inputs: uncertain
            .inputs
            .iter()
            .map(|input| UncertainKey { key: input.key.clone(), distribution: input.said() })
            .collect(),
        bands: quantities.iter().enumerate().filter_map(band).collect(),
        stops: stops(frictions, &solved),
    }
}

fn band(
    quantity: &Quantity,
    answers: &[f64],
    points: &[Vec<f64>],
    distributions: &[Distribution],
) -> Option<UncertainBand> {
    let bands = Bands::of(answers)?;
    let owed = quantity.is_owed.then(|| attribute(distributions, points, answers)).flatten();
    let owed = owed.map(|owed| UncertainOwed {
        first: owed
            .first
            .iter()
            .map(|first| Some(*first).filter(|share| share.is_finite()))
            .collect(),
        total: owed.total,
        predicts: owed.predicts,
        degree: owed.degree,
    });
    let lacking = answers.len() - bands.count;
    let not_met =
        quantity.to_m.map_or(0, |to_m| answers.iter().filter(|answer| **answer >= to_m).count());
    Some(UncertainBand {
        quantity: quantity.name.to_owned(),
        limit: quantity.limit.to_owned(),
        operation: quantity.operation,
        friction: quantity.friction,
        bit_depth_m: quantity.bit_depth_m,
        unit: quantity.unit.to_owned(),
        expected: quantity.expected,
        quantiles: bands.quantiles,
        mean: bands.mean,
        std: bands.std,
        answers: bands.count,
        without_answer: if quantity.must_be { lacking } else { 0 },
        not_met,
        owed,
    })
}

/// The limit that stops the well first at each friction factor, with the number of samples.
fn stops(frictions: &[Option<f64>], solved: &[(&Vec<f64>, &Sampled)]) -> Vec<UncertainStop> {
    let mut all = Vec::new();
    for (place, friction) in frictions.iter().enumerate() {
        let mut stops: Vec<UncertainStop> = Vec::new();
        for stop in solved.iter().filter_map(|(_, sampled)| sampled.stops.get(place)) {
            let (operation, limit) = stop.unzip();
            match stops.iter_mut().find(|stop| stop.operation == operation && stop.limit == limit) {
                Some(stop) => stop.samples += 1,
                None => {
                    stops.push(UncertainStop { friction: *friction, operation, limit, samples: 1 });
                }
            }
        }
        stops.sort_by_key(|stop| Reverse(stop.samples));
        all.extend(stops);
    }
    all
}

// Results for uncertain inputs, in sentences.

/// Inputs with a smaller sensitivity index are not named.
const NAMED: f64 = 0.05;

/// A fit that predicts a smaller fraction of the variance than this is reported as poor.
const PREDICTS: f64 = 0.9;

/// Scatter of hook load and torque at the deepest bit, and of the reach of a well, each with the
/// inputs of the largest sensitivity.
pub fn scatter(summary: &UncertainSummary, units: UnitSet) -> Vec<String> {
    let deepest_m = summary.bands.iter().filter_map(|band| band.bit_depth_m).fold(0.0, f64::max);
    let is_told = |band: &&UncertainBand| match band.quantity.as_str() {
        "hook_load" | "surface_torque" => {
            band.bit_depth_m == Some(deepest_m) && band.owed.is_some()
        }
        "depth" => band.limit.is_empty(),
        _ => false,
    };
    summary.bands.iter().filter(is_told).map(|band| sentence(summary, band, units)).collect()
}

fn sentence(summary: &UncertainSummary, band: &UncertainBand, units: UnitSet) -> String {
    let (dimension, name, decimals) = match band.quantity.as_str() {
        "hook_load" => (Dimension::Force, "hook load", 1),
        "surface_torque" => (Dimension::Torque, "torque", 1),
        _ => (Dimension::Length, "reach", 0),
    };
    let unit = dimension.unit_in(units);
    let value = |si: f64| format!("{:.decimals$}", unit.from_si(si));
    let [low, _, middle, _, high] = band.quantiles.map(value);
    let whose = match (band.operation, band.friction) {
        (None, Some(friction)) => format!("friction {friction}: "),
        (None, None) => String::new(),
        (Some(operation), _) => format!("{operation}: "),
    };
    let mut text = format!("{whose}{name} {low} to {high}, median {middle} {}", unit.symbol);
    if band.not_met > 0 {
        text += &format!(", in {} of {} samples no limit is reached", band.not_met, band.answers);
    }
    if band.without_answer > 0 {
        text += &format!(", {} without an answer", band.without_answer);
    }
    if let Some(owed) = &band.owed {
        let mut shares: Vec<(&str, f64)> = summary
            .inputs
            .iter()
            .map(|input| input.key.as_str())
            .zip(owed.total.iter().copied())
            .collect();
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        let named = shares.iter().filter(|(_, share)| *share >= NAMED);
        let named: Vec<String> =
            named.map(|(key, share)| format!("{:.0} % due to {key}", 100.0 * share)).collect();
        text += &format!("; {}", named.join(", "));
        if owed.predicts < PREDICTS && owed.first.iter().all(Option::is_some) {
            text += &format!(
                " (uncertain: the fit predicts {:.0} % of the variance)",
                100.0 * owed.predicts.max(0.0)
            );
        }
    }
    text + "."
}

// Tables of uncertain inputs and their effects.

/// Writes the tables, also as CSV; without samples, removes earlier ones.
pub(crate) fn write(
    folder: &ResultsFolder,
    names: &UncertainTables,
    results: Option<(&UncertainSummary, &Table)>,
) -> Result<(), ResultsError> {
    let Some((summary, samples)) = results else {
        for name in [names.bands, names.indices, names.samples].into_iter().chain(names.stops) {
            for ending in ["parquet", "csv"] {
                folder.remove(&format!("{name}.{ending}"))?;
            }
        }
        return Ok(());
    };
    folder.write_table(names.bands, &summary.table(), true)?;
    folder.write_table(names.indices, &summary.indices_table(), true)?;
    folder.write_table(names.samples, samples, true)?;
    match names.stops {
        Some(name) => folder.write_table(name, &summary.stops_table(), true),
        None => Ok(()),
    }
}

/// Sampled inputs, a row for each sample and input.
pub(crate) fn samples_table(sampler: &Sampler<'_>, sampled: &[Option<Sampled>]) -> Table {
    let samples = sampler.points.iter().zip(sampled).enumerate();
    let rows = samples.flat_map(|(place, (point, sampled))| {
        let values = sampler.uncertain.inputs.iter().zip(point);
        values.map(move |(input, value)| UncertainSample {
            sample: place + 1,
            input: input.key.clone(),
            value: input.number(*value),
            unit: input.unit.clone(),
            written: input.written(*value),
            without_answer: sampled.as_ref().map(|sampled| sampled.lacking),
            message: sampled.as_ref().and_then(|sampled| sampled.message.clone()),
        })
    });
    UncertainSample::table(rows)
}

/// Writes the numbers of the picture of the indices; without indices, removes an earlier one.
pub(crate) fn write_picture_numbers(
    folder: &ResultsFolder,
    summary: Option<&UncertainSummary>,
) -> Result<(), ResultsError> {
    match summary.filter(|summary| summary.inputs.len() > 1) {
        Some(summary) => summary.indices_table().write_csv(&folder.path().join("uncertain.csv")),
        None => folder.remove("uncertain.csv"),
    }
}
