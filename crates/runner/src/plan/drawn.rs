//! Numbers of each picture of a plan.

use wholestring::{operation::OperationKind, well::FrictionLevel};
use wholestring_results::{
    Column, Data, PlanMeasured, PlanOverlayRow, PlanPoint, PlanSummary, Table, UncertainBand,
};

use crate::picture_table::{Entry, Row, with_lines, with_rows};

/// Curves of another program in rows below the plan's, with a column for each operation.
fn theirs(summary: &PlanSummary, table: Table, quantity: &str, is_torque: bool) -> Table {
    let first = |row: &&PlanOverlayRow| {
        summary.models.first() == Some(&row.model) && row.is_torque == is_torque
    };
    let rows: Vec<&PlanOverlayRow> =
        summary.overlay.iter().flat_map(|overlay| &overlay.rows).filter(first).collect();
    if rows.is_empty() {
        return table;
    }
    let above = table.rows();
    let mut columns = table.columns().to_vec();
    for column in &mut columns {
        let is_depth = column.name == "bit_depth_m";
        if let Data::Number(values) = &mut column.data {
            values.extend(rows.iter().map(|row| is_depth.then_some(row.bit_depth_m)));
        }
    }
    for operation in &summary.operations {
        let of_operation = |row: &&PlanOverlayRow| row.operation == *operation;
        if rows.iter().any(of_operation) {
            let mut values = vec![None; above];
            values.extend(rows.iter().map(|row| of_operation(row).then_some(row.theirs)));
            columns
                .push(Column::numbers(format!("{}_overlay_{quantity}", operation.name()), values));
        }
    }
    Table::new(columns)
}

/// Limits of a picture next to its curves, a column for each, equal at every depth.
fn with_limits(summary: &PlanSummary, table: &Table, quantity: &str, is_torque: bool) -> Table {
    let limits =
        summary.surface_limits.iter().filter(|surface_limit| surface_limit.is_torque == is_torque);
    let lines = limits.map(|limit| (format!("{}_limit_{quantity}", limit.kind), limit.allowed));
    with_lines(table, &lines.collect::<Vec<_>>())
}

/// The mud at rest and the limit of the pump next to the curves of the mud.
pub(super) fn with_mud(summary: &PlanSummary, table: &Table) -> Table {
    let mud_kg_per_m3 = summary.mud_density_kg_per_m3().unwrap_or(f64::NAN);
    let mut lines = vec![("mud_density_kg_per_m3".to_owned(), mud_kg_per_m3)];
    let pump_Pa = summary.pump_pressure_limit_Pa();
    lines.extend(pump_Pa.map(|pump_Pa| ("pump_limit_standpipe_pressure_Pa".to_owned(), pump_Pa)));
    with_lines(table, &lines)
}

/// Time histories of the events, followed by a row for each marked peak and for each pressure that
/// breaks the gel. The limits of hook load, torque and pump are columns in all rows.
pub(super) fn with_peaks(summary: &PlanSummary, table: &Table) -> Table {
    let mut rows: Vec<Row<'_>> = Vec::new();
    for event in &summary.peaks {
        let mut row = |name: &'static str, time_s: f64, value: f64| {
            rows.push(vec![
                ("event", Entry::Word(event.event.clone())),
                ("friction", Entry::Word(event.friction.name().to_owned())),
                ("bit_depth_m", Entry::Number(event.bit_depth_m)),
                ("time_s", Entry::Number(time_s)),
                (name, Entry::Number(value)),
            ]);
        };
        let peaks = [
            ("peak_hook_load_N", event.hook_load_N),
            ("peak_surface_torque_N_m", event.surface_torque_N_m),
            ("peak_pump_pressure_Pa", event.pump_pressure_Pa),
        ];
        for (name, peak) in peaks.into_iter().filter_map(|(name, peak)| Some((name, peak?))) {
            row(name, peak.time_s, peak.peak);
        }
        if let Some(gel) = event.gel {
            row("gel_pump_pressure_Pa", f64::NAN, gel.bore_Pa + gel.annulus_Pa);
        }
    }
    let table = with_rows(table, &rows);
    let pump_Pa = summary.pump_pressure_limit_Pa();
    let pump_Pa = pump_Pa.map(|pump_Pa| ("pump_limit_pump_pressure_Pa".to_owned(), pump_Pa));
    let table = with_lines(&table, &Vec::from_iter(pump_Pa));
    let table = with_limits(summary, &table, "hook_load_N", false);
    with_limits(summary, &table, "surface_torque_N_m", true)
}

