//! Curves of another program overlaid on those of a plan.

use std::path::Path;

use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_results::{PlanOverlay, PlanOverlayRow, PlanSummary};
use wholestring_tabular::{ImportedReading, read_readings};

use crate::{error::Error, survey};

/// Weights and torques that another program computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// Name of the file on the page.
    pub file: String,
    /// Readings in the order of the file.
    pub readings: Vec<ImportedReading>,
    /// Interpretation of the file, in sentences.
    pub notes: Vec<String>,
}

/// Quantity of a reading in an operation.
struct Quantity {
    operation: OperationKind,
    is_torque: bool,
    theirs: fn(&ImportedReading) -> Option<f64>,
}

const QUANTITIES: [Quantity; 5] = [
    Quantity {
        operation: OperationKind::TripOut,
        is_torque: false,
        theirs: |reading| reading.pick_up_N,
    },
    Quantity {
        operation: OperationKind::TripIn,
        is_torque: false,
        theirs: |reading| reading.slack_off_N,
    },
    Quantity {
        operation: OperationKind::RotateOffBottom,
        is_torque: false,
        theirs: |reading| reading.rotating_N,
    },
    Quantity {
        operation: OperationKind::RotateOffBottom,
        is_torque: true,
        theirs: |reading| reading.torque_N_m,
    },
    Quantity {
        operation: OperationKind::Drill,
        is_torque: true,
        theirs: |reading| reading.torque_on_bottom_N_m,
    },
];

impl Overlay {
    /// Reads a file of weights and torques in the format of measurements, CSV or Excel.
    ///
    /// # Errors
    /// A file that cannot be read, or contains none.
    pub fn read(path: &Path) -> Result<Self, Error> {
        Self::of_bytes(&path.display().to_string(), &survey::bytes(path, "curves")?)
    }

    /// Reads the bytes of such a file with this name.
    ///
    /// # Errors
    /// Bytes that are no such file.
    pub fn of_bytes(name: &str, bytes: &[u8]) -> Result<Self, Error> {
        let imported = read_readings(bytes, name).map_err(|error| survey::explained(&error))?;
        let file = Path::new(name).file_name();
        let file = file.map_or_else(|| name.to_owned(), |name| name.to_string_lossy().into_owned());
        Ok(Self { file, readings: imported.readings, notes: imported.notes })
    }

    /// Compares the other program's values with the plan at their depths; returns sentences on
    /// values outside the plan.
    pub(super) fn laid_over(&self, summary: &PlanSummary) -> (PlanOverlay, Vec<String>) {
        let mut rows = Vec::new();
        let mut without = Vec::new();
        for quantity in QUANTITIES {
            let operation = quantity.operation;
            let mut theirs: Vec<(&ImportedReading, f64)> = self
                .readings
                .iter()
                .filter_map(|reading| Some((reading, (quantity.theirs)(reading)?)))
                .collect();
            if !summary.operations.contains(&operation) {
                if !theirs.is_empty() {
                    let what = if quantity.is_torque { "torques" } else { "hook loads" };
                    without.push(format!(
                        "left out: its {what} of '{}', an operation that is not in the plan",
                        operation.name()
                    ));
                }
                continue;
            }
            theirs.sort_by(|a, b| a.0.bit_depth_m.total_cmp(&b.0.bit_depth_m));
            for model in summary.models.iter().copied() {
                let ours = curve(summary, model, operation, quantity.is_torque);
                rows.extend(theirs.iter().map(|(their, theirs)| PlanOverlayRow {
                    model,
                    operation,
                    place: their.place.clone(),
                    is_torque: quantity.is_torque,
                    bit_depth_m: their.bit_depth_m,
                    theirs: *theirs,
                    ours: between(&ours, their.bit_depth_m),
                }));
            }
        }
        // Ordered by model.
        let place = |model: ModelKind| summary.models.iter().position(|own| *own == model);
        rows.sort_by_key(|row: &PlanOverlayRow| place(row.model));
        (PlanOverlay::new(self.file.clone(), rows), without)
    }
}

/// Depths of the bit and expected values of the plan there; NaN without a solution.
fn curve(
    summary: &PlanSummary,
    model: ModelKind,
    operation: OperationKind,
    is_torque: bool,
) -> Vec<(f64, f64)> {
    let points = summary.curve(model, operation, FrictionLevel::Expected);
    let value = |point: &wholestring_results::PlanPoint| match (point.scalars, is_torque) {
        (Some(scalars), true) => scalars.surface_torque_N_m,
        (Some(scalars), false) => scalars.hook_load_N,
        (None, _) => f64::NAN,
    };
    points.map(|point| (point.bit_depth_m, value(point))).collect()
}

/// Depths within this distance are equal except for rounding, m.
const ROUNDED_M: f64 = 0.01;

/// Linear interpolation at a depth; `None` beyond the first and the last point.
fn between(curve: &[(f64, f64)], depth_m: f64) -> Option<f64> {
    if let Some((_, value)) = curve.iter().find(|(at, _)| (at - depth_m).abs() < ROUNDED_M) {
        return value.is_finite().then_some(*value);
    }
    let below = curve.iter().position(|(at, _)| *at > depth_m)?;
    let [from, to] = [curve.get(below.checked_sub(1)?)?, &curve[below]];
    let value = from.1 + (to.1 - from.1) * (depth_m - from.0) / (to.0 - from.0);
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_two_depths_on_a_line() {
        let curve = [(500.0, 100.0), (1000.0, 200.0), (1500.0, f64::NAN)];
        assert_eq!(between(&curve, 750.0), Some(150.0));
        assert_eq!(between(&curve, 1000.0), Some(200.0));
        for without in [499.0, 1250.0, 1500.0, 1501.0] {
            assert_eq!(between(&curve, without), None, "{without}");
        }
        assert_eq!(between(&[], 1.0), None);
    }
}
