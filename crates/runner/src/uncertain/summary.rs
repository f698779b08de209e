//! What samples come to: how each number scatters, and which inputs it is owed to.

use std::cmp::Reverse;

use wholestring_plan::uncertainty::{Bands, Distribution, attribute};
use wholestring_results::{
    UncertainBand, UncertainKey, UncertainOwed, UncertainStop, UncertainSummary,
};

use super::{Quantity, Sampled, Sampler};

/// What they come to; samples that were not solved are none.
pub(crate) fn summary(
    sampler: &Sampler<'_>,
    model: &str,
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
    let band = |(place, of): (usize, &Quantity)| {
        let answers =
            solved.iter().map(|(_, sampled)| sampled.answers.get(place).copied().flatten());
        let answers: Vec<f64> = answers.map(|of| of.unwrap_or(f64::NAN)).collect();
        band(of, &answers, &points, &distributions)
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
        model: model.to_owned(),
        samples: uncertain.samples,
        solved: solved.len(),
        lacking: solved.iter().filter(|(_, sampled)| sampled.lacking > 0).count(),
        reasons,
        seed: uncertain.seed,
        inputs: uncertain
            .inputs
            .iter()
            .map(|of| UncertainKey { key: of.key.clone(), distribution: of.said() })
            .collect(),
        bands: quantities.iter().enumerate().filter_map(band).collect(),
        stops: stops(frictions, &solved),
    }
}

fn band(
    of: &Quantity,
    answers: &[f64],
    points: &[Vec<f64>],
    distributions: &[Distribution],
) -> Option<UncertainBand> {
    let bands = Bands::of(answers)?;
    let owed = of.is_owed.then(|| attribute(distributions, points, answers)).flatten();
    let owed = owed.map(|owed| UncertainOwed {
        first: owed.first.iter().map(|of| Some(*of).filter(|of| of.is_finite())).collect(),
        total: owed.total,
        predicts: owed.predicts,
        degree: owed.degree,
    });
    let lacking = answers.len() - bands.count;
    let not_met = of.to_m.map_or(0, |to_m| answers.iter().filter(|of| **of >= to_m).count());
    Some(UncertainBand {
        quantity: of.name.to_owned(),
        limit: of.limit.to_owned(),
        operation: of.operation.to_owned(),
        friction: of.friction,
        bit_depth_m: of.bit_depth_m,
        unit: of.unit.to_owned(),
        expected: of.expected,
        quantiles: bands.quantiles,
        mean: bands.mean,
        std: bands.std,
        answers: bands.count,
        without_answer: if of.must_be { lacking } else { 0 },
        not_met,
        owed,
    })
}

/// What stops the well first at each friction, in how many samples.
fn stops(frictions: &[Option<f64>], solved: &[(&Vec<f64>, &Sampled)]) -> Vec<UncertainStop> {
    let mut all = Vec::new();
    for (place, friction) in frictions.iter().enumerate() {
        let mut stops: Vec<UncertainStop> = Vec::new();
        for stop in solved.iter().filter_map(|(_, sampled)| sampled.stops.get(place)) {
            let (operation, limit) = stop.clone().unwrap_or_default();
            match stops.iter_mut().find(|of| of.operation == operation && of.limit == limit) {
                Some(of) => of.samples += 1,
                None => {
                    stops.push(UncertainStop { friction: *friction, operation, limit, samples: 1 });
                }
            }
        }
        stops.sort_by_key(|of| Reverse(of.samples));
        all.extend(stops);
    }
    all
}
