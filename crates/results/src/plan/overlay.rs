//! Another program's curves, beside those of a plan.

use serde::{Deserialize, Serialize};

use crate::{PLAN_OVERLAY, Table};

/// Another program's curves of a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanOverlay {
    /// Name of the file.
    pub file: String,
    /// Model after model, operation after operation, down the hole.
    pub rows: Vec<PlanOverlayRow>,
    /// Of each model, operation and quantity how far ours lies from theirs, in the order of the rows; none where no
    /// depth has both.
    #[serde(default)]
    pub differences: Vec<PlanOverlayDifference>,
}

/// A weight or torque of another program, and ours.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanOverlayRow {
    /// Name of our model.
    pub model: String,
    /// Name of the operation.
    pub operation: String,
    /// Where it stands in its file.
    pub place: String,
    /// Whether it is a torque, N·m, and no hook load, N.
    pub is_torque: bool,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Theirs, as the file has it.
    pub theirs: f64,
    /// Ours with the friction that is expected, hook loads without the block; none where the plan has no answer there.
    pub ours: Option<f64>,
}

impl PlanOverlayRow {
    /// Ours less theirs.
    pub fn difference(&self) -> Option<f64> {
        Some(self.ours? - self.theirs)
    }
}

/// How far ours lies from theirs in an operation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanOverlayDifference {
    /// Name of our model.
    pub model: String,
    /// Name of the operation.
    pub operation: String,
    /// Whether of torques, N·m, and not of hook loads, N.
    pub is_torque: bool,
    /// At how many depths both are known.
    pub count: usize,
    /// Mean of ours less theirs.
    pub mean: f64,
    /// The one that is farthest from zero, with its sign.
    pub largest: f64,
    /// Measured depth of the bit there, m.
    pub largest_at_m: f64,
    /// Theirs there.
    pub theirs_there: f64,
    /// The one that is farthest from zero as a part of theirs there; none where theirs is zero.
    pub largest_part: Option<f64>,
}

impl PlanOverlay {
    /// The curves of a file, with how far ours lies from them.
    pub fn new(file: String, rows: Vec<PlanOverlayRow>) -> Self {
        let differences = Self::differences(&rows);
        Self { file, rows, differences }
    }

    fn differences(rows: &[PlanOverlayRow]) -> Vec<PlanOverlayDifference> {
        let mut all: Vec<PlanOverlayDifference> = Vec::new();
        for row in rows {
            let Some(difference) = row.difference() else { continue };
            let same = |of: &&mut PlanOverlayDifference| {
                of.model == row.model
                    && of.operation == row.operation
                    && of.is_torque == row.is_torque
            };
            match all.iter_mut().find(same) {
                Some(of) => {
                    of.count += 1;
                    of.mean += difference;
                    if difference.abs() > of.largest.abs() {
                        of.largest = difference;
                        of.largest_at_m = row.bit_depth_m;
                        of.theirs_there = row.theirs;
                    }
                }
                None => all.push(PlanOverlayDifference {
                    model: row.model.clone(),
                    operation: row.operation.clone(),
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
        for of in &mut all {
            of.mean /= of.count as f64;
            of.largest_part = Some(of.largest / of.theirs_there).filter(|part| part.is_finite());
        }
        all
    }

    /// A row for each weight and torque, of each model.
    pub fn table(&self) -> Table {
        let mut table = Table::with_columns(PLAN_OVERLAY);
        for of in &self.rows {
            let values = [Some(of.theirs), of.ours, of.difference()];
            let values = values.map(|value| value.unwrap_or(f64::NAN));
            let none = [f64::NAN; 3];
            let (weights, torques) = if of.is_torque { (none, values) } else { (values, none) };
            table.append(
                &[
                    ("model", &[&of.model]),
                    ("operation", &[&of.operation]),
                    ("place", &[&of.place]),
                ],
                &[
                    ("bit_depth_m", &[of.bit_depth_m]),
                    ("theirs_N", &[weights[0]]),
                    ("ours_N", &[weights[1]]),
                    ("difference_N", &[weights[2]]),
                    ("theirs_N_m", &[torques[0]]),
                    ("ours_N_m", &[torques[1]]),
                    ("difference_N_m", &[torques[2]]),
                ],
            );
        }
        table
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_ours_less_theirs() {
        let row = |bit_depth_m: f64, theirs: f64, ours: Option<f64>| PlanOverlayRow {
            model: "soft".into(),
            operation: "trip_out".into(),
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
        let [of] = &overlay.differences[..] else { panic!("one") };
        assert_eq!((of.count, of.mean, of.largest, of.largest_at_m), (2, -2.0, -6.0, 1000.0));
        assert_eq!((of.theirs_there, of.largest_part), (200.0, Some(-0.03)));
        assert_eq!(overlay.table().rows(), 3);
    }
}
