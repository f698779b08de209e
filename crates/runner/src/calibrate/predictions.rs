//! What the readings would be, by either model, on all cores.

use std::sync::Mutex;

use rayon::prelude::*;
use wholestring::statics::stiff::{self, StiffSettings};
use wholestring_plan::calibration::{
    Asked, Assembly, CalibrationError, HolePart, Loads, Predict, SoftPredictions,
};

use crate::{
    cancellation::CancellationToken,
    observer::{BatchSize, CaseEnded, Observer},
    parallel::lock,
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
    fn one(&self, asked: &Asked) -> Result<Loads, CalibrationError> {
        if self.cancellation.is_cancelled() {
            return Err(CalibrationError::NotFitted("interrupted".into()));
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
            return asked.par_iter().map(|asked| self.one(asked)).collect();
        }
        let of = asked.len();
        self.observer.batch_started(&BatchSize { cases: of, finished: 0, simulated_s: 0.0 });
        let ended = Mutex::new(0);
        let loads = asked.par_iter().map(|asked| {
            let loads = self.one(asked);
            let mut ended = lock(&ended);
            *ended += 1;
            self.observer.case_ended(&CaseEnded { ended: *ended, of, reused_s: 0.0 });
            loads
        });
        let loads = loads.collect();
        self.observer.batch_ended();
        loads
    }
}
