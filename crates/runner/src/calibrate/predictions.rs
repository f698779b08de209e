//! Predicted readings by either model, on all cores.

use std::sync::{
    Mutex,
    atomic::{AtomicBool, Ordering},
};

use wholestring::statics::stiff::{self, StiffSettings};
use wholestring_plan::calibration::{
    Asked, Assembly, CalibrationError, HolePart, Loads, Predict, SoftPredictions,
};

use crate::{
    cancellation::CancellationToken,
    observer::{BatchSize, CaseEnded, Observer},
    parallel::{in_parallel, jobs, lock},
};

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
