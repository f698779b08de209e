//! Curves against depth, to be drawn over those of other results.

use std::{fs, path::Path};

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::{
    operation::OperationKind,
    outcome::{PROFILE, QuantityKind},
    well::FrictionLevel,
};
use wholestring_results::{PlanSummary, Table};
use wholestring_runner::checks::quantities::{shown, symbol};
use wholestring_screens::answers::{Column, DRAWN};
use wholestring_units::UnitSet;

/// Maximum size of a table that is drawn, bytes.
const LARGEST: u64 = 64 << 20;

/// A curve against depth.
#[derive(Debug, Serialize, ToSchema)]
pub(crate) struct Curve {
    /// Index of its result, from 0.
    pub(super) result: usize,
    /// Its operation and model: `trip out (soft)`.
    pub(super) of: String,
    /// Its quantity: `Effective tension`.
    quantity: String,
    /// The symbol of its unit.
    unit: String,
    /// The symbol of the unit of the depths.
    depth_unit: String,
    /// The kind of depth: `Measured depth`, `Depth of the bit`.
    against: &'static str,
    depth: Column,
    value: Column,
}

/// All curves of a result.
pub(super) fn curves(folder: &Path, result: usize, units: UnitSet) -> Vec<Curve> {
    if let Ok(plan) = PlanSummary::read(&folder.join("summary.json")) {
        return of_plan(&plan, result, units);
    }
    let path = folder.join("nodes.parquet");
    if fs::metadata(&path).is_ok_and(|about| about.len() <= LARGEST)
        && let Ok(nodes) = Table::read_parquet(&path)
    {
        return of_nodes(&nodes, result, units);
    }
    Vec::new()
}

fn depths(si: impl Iterator<Item = f64>, units: UnitSet) -> (String, Column) {
    let kind = QuantityKind::Depth;
    (symbol(kind, units).to_owned(), si.map(|si| shown(kind, si, units)).collect())
}

fn of_nodes(nodes: &Table, result: usize, units: UnitSet) -> Vec<Curve> {
    let (Some(models), Some(operations), Some(md_m)) =
        (nodes.words("model"), nodes.words("operation"), nodes.numbers("md_m"))
    else {
        return Vec::new();
    };
    let mut curves = Vec::new();
    let mut from = 0;
    while from < nodes.rows() {
        let key = (&models[from], &operations[from]);
        let rows = (from..nodes.rows()).take_while(|row| (&models[*row], &operations[*row]) == key);
        let rows = from..from + rows.count();
        let operation = OperationKind::from_name(key.1);
        let words = operation.map_or(key.1.as_str(), |operation| operation.words());
        let subject = format!("{words} ({})", key.0);
        for quantity in PROFILE.iter().map(|column| column.quantity) {
            let numbers = match nodes.numbers(quantity.name) {
                Some(numbers) if DRAWN.contains(&quantity.name) => &numbers[rows.clone()],
                _ => continue,
            };
            let si = numbers.iter().map(|number| number.unwrap_or(f64::NAN));
            let value: Column = si.map(|si| shown(quantity.kind, si, units)).collect();
            if value.is_blank() {
                continue;
            }
            let depth = md_m[rows.clone()].iter().map(|depth| depth.unwrap_or(f64::NAN));
            let (depth_unit, depth) = depths(depth, units);
            curves.push(Curve {
                result,
                of: subject.clone(),
                quantity: quantity.label(),
                unit: symbol(quantity.kind, units).to_owned(),
                depth_unit,
                against: "Measured depth",
                depth,
                value,
            });
        }
        from = rows.end;
    }
    curves
}

fn of_plan(plan: &PlanSummary, result: usize, units: UnitSet) -> Vec<Curve> {
    let mut curves = Vec::new();
    for model in plan.models.iter().copied() {
        for operation in plan.operations.iter().copied() {
            for friction in FrictionLevel::ALL {
                let points: Vec<_> = plan
                    .curve(model, operation, friction)
                    .filter_map(|curve| Some((curve.bit_depth_m, curve.scalars?)))
                    .collect();
                if points.is_empty() {
                    continue;
                }
                let subject = format!("{operation} ({model}), {friction} friction");
                let mut push = |quantity: &str, kind, values: Vec<f64>| {
                    let (depth_unit, depth) = depths(points.iter().map(|point| point.0), units);
                    curves.push(Curve {
                        result,
                        of: subject.clone(),
                        quantity: quantity.to_owned(),
                        unit: symbol(kind, units).to_owned(),
                        depth_unit,
                        against: "Depth of the bit",
                        depth,
                        value: values.into_iter().map(|si| shown(kind, si, units)).collect(),
                    });
                };
                let hook_loads = points.iter().map(|point| point.1.hook_load_N).collect();
                push("Hook load", QuantityKind::Force, hook_loads);
                let torques = points.iter().map(|point| point.1.surface_torque_N_m).collect();
                push("Surface torque", QuantityKind::Torque, torques);
            }
        }
    }
    curves
}
