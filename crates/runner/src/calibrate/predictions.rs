//! What the readings would be, by either model, on all cores.

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

/// A model on all cores.
pub(super) struct Predictions<'a> {
    pub(super) assemblies: &'a [Assembly],
    /// How the stiff string of each is found; the soft string where there is none.
    pub(super) stiff: Option<Vec<StiffSettings>>,
    pub(super) cancellation: &'a CancellationToken,
    /// Learns how far the stiff strings have come that are asked for at once.
    pub(super) observer: &'a dyn Observer,
}

impl Predictions<'_> {
    /// The loads of each, on all cores; `ended` is called after each.
    fn all(
        &self,
        asked: &[Asked],
        ended: impl Fn() + Sync,
    ) -> Result<Vec<Loads>, CalibrationError> {
        let order: Vec<usize> = (0..asked.len()).collect();
        let loads: Vec<Mutex<Option<Result<Loads, CalibrationError>>>> =
            asked.iter().map(|_| Mutex::default()).collect();
        let failed = AtomicBool::new(false);
        in_parallel(jobs(None), &order, |place| {
            if !failed.load(Ordering::Relaxed) {
                let found = self.one(&asked[place]);
                failed.fetch_or(found.is_err(), Ordering::Relaxed);
                *lock(&loads[place]) = Some(found);
                ended();
            }
        });
        let loads = loads.iter().filter_map(|loads| lock(loads).take());
        loads.collect()
    }

    fn one(&self, asked: &Asked) -> Result<Loads, CalibrationError> {
        if self.cancellation.is_cancelled() {
            return Err(CalibrationError::Interrupted);
        }
        let Some(settings) = &self.stiff else {
            return SoftPredictions::new(self.assemblies).one(asked);
        };
        let assembly = &self.assemblies[asked.setup];
        let no_answer = |reason: String| asked.no_answer("stiff", reason);
        let setup = asked.factors.applied_to(&assembly.setup);
        let setup = setup.map_err(|error| no_answer(error.to_string()))?;
        let model = setup.at(asked.bit_depth_m).map_err(|error| no_answer(error.to_string()))?;
        let operation = assembly.operation(asked.motion, asked.bit_depth_m);
        let answer = stiff::solve(&model, &operation, &settings[asked.setup]);
        let scalars = answer.map_err(|error| no_answer(error.to_string()))?.scalars;
        Ok(Loads { hook_load_N: scalars.hook_load_N, torque_N_m: scalars.surface_torque_N_m })
    }
}

impl Predict for Predictions<'_> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, part: HolePart) -> bool {
        self.assemblies[setup].reaches(bit_depth_m, part)
    }

    fn loads(&self, asked: &[Asked]) -> Result<Vec<Loads>, CalibrationError> {
        if self.stiff.is_none() {
            return self.all(asked, || {});
        }
        let of = asked.len();
        self.observer.batch_started(&BatchSize { cases: of, finished: 0, simulated_s: 0.0 });
        let ended = Mutex::new(0);
        let loads = self.all(asked, || {
            let mut ended = lock(&ended);
            *ended += 1;
            self.observer.case_ended(&CaseEnded { ended: *ended, of, reused_s: 0.0 });
        });
        self.observer.batch_ended();
        loads
    }
}