/// Data of each picture, with a column for each curve.
pub(super) fn pictures(summary: &PlanSummary) -> [(&'static str, Table); 3] {
    // One row per reading, below the rows of the curves.
    let first = |measured: &&PlanMeasured| summary.models.first() == Some(&measured.model);
    let read: Vec<&PlanMeasured> = summary.measured.iter().filter(first).collect();
    let depth = |read: &[&PlanMeasured]| {
        let depths = summary
            .bit_depths_m
            .iter()
            .copied()
            .chain(read.iter().map(|reading| reading.bit_depth_m));
        Column::numbers("bit_depth_m", depths.map(Some).collect())
    };
    let at = |depth_m: f64, found: Option<f64>| (depth_m, found);
    let column = |name: String, found: &[(f64, Option<f64>)]| {
        let value = |depth: &f64| found.iter().find(|(at, _)| at == depth)?.1;
        Column::numbers(name, summary.bit_depths_m.iter().map(value).collect())
    };
    let curves = |quantity: &str, is_torque: bool, point: fn(&PlanPoint) -> Option<f64>| {
        let mut columns = vec![depth(&[])];
        for model in &summary.models {
            for operation in &summary.operations {
                for level in FrictionLevel::ALL {
                    let points = summary.curve(*model, *operation, level);
                    let found: Vec<_> = points.map(|one| at(one.bit_depth_m, point(one))).collect();
                    let name = format!("{}_{level}_{model}_{quantity}", operation.name());
                    columns.push(column(name, &found));
                }
            }
        }
        let read: Vec<_> =
            read.iter().filter(|reading| reading.is_torque == is_torque).copied().collect();
        if read.is_empty() {
            return Table::new(columns);
        }
        columns[0] = depth(&read);
        for column in &mut columns[1..] {
            if let Data::Number(values) = &mut column.data {
                values.resize(values.len() + read.len(), None);
            }
        }
        for operation in &summary.operations {
            let mut values = vec![None; summary.bit_depths_m.len()];
            let of_operation = |measured: &&PlanMeasured| measured.operation == *operation;
            values.extend(
                read.iter().map(|reading| of_operation(reading).then(|| reading.beside_curves())),
            );
            columns
                .push(Column::numbers(format!("{}_measured_{quantity}", operation.name()), values));
        }
        Table::new(columns)
    };
    let bands = |table: Table, quantity: &str| {
        let (unit, is_torque) = if quantity == "hook_load" { ("N", false) } else { ("N_m", true) };
        let table = with_limits(summary, &table, &format!("{quantity}_{unit}"), is_torque);
        let mut columns = table.columns().to_vec();
        let rows = table.rows();
        let uncertain = summary.uncertain.iter();
        let bands: Vec<&UncertainBand> = uncertain.flat_map(|uncertain| &uncertain.bands).collect();
        for operation in &summary.operations {
            let operation_bands = bands
                .iter()
                .filter(|band| band.quantity == quantity && band.operation == Some(*operation));
            for (place, part) in [(0, "p05"), (2, "p50"), (4, "p95")] {
                let found = operation_bands
                    .clone()
                    .filter_map(|band| Some((band.bit_depth_m?, Some(band.quantiles[place]))));
                let found: Vec<_> = found.collect();
                if !found.is_empty() {
                    let name = format!("{}_{part}_{quantity}_{unit}", operation.name());
                    let mut band = column(name, &found);
                    // Readings are below the rows of the curves.
                    if let Data::Number(values) = &mut band.data {
                        values.resize(rows, None);
                    }
                    columns.push(band);
                }
            }
        }
        Table::new(columns)
    };
    let mut weights = vec![depth(&[])];
    for operation in [OperationKind::Drill, OperationKind::Slide] {
        for level in FrictionLevel::ALL {
            let rows = summary.buckling.iter();
            let rows = rows.filter(|row| row.operation == operation && row.friction == level);
            let rows: Vec<_> = rows.collect();
            for shape in ["sinusoidal", "helical"] {
                let found: Vec<_> = rows
                    .iter()
                    .map(|row| match shape {
                        "sinusoidal" => at(row.bit_depth_m, row.sinusoidal_weight_N),
                        _ => at(row.bit_depth_m, row.helical_weight_N),
                    })
                    .collect();
                let name = format!("{}_{level}_{shape}_weight_N", operation.name());
                weights.push(column(name, &found));
            }
        }
    }
    // The case's weight on bit while drilling.
    let of_case = summary.weight_on_bit_N().filter(|weight_N| *weight_N > 0.0);
    let of_case: Vec<_> =
        of_case.map(|weight_N| ("case_weight_on_bit_N".to_owned(), weight_N)).into_iter().collect();
    [
        (
            "hook_load",
            bands(
                theirs(
                    summary,
                    curves("hook_load_N", false, |point| Some(point.scalars?.hook_load_N)),
                    "hook_load_N",
                    false,
                ),
                "hook_load",
            ),
        ),
        (
            "torque",
            bands(
                theirs(
                    summary,
                    curves("surface_torque_N_m", true, |point| {
                        Some(point.scalars?.surface_torque_N_m)
                    }),
                    "surface_torque_N_m",
                    true,
                ),
                "surface_torque",
            ),
        ),
        ("buckling_weight", with_lines(&Table::new(weights), &of_case)),
    ]
}
