//! Roadmap of a plan: hook loads and torques of every operation, a row for each depth of the bit.

use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_report::{Cells, Sheet, SheetColumn, pretty_symbol};
use wholestring_results::{PlanPoint, PlanSummary};
use wholestring_units::{Dimension, UnitSet};

/// A row for each depth of each model.
pub(super) fn roadmap_sheet(summary: &PlanSummary, units: UnitSet) -> Sheet {
    let depths_m = &summary.bit_depths_m;
    let rows: Vec<(ModelKind, f64)> = summary
        .models
        .iter()
        .copied()
        .flat_map(|model| depths_m.iter().map(move |depth_m| (model, *depth_m)))
        .collect();
    let length = Dimension::Length.unit_in(units);
    let mut columns = vec![SheetColumn {
        heading: "bit depth".to_owned(),
        unit: length.symbol.to_owned(),
        meaning: "Measured depth of the bit".to_owned(),
        cells: Cells::Numbers(rows.iter().map(|row| Some(length.from_si(row.1))).collect()),
    }];
    if summary.models.len() > 1 {
        columns.insert(
            0,
            SheetColumn {
                heading: "model".to_owned(),
                unit: String::new(),
                meaning: "The model that found it".to_owned(),
                cells: Cells::Words(rows.iter().map(|row| row.0.name().to_owned()).collect()),
            },
        );
    }
    let mut add = |operation: OperationKind,
                   what: &str,
                   dimension: Dimension,
                   quantity: fn(&PlanPoint) -> Option<f64>| {
        let unit = dimension.unit_in(units);
        for level in FrictionLevel::ALL {
            let value = |(model, depth_m): &(ModelKind, f64)| {
                let mut curve = summary.curve(*model, operation, level);
                let point = curve.find(|point| point.bit_depth_m == *depth_m)?;
                Some(unit.from_si(quantity(point)?))
            };
            columns.push(SheetColumn {
                heading: format!("{operation} {what} {level}"),
                unit: pretty_symbol(unit.symbol),
                meaning: format!(
                    "{} of {operation} with {level} friction; empty without an answer, which is on the \
                     sheet Verdict",
                    if what == "torque" { "Surface torque" } else { "Hook load without block" }
                ),
                cells: Cells::Numbers(rows.iter().map(value).collect()),
            });
        }
    };
    for operation in &summary.operations {
        add(*operation, "hook load", Dimension::Force, |point| Some(point.scalars?.hook_load_N));
    }
    for operation in summary.operations.iter().filter(|operation| operation.rotates()) {
        add(*operation, "torque", Dimension::Torque, |point| {
            Some(point.scalars?.surface_torque_N_m)
        });
    }
    let about = "A row for each depth of the bit: hook load without block and surface torque \
        with low, expected and high friction";
    Sheet { name: "Roadmap".to_owned(), about: about.to_owned(), columns }
}
