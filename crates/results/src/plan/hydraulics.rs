//! The mud of a plan: pressures and equivalent densities against the depth of the bit.

use serde::{Deserialize, Serialize};
use wholestring::operation::OperationKind;

use crate::{PLAN_HYDRAULICS, Table};

/// The mud with the bit at one depth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanHydraulics {
    /// The operation whose pumps run.
    pub operation: OperationKind,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Pressure at the standpipe, Pa.
    pub standpipe_pressure_Pa: f64,
    /// Friction in the bore, Pa.
    pub bore_loss_Pa: f64,
    /// Pressure drop of bit and motor, Pa.
    pub bit_loss_Pa: f64,
    /// Friction in the annulus, Pa.
    pub annulus_loss_Pa: f64,
    /// During the operation.
    pub circulating: PlanDensity,
    /// Running in at the trip speed, no mud in the string.
    pub surge_closed: PlanDensity,
    /// The same with mud that flows up the string.
    pub surge_open: PlanDensity,
    /// Pulling out at the trip speed, no mud in the string.
    pub swab_closed: PlanDensity,
    /// The same with mud that flows down the string.
    pub swab_open: PlanDensity,
}

/// Equivalent densities.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanDensity {
    /// At the deepest casing shoe, kg/m³; none without casing.
    pub shoe_kg_per_m3: Option<f64>,
    /// At the bit, kg/m³.
    pub bit_kg_per_m3: f64,
}

impl PlanHydraulics {
    /// Returns each state of the mud by the prefix of its column names.
    pub fn densities(&self) -> [(&'static str, PlanDensity); 5] {
        [
            ("circulating", self.circulating),
            ("surge_closed", self.surge_closed),
            ("surge_open", self.surge_open),
            ("swab_closed", self.swab_closed),
            ("swab_open", self.swab_open),
        ]
    }
}

/// A row for each depth of the bit.
pub(super) fn table(rows: &[PlanHydraulics]) -> Table {
    let mut table = Table::with_columns(PLAN_HYDRAULICS);
    for row in rows {
        let mut numbers = vec![
            ("bit_depth_m".to_owned(), row.bit_depth_m),
            ("standpipe_pressure_Pa".to_owned(), row.standpipe_pressure_Pa),
            ("bore_loss_Pa".to_owned(), row.bore_loss_Pa),
            ("bit_loss_Pa".to_owned(), row.bit_loss_Pa),
            ("annulus_loss_Pa".to_owned(), row.annulus_loss_Pa),
        ];
        for (name, at) in row.densities() {
            let shoe = at.shoe_kg_per_m3.unwrap_or(f64::NAN);
            numbers.push((format!("{name}_shoe_kg_per_m3"), shoe));
            numbers.push((format!("{name}_bit_kg_per_m3"), at.bit_kg_per_m3));
        }
        let cells: Vec<[f64; 1]> = numbers.iter().map(|(_, value)| [*value]).collect();
        let columns: Vec<(&str, &[f64])> = numbers
            .iter()
            .zip(&cells)
            .map(|((name, _), cell)| (name.as_str(), cell.as_slice()))
            .collect();
        table.append(&[("operation", &[row.operation.name()])], &columns);
    }
    table
}
