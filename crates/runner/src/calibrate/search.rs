//! Search for the parameters of a calibration by the requested model, with predicted readings.

use std::sync::{
    Mutex,
    atomic::{AtomicBool, Ordering},
};

use wholestring::{
    outcome::ModelKind,
    statics::stiff::{self, StiffSettings},
};
use wholestring_plan::calibration::{
    Asked, Assembly, Calibration, CalibrationError, HolePart, Loads, Predict, Settings,
    SoftPredictions, calibrate,
};

use super::option::Fit;
use crate::{
    cancellation::CancellationToken,
    error::Error,
    observer::{BatchSize, CaseEnded, Observer},
    parallel::{in_parallel, jobs, lock},
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

// Predicted readings by either model, on all cores.

/// A model that predicts on all cores.
pub(super) struct Predictions<'a> {
    pub(super) assemblies: &'a [Assembly],
    /// Settings of the stiff string for each assembly; the soft string predicts if `None`.
    pub(super) stiff: Option<Vec<StiffSettings>>,
    pub(super) cancellation: &'a CancellationToken,
    /// Receives the progress of the stiff strings of one call.
    pub(super) observer: &'a dyn Observer,
}

impl Predictions<'_> {
    /// Loads of each reading, on all cores; `ended` is called after each.
    fn all(
        &self,
        requests: &[Asked],
        ended: impl Fn() + Sync,
    ) -> Result<Vec<Loads>, CalibrationError> {
        let order: Vec<usize> = (0..requests.len()).collect();
        let loads: Vec<Mutex<Option<Result<Loads, CalibrationError>>>> =
            requests.iter().map(|_| Mutex::default()).collect();
        let failed = AtomicBool::new(false);
        in_parallel(jobs(None), &order, |place| {
            if !failed.load(Ordering::Relaxed) {
                let found = self.one(&requests[place]);
                failed.fetch_or(found.is_err(), Ordering::Relaxed);
                *lock(&loads[place]) = Some(found);
                ended();
            }
        });
        let loads = loads.iter().filter_map(|loads| lock(loads).take());
        loads.collect()
    }

    fn one(&self, request: &Asked) -> Result<Loads, CalibrationError> {
        if self.cancellation.is_cancelled() {
            return Err(CalibrationError::Interrupted);
        }
        let Some(settings) = &self.stiff else {
            return SoftPredictions::new(self.assemblies).one(request);
        };
        let assembly = &self.assemblies[request.setup];
        let no_answer = |reason: String| request.no_answer("stiff", reason);
        let setup = request.factors.applied_to(&assembly.setup);
        let setup = setup.map_err(|error| no_answer(error.to_string()))?;
        let model = setup.at(request.bit_depth_m).map_err(|error| no_answer(error.to_string()))?;
        let operation = assembly.operation(request.motion, request.bit_depth_m);
        let answer = stiff::solve(&model, &operation, &settings[request.setup]);
        let scalars = answer.map_err(|error| no_answer(error.to_string()))?.scalars;
        Ok(Loads { hook_load_N: scalars.hook_load_N, torque_N_m: scalars.surface_torque_N_m })
    }
}

impl Predict for Predictions<'_> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool {
        self.assemblies[setup].reaches(bit_depth_m, part)
    }

    fn loads(&self, requests: &[Asked]) -> Result<Vec<Loads>, CalibrationError> {
        if self.stiff.is_none() {
            return self.all(requests, || {});
        }
        let count = requests.len();
        self.observer.batch_started(&BatchSize { cases: count, finished: 0, simulated_s: 0.0 });
        let ended = Mutex::new(0);
        let loads = self.all(requests, || {
            let mut ended = lock(&ended);
            *ended += 1;
            self.observer.case_ended(&CaseEnded { ended: *ended, of: count, reused_s: 0.0 });
        });
        self.observer.batch_ended();
        loads
    }
}
