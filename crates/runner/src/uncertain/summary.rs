//! Statistics of the samples: scatter of each quantity, and its sensitivity to the inputs.

use std::cmp::Reverse;

use wholestring::outcome::ModelKind;
use wholestring_plan::uncertainty::{Bands, Distribution, attribute};
use wholestring_results::{
    UncertainBand, UncertainKey, UncertainOwed, UncertainStop, UncertainSummary,
};

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
