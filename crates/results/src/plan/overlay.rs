//! Another program's curves, compared with those of a plan.

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind};

use crate::{Row, Table, row::rows};

/// Another program's curves from a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanOverlay {
    /// Name of the file.
    pub file: String,
    /// Model after model, operation after operation, down the hole.
    pub rows: Vec<PlanOverlayRow>,
    /// For each model, operation and quantity the difference between our curve and theirs, in the
    /// order of the rows; none where no depth has both.
    #[serde(default)]
    pub differences: Vec<PlanOverlayDifference>,
}

rows! {
    /// A weight or torque of another program, and ours.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanOverlayRow {
        model: ModelKind => Words, "Model of the plan: `soft` or `stiff`";
        operation: OperationKind => Words,
            "`trip_out`, `trip_in`, `rotate_off_bottom` or `drill`";
        place: String => Words, "Place of their value in its file";
        is_torque: bool, "Whether it is a torque, N·m, rather than a hook load, N";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        theirs: f64, "Their value, as in the file";
        ours: Option<f64>,
            "Our value with the expected friction, hook loads without the block; none where the \
             plan has no answer there";
        is_torque = |row| row.is_torque, loads {
            theirs = |row| row.theirs, "Their hook load, as in the file" | "Their torque";
            ours = |row| row.ours, "Ours, block excluded" | "Our torque", unanswered;
            difference = |row| row.difference(), "Ours less theirs", unanswered;
        };
    }

    /// Columns of `plan_overlay.parquet`: a row for each weight and torque of another program, for
    /// each model of the plan. Our values use the expected friction and are interpolated linearly
    /// between the depths of the plan.
    pub const PLAN_OVERLAY;
}

impl PlanOverlayRow {
    /// Ours less theirs.
    pub fn difference(&self) -> Option<f64> {
        Some(self.ours? - self.theirs)
    }
}

/// Difference between our curve and theirs in an operation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanOverlayDifference {
    /// Our model.
    pub model: ModelKind,
    /// The operation.
    pub operation: OperationKind,
    /// Whether it is of torques, N·m, rather than of hook loads, N.
    pub is_torque: bool,
    /// Number of depths at which both are known.
    pub count: usize,
    /// Mean of ours less theirs.
    pub mean: f64,
    /// The difference farthest from zero, with its sign.
    pub largest: f64,
    /// Measured depth of the bit at that difference, m.
    pub largest_at_m: f64,
    /// Their value at that difference.
    pub theirs_there: f64,
    /// The difference farthest from zero as a part of their value there; none where that is zero.
    pub largest_part: Option<f64>,
}

impl PlanOverlay {
    /// Creates the curves of a file, with the differences of ours from them.
    pub fn new(file: String, rows: Vec<PlanOverlayRow>) -> Self {
        let differences = Self::differences(&rows);
        Self { file, rows, differences }
    }

    fn differences(rows: &[PlanOverlayRow]) -> Vec<PlanOverlayDifference> {
        let mut all: Vec<PlanOverlayDifference> = Vec::new();
        for row in rows {
            let Some(difference) = row.difference() else { continue };
            let same = |difference: &&mut PlanOverlayDifference| {
                difference.model == row.model
                    && difference.operation == row.operation
                    && difference.is_torque == row.is_torque
            };
            match all.iter_mut().find(same) {
                Some(differences) => {
                    differences.count += 1;
                    differences.mean += difference;
                    if difference.abs() > differences.largest.abs() {
                        differences.largest = difference;
                        differences.largest_at_m = row.bit_depth_m;
                        differences.theirs_there = row.theirs;
                    }
                }
                None => all.push(PlanOverlayDifference {
                    model: row.model,
                    operation: row.operation,
                    is_torque: row.is_torque,
                    count: 1,
                    mean: difference,
                    largest: difference,
                    largest_at_m: row.bit_depth_m,
                    theirs_there: row.theirs,
                    largest_part: None,
                }),
            }
        }
        for differences in &mut all {
            differences.mean /= differences.count as f64;
            differences.largest_part = Some(differences.largest / differences.theirs_there)
                .filter(|part| part.is_finite());
        }
        all
    }

    /// A row for each weight and torque, for each model.
    pub fn table(&self) -> Table {
        PlanOverlayRow::table(&self.rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_ours_less_theirs() {
        let row = |bit_depth_m: f64, theirs: f64, ours: Option<f64>| PlanOverlayRow {
            model: ModelKind::Soft,
            operation: OperationKind::TripOut,
            place: "line 2".into(),
            is_torque: false,
            bit_depth_m,
            theirs,
            ours,
        };
        let rows = vec![
            row(500.0, 100.0, Some(102.0)),
            row(1000.0, 200.0, Some(194.0)),
            row(1500.0, 300.0, None),
        ];
        let overlay = PlanOverlay::new("other.csv".into(), rows);
        let [only] = &overlay.differences[..] else { panic!("one") };
        assert_eq!(
            (only.count, only.mean, only.largest, only.largest_at_m),
            (2, -2.0, -6.0, 1000.0)
        );
        assert_eq!((only.theirs_there, only.largest_part), (200.0, Some(-0.03)));
        assert_eq!(overlay.table().rows(), 3);
    }
}
