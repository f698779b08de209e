//! Measured readings, compared with the predictions of the plan.

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind};

use crate::{PLAN_MEASURED, Table};

/// Predictions with low and with high friction that differ by less than this part of the one
/// between them do not depend on friction; no reading is between them except by chance.
const SAME: f64 = 2e-3;

/// A measured weight or torque, and its prediction at each level of friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanMeasured {
    /// The model that predicts.
    pub model: ModelKind,
    /// Place of the reading in its file.
    pub place: String,
    /// The operation.
    pub operation: OperationKind,
    /// Kind of reading: `pick_up`, `slack_off`, `rotating`, `torque` or `torque_on_bottom`.
    pub reading: String,
    /// Whether it is a torque, N·m, rather than a weight, N.
    pub is_torque: bool,
    /// Whether the file holds it out of a calibration.
    pub held_out: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Measured value; weights include the block.
    pub measured: f64,
    /// Weight of the block that it includes, N; zero for torques.
    pub block_N: f64,
    /// Prediction for the string that was in the hole, with low, expected and high friction; none
    /// without an answer.
    pub predicted: [Option<f64>; 3],
    /// Reason why there is no answer.
    pub message: Option<String>,
}

impl PlanMeasured {
    /// Value to compare with the curves of a plan: torque, or hook load without block.
    pub fn beside_curves(&self) -> f64 {
        self.measured - self.block_N
    }

    /// Measured less predicted with the expected friction.
    pub fn residual(&self) -> Option<f64> {
        Some(self.measured - self.predicted[1]?)
    }

    /// Whether it is between the predictions of low and high friction; none where it does not
    /// depend on friction, or there is no answer.
    pub fn between(&self) -> Option<bool> {
        let [Some(low), Some(expected), Some(high)] = self.predicted else { return None };
        let depends = (high - low).abs() > SAME * expected.abs();
        depends.then(|| (low.min(high)..=low.max(high)).contains(&self.measured))
    }
}

/// Number of a model's readings between low and high friction, and number of those that depend on
/// friction.
pub(super) fn between(rows: &[PlanMeasured], model: ModelKind) -> (usize, usize) {
    let known = rows.iter().filter(|row| row.model == model).filter_map(PlanMeasured::between);
    known.fold((0, 0), |(within, all), is| (within + usize::from(is), all + 1))
}

/// A row for each reading by each model.
pub(super) fn table(rows: &[PlanMeasured]) -> Table {
    let mut table = Table::with_columns(PLAN_MEASURED);
    for row in rows {
        let [low, expected, high] = row.predicted;
        let values = [Some(row.measured), low, expected, high, row.residual()];
        let values = values.map(|value| value.unwrap_or(f64::NAN));
        let none = [f64::NAN; 5];
        let (weights, torques) = if row.is_torque { (none, values) } else { (values, none) };
        let answer = |is: bool| if is { "yes" } else { "no" };
        table.append(
            &[
                ("model", &[row.model.name()]),
                ("place", &[&row.place]),
                ("operation", &[row.operation.name()]),
                ("reading", &[&row.reading]),
                ("between", &[row.between().map_or("", answer)]),
                ("message", &[row.message.as_deref().unwrap_or_default()]),
            ],
            &[
                ("held_out", &[f64::from(u8::from(row.held_out))]),
                ("bit_depth_m", &[row.bit_depth_m]),
                ("measured_N", &[weights[0]]),
                ("hook_load_N", &[weights[0] - row.block_N]),
                ("low_friction_N", &[weights[1]]),
                ("predicted_N", &[weights[2]]),
                ("high_friction_N", &[weights[3]]),
                ("residual_N", &[weights[4]]),
                ("measured_N_m", &[torques[0]]),
                ("low_friction_N_m", &[torques[1]]),
                ("predicted_N_m", &[torques[2]]),
                ("high_friction_N_m", &[torques[3]]),
                ("residual_N_m", &[torques[4]]),
            ],
        );
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(predicted: [f64; 3], measured: f64) -> PlanMeasured {
        PlanMeasured {
            model: ModelKind::Soft,
            place: "line 2".into(),
            operation: OperationKind::TripIn,
            reading: "slack_off".into(),
            is_torque: false,
            held_out: false,
            bit_depth_m: 1000.0,
            measured,
            block_N: 0.0,
            predicted: predicted.map(Some),
            message: None,
        }
    }

    /// More friction reduces slack-off weight, so that "between" holds whichever prediction is
    /// greater.
    #[test]
    fn between_is_known_where_friction_matters() {
        let slack_off = [300.0, 250.0, 200.0];
        let rows =
            [row(slack_off, 210.0), row(slack_off, 190.0), row([250.0, 250.1, 250.2], 260.0)];
        assert_eq!(rows.each_ref().map(PlanMeasured::between), [Some(true), Some(false), None]);
        assert_eq!(rows[0].residual(), Some(-40.0));
        assert_eq!(between(&rows, ModelKind::Soft), (1, 2));
        assert_eq!(between(&rows, ModelKind::Stiff), (0, 0));
        let locked =
            PlanMeasured { predicted: [Some(300.0), Some(250.0), None], ..rows[0].clone() };
        assert_eq!((locked.between(), locked.residual()), (None, Some(-40.0)));
    }
}
