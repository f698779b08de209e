//! Tables of numbers: the results of every model, and the numerical settings.

use wholestring::outcome::{QuantityKind, Scalar, scalars_by_row};
use wholestring_results::{OperationSummary, Summary};

use crate::{Cell, PageTable, Place};

/// A row: label, dimension, and the function that reads its value.
type Row<'a> = (&'a str, &'a str, &'a dyn Fn(&OperationSummary) -> Option<f64>);

/// Results of all models and operations in one table, then numerical settings and cost of the
/// dynamic solutions.
pub(super) fn page_tables(summary: &Summary) -> Vec<PageTable> {
    std::iter::once(results(summary)).chain(numerics(summary)).collect()
}

fn results(summary: &Summary) -> PageTable {
    let block_N = summary.settings["rig"]["block_weight_N"].as_f64();
    let block_N = block_N.filter(|weight| *weight > 0.0);
    let solved: Vec<&OperationSummary> = summary.operations.iter().collect();
    let mut page_table = side_by_side(Place::Results, "All models and operations", &solved);
    let mut row = |label: &str, scalar: &Scalar, more: f64| {
        let quantity = scalar.quantity;
        let cells = summary.operations.iter().map(|operation| {
            let spread = operation.statistics.as_ref();
            let spread = spread.and_then(|all| all.get(quantity.name));
            match (scalar.of)(&operation.scalars).filter(|value| value.is_finite()) {
                Some(value) => Cell::Quantity {
                    value: value + more,
                    dimension: scalar_dimension(quantity.kind).into(),
                    std: spread.map(|spread| spread.std).filter(|std| std.is_finite()),
                },
                None => Cell::Nothing,
            }
        });
        page_table.rows.push(named(label, cells));
    };
    for scalar in scalars_by_row() {
        row(scalar.label, scalar, 0.0);
        if let (Some(block_N), "hook_load_N") = (block_N, scalar.quantity.name) {
            row("Hook load with block", scalar, block_N);
        }
    }
    let pump_Pa = |summary: &OperationSummary| Some(summary.hydraulics?.pump_pressure_Pa);
    let stick = |summary: &OperationSummary| summary.indicators.and_then(|all| all.stick_slip);
    let more: &[Row<'_>] = &[
        ("Stick-slip severity", "ratio", &|answer| stick(answer)?.severity),
        ("Bit stuck", "percent", &|answer| Some(stick(answer)?.stuck_fraction)),
        ("Fastest turn of the bit", "rotary speed", &|answer| {
            Some(stick(answer)?.bit_speed_max_rad_per_s)
        }),
        ("Stick-slip period", "time", &|answer| stick(answer)?.period_s),
        ("Backward whirl", "rotary speed", &|answer| {
            Some(answer.indicators?.backward_whirl?.rate_rad_per_s)
        }),
        ("Forward whirl", "rotary speed", &|answer| {
            Some(answer.indicators?.forward_whirl?.rate_rad_per_s)
        }),
        ("Use of the top drive, largest", "percent", &|answer| {
            Some(answer.indicators?.top_drive?.max)
        }),
        ("Drag of the mud", "force", &|answer| Some(answer.hydraulics?.mud_drag_N)),
        ("Torque of the mud", "torque", &|answer| Some(answer.hydraulics?.mud_torque_N_m)),
        ("Pump pressure", "pressure", &|answer| pump_Pa(answer).filter(|pump_Pa| *pump_Pa >= 0.0)),
        // A string that is pulled with its pumps off draws mud into the space below it.
        ("Swab below the bit", "pressure", &|answer| {
            pump_Pa(answer).filter(|pump_Pa| *pump_Pa < 0.0)
        }),
    ];
    add(&mut page_table, more, &solved);
    page_table
}

/// Dimension of a scalar on the page; turns are shown instead of degrees for the string.
fn scalar_dimension(kind: QuantityKind) -> &'static str {
    match kind {
        QuantityKind::Angle => "turns",
        kind => kind.dimension(),
    }
}

fn numerics(summary: &Summary) -> Option<PageTable> {
    let solved = summary.operations.iter().filter(|operation| operation.numerics.is_some());
    let solved: Vec<&OperationSummary> = solved.collect();
    if solved.is_empty() {
        return None;
    }
    let mut page_table =
        side_by_side(Place::Numerics, "Numerical settings and cost of the dynamics", &solved);
    let numerics = |summary: &OperationSummary| summary.numerics.clone();
    let run = |summary: &OperationSummary| summary.numerics.as_ref().map(|all| all.run.clone());
    let energy = |summary: &OperationSummary| run(summary)?.energy;
    let rows: &[Row<'_>] = &[
        ("Elements", "ratio", &|answer| Some(run(answer)?.elements as f64)),
        ("Time step", "time step", &|answer| Some(run(answer)?.time_step_s)),
        ("Steps of the assembly in each", "ratio", &|answer| {
            Some(f64::from(run(answer)?.assembly_steps?))
        }),
        ("Steps", "ratio", &|answer| Some(run(answer)?.steps as f64)),
        ("Settled before the window", "time", &|answer| {
            Some(run(answer)?.settle_s).filter(|time_s| time_s.is_finite())
        }),
        ("Axial mass added", "percent", &|answer| Some(run(answer)?.added_axial_mass_fraction)),
        ("Deepest penetration of the wall", "diameter", &|answer| {
            Some(run(answer)?.max_penetration_m)
        }),
        ("Energy residual", "percent", &|answer| Some(run(answer)?.energy_residual)),
        ("Work of top drive, hoist, bit, mud", "energy", &|answer| Some(energy(answer)?.work_J())),
        ("Losses", "energy", &|answer| Some(energy(answer)?.loss_J())),
        ("Lost to friction on the wall", "energy", &|answer| Some(energy(answer)?.friction_loss_J)),
        ("Change of energy", "energy", &|answer| Some(energy(answer)?.change_J())),
        ("Wall-clock time", "time", &|answer| Some(numerics(answer)?.wall_time_s)),
        ("Simulated over wall-clock time", "ratio", &|answer| {
            Some(numerics(answer)?.real_time_factor)
        }),
    ];
    add(&mut page_table, rows, &solved);
    let instructions = solved
        .iter()
        .map(|solved| run(solved).map_or(Cell::Nothing, |run| Cell::Text(run.instructions.into())));
    page_table.rows.push(named("Instruction set", instructions));
    Some(page_table)
}

/// A table with a column for each model and operation.
fn side_by_side(place: Place, title: &str, solved: &[&OperationSummary]) -> PageTable {
    let head = |summary: &&OperationSummary| {
        format!("{}, {}", summary.operation, summary.model.method().long_name)
    };
    PageTable {
        place,
        title: title.into(),
        heads: std::iter::once(String::new()).chain(solved.iter().map(head)).collect(),
        rows: Vec::new(),
    }
}

/// Adds the rows with at least one value.
fn add(page_table: &mut PageTable, rows: &[Row<'_>], solved: &[&OperationSummary]) {
    for (label, dimension, value) in rows {
        let cells: Vec<Cell> = solved
            .iter()
            .map(|solved| {
                value(solved).map_or(Cell::Nothing, |value| Cell::quantity(value, dimension))
            })
            .collect();
        if cells.iter().any(|cell| *cell != Cell::Nothing) {
            page_table.rows.push(named(label, cells));
        }
    }
}

fn named(label: &str, cells: impl IntoIterator<Item = Cell>) -> Vec<Cell> {
    std::iter::once(Cell::Text(label.into())).chain(cells).collect()
}
