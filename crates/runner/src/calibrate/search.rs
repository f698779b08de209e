//! Search for the parameters of a calibration by the requested model.

use wholestring::outcome::ModelKind;
use wholestring_plan::calibration::{Calibration, CalibrationError, Settings, calibrate};

use super::{fit::Fit, predictions::Predictions};
use crate::{
    cancellation::CancellationToken,
    error::Error,
    observer::Observer,
    readings::{self, NamedCase, Readings},
};

/// Number of depths of the bands of a case, for the soft and for the stiff string.
const DEPTHS: usize = 30;
const STIFF_DEPTHS: usize = 10;

/// Nodes of a factor for predictions by the stiff string, and their distance from the solution of
/// the soft string, which is reduced if strings at that distance have no solution.
const STIFF_NODES: usize = 3;
const STIFF_REACH: [f64; 2] = [0.08, 0.025];

/// Parameters that are fitted, and the strings of the readings.
#[derive(Clone, Copy)]
pub(super) struct Search<'a> {
    /// Parameters and options of the fit.
    pub(super) fit: &'a Fit,
    /// The cases of the strings that were in the hole.
    pub(super) cases: &'a [NamedCase<'a>],
    pub(super) observer: &'a dyn Observer,
    pub(super) cancellation: &'a CancellationToken,
}

impl Search<'_> {
    /// Fits the parameters by the requested model; `is_main` with intervals and bands.
    pub(super) fn calibration(
        &self,
        data: &Readings,
        settings: &Settings,
        is_main: bool,
    ) -> Result<Calibration, Error> {
        let Self { fit, cases, observer, cancellation } = *self;
        let is_stiff = fit.model == ModelKind::Stiff;
        // A fit for comparison requires only the parameters.
        let settings = &Settings { profiles: is_main && settings.profiles, ..settings.clone() };
        let depths = match is_main {
            true => depths(data, if is_stiff { STIFF_DEPTHS } else { DEPTHS }),
            false => Vec::new(),
        };
        let solve = |stiff, settings: &Settings, depths: &[(usize, f64)]| {
            let model = Predictions { assemblies: &data.assemblies, stiff, cancellation, observer };
            calibrate(&model, &data.readings, &data.held_out, depths, settings)
        };
        let explained = |error: CalibrationError| match cancellation.is_cancelled() {
            true => Error::Interrupted,
            false => Error::BadInput(error.to_string()),
        };
        if !is_stiff {
            return solve(None, settings, &depths).map_err(explained);
        }
        let soft = Settings { profiles: false, ..settings.clone() };
        let soft = solve(None, &soft, &[]).map_err(explained)?;
        let factors = soft.estimates.iter().filter(|estimate| estimate.parameter.is_factor());
        let factors: Vec<f64> = factors.map(|factor| factor.value).collect();
        let least = factors.iter().copied().fold(f64::INFINITY, f64::min);
        let most = factors.iter().copied().fold(0.0, f64::max);
        let stiff = data.cases.iter().map(|&case| cases[case].case.dynamics.stiff_string());
        let stiff: Vec<_> = stiff.collect();
        let within = |reach: f64| {
            let first_box = [(least.min(most) - reach).max(0.0), most + reach];
            let settings = Settings { first_box, nodes: STIFF_NODES, ..settings.clone() };
            solve(Some(stiff.clone()), &settings, &depths)
        };
        let [far, near] = STIFF_REACH;
        let found = match within(far) {
            Err(CalibrationError::NoAnswer { .. }) => within(near),
            found => found,
        };
        found.map_err(explained)
    }
}

/// Depths of the bands: in each case from its first reading to its last, in the deepest to the end
/// of its hole, with the string and mud of its deepest reading.
fn depths(data: &Readings, count: usize) -> Vec<(usize, f64)> {
    let mut cases: Vec<usize> = data.cases.clone();
    cases.sort_unstable();
    cases.dedup();
    let span = |case: usize| {
        let readings = data.readings.iter().filter(|reading| data.cases[reading.setup] == case);
        let depths = readings.map(|reading| (reading.bit_depth_m, reading.setup));
        let least = depths.clone().map(|depth| depth.0).fold(f64::INFINITY, f64::min);
        let (most, setup) = depths.fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
        (least, most, setup)
    };
    // A case may have only rows that are not used.
    let spans: Vec<_> = cases.into_iter().map(span).filter(|span| span.0 <= span.1).collect();
    let deepest = spans.iter().map(|span| span.1).fold(0.0, f64::max);
    let grid = |&(from, to, setup): &(f64, f64, usize)| {
        let to = if to == deepest { readings::deepest_m(&data.assemblies[setup]) } else { to };
        let last = if to > from { count - 1 } else { 0 };
        let at = move |k: usize| from + (to - from) * k as f64 / last.max(1) as f64;
        (0..=last).map(move |k| (setup, at(k))).collect::<Vec<_>>()
    };
    spans.iter().flat_map(grid).collect()
}
