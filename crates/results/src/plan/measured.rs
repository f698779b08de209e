//! Measured readings, compared with the predictions of the plan.

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind};

use crate::row::rows;

/// Predictions with low and with high friction that differ by less than this part of the one
/// between them do not depend on friction; no reading is between them except by chance.
const SAME: f64 = 2e-3;

rows! {
    /// A measured weight or torque, and its prediction at each level of friction.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanMeasured {
        model: ModelKind => Words, "Model that predicts: `soft` or `stiff`";
        place: String, "Place of the reading in its file";
        operation: OperationKind => Words, "`trip_out`, `drill`, ...";
        place = |row| &row.place => Words, "Place of the reading in its file";
        reading: String => Words,
            "`pick_up`, `slack_off`, `rotating`, `torque` or `torque_on_bottom`";
        is_torque: bool, "Whether it is a torque, N·m, rather than a weight, N";
        held_out: bool => Ratio, "1 where the file holds it out of a calibration, 0 otherwise";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        measured: f64, "Measured value; weights include the block";
        block_N: f64, "Weight of the block that it includes, N; zero for torques";
        predicted: [Option<f64>; 3],
            "Prediction for the string that was in the hole, with low, expected and high friction; \
             none without an answer";
        is_torque = |row| row.is_torque, loads {
            measured = |row| row.measured, "Measured weight, block included" | "Measured torque";
            hook_load = |row| row.measured - row.block_N,
                "The same without the block, comparable with `plan_broomstick`" | _;
            low_friction = |row| row.predicted[0],
                "The same predicted with low friction", unanswered;
            predicted = |row| row.predicted[1], "With the expected friction", unanswered;
            high_friction = |row| row.predicted[2], "With high friction", unanswered;
            residual = |row| row.residual(), "Measured less predicted", unanswered;
        };
        between = |row| row.between() => Words,
            "Whether it is between the values of low and high friction: `yes` or `no`; empty where \
             friction does not change it or there is no answer",
            null_where "friction does not change it, or there is no answer";
        message: Option<String> => Words, "Reason why there is no answer; else empty",
            null_where "there is an answer";
    }

    /// Columns of `plan_measured.parquet`: a row for each measured weight and torque, for each
    /// model. Predictions use the expected friction and the string that was in the hole.
    pub const PLAN_MEASURED;
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
