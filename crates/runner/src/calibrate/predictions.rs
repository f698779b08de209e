//! What the readings would be, by either model, on all cores.

use rayon::prelude::*;
use wholestring::{
    statics::stiff::{self, StiffSettings},
    well::HoleKind,
};
use wholestring_plan::calibration::{
    Asked, Assembly, CalibrationError, Loads, Predict, SoftPredictions,
};

use crate::cancellation::CancellationToken;

/// A model on all cores.
pub(super) struct Predictions<'a> {
    pub(super) assemblies: &'a [Assembly],
    /// How the stiff string of each is found; the soft string where there is none.
    pub(super) stiff: Option<Vec<StiffSettings>>,
    pub(super) cancellation: &'a CancellationToken,
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
        let setup = assembly.setup.with_friction(&asked.factors.walls());
        let setup = setup.map_err(|error| no_answer(error.to_string()))?;
        let model = setup.at(asked.bit_depth_m).map_err(|error| no_answer(error.to_string()))?;
        let operation = assembly.operation(asked.motion, asked.bit_depth_m);
        let answer = stiff::solve(&model, &operation, &settings[asked.setup]);
        let scalars = answer.map_err(|error| no_answer(error.to_string()))?.scalars;
        Ok(Loads { hook_load_N: scalars.hook_load_N, torque_N_m: scalars.surface_torque_N_m })
    }
}

impl Predict for Predictions<'_> {
    fn reaches(&self, setup: usize, bit_depth_m: f64, kind: HoleKind) -> bool {
        self.assemblies[setup].reaches(bit_depth_m, kind)
    }

    fn loads(&self, asked: &[Asked]) -> Result<Vec<Loads>, CalibrationError> {
        asked.par_iter().map(|asked| self.one(asked)).collect()
    }
}
