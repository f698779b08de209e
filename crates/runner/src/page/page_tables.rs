//! Tables of numbers: the results of every model, and how they were computed.

use wholestring::outcome::{QuantityKind, Scalar, scalars_by_row};
use wholestring_report::{Cell, PageTable, Place};
use wholestring_results::{OperationSummary, Summary};

use super::facts::readable;

/// A row: what it is, its dimension, and how it is read.
type Row<'a> = (&'a str, &'a str, &'a dyn Fn(&OperationSummary) -> Option<f64>);

/// Results of all models and operations side by side.
pub(super) fn results(summary: &Summary) -> Vec<PageTable> {
    let block_N = summary.settings["rig"]["block_weight_N"].as_f64();
    let block_N = block_N.filter(|weight| *weight > 0.0);
    let mut page_table =
        side_by_side(Place::Results, "All models and operations", &summary.operations);
    let mut row = |label: &str, scalar: &Scalar, more: f64| {
        let quantity = scalar.quantity;
        let cells = summary.operations.iter().map(|of| {
            let spread = of.statistics.as_ref();
            let spread = spread.and_then(|all| all.get(quantity.name));
            match (scalar.of)(&of.scalars).filter(|value| value.is_finite()) {
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
    let pump_Pa = |of: &OperationSummary| Some(of.hydraulics?.pump_pressure_Pa);
    let stick = |of: &OperationSummary| of.indicators.and_then(|all| all.stick_slip);
    let more: &[Row<'_>] = &[
        ("Stick-slip severity", "ratio", &|of| stick(of)?.severity),
        ("Bit stuck", "percent", &|of| Some(stick(of)?.stuck_fraction)),
        ("Fastest turn of the bit", "rotary speed", &|of| Some(stick(of)?.bit_speed_max_rad_per_s)),
        ("Stick-slip period", "time", &|of| stick(of)?.period_s),
        ("Backward whirl", "rotary speed", &|of| {
            Some(of.indicators?.backward_whirl?.rate_rad_per_s)
        }),
        ("Forward whirl", "rotary speed", &|of| Some(of.indicators?.forward_whirl?.rate_rad_per_s)),
        ("Use of the top drive, largest", "percent", &|of| Some(of.indicators?.top_drive?.max)),
        ("Drag of the mud", "force", &|of| Some(of.hydraulics?.mud_drag_N)),
        ("Torque of the mud", "torque", &|of| Some(of.hydraulics?.mud_torque_N_m)),
        ("Pump pressure", "pressure", &|of| pump_Pa(of).filter(|pump_Pa| *pump_Pa >= 0.0)),
        // A string that is pulled with its pumps off draws mud after it.
        ("Swab below the bit", "pressure", &|of| pump_Pa(of).filter(|pump_Pa| *pump_Pa < 0.0)),
    ];
    add(&mut page_table, more, &summary.operations);
    vec![page_table]
}

/// The dimension of a scalar on the page: turns of the string say more than degrees.
fn scalar_dimension(kind: QuantityKind) -> &'static str {
    match kind {
        QuantityKind::Angle => "turns",
        kind => kind.dimension(),
    }
}

/// How the dynamic solutions were computed.
pub(super) fn numerics(summary: &Summary) -> Vec<PageTable> {
    let solved: Vec<OperationSummary> =
        summary.operations.iter().filter(|of| of.numerics.is_some()).cloned().collect();
    if solved.is_empty() {
        return Vec::new();
    }
    let mut page_table = side_by_side(Place::Numerics, "How the dynamics were computed", &solved);
    let numerics = |of: &OperationSummary| of.numerics.clone();
    let run = |of: &OperationSummary| of.numerics.as_ref().map(|all| all.run.clone());
    let energy = |of: &OperationSummary| run(of)?.energy;
    let rows: &[Row<'_>] = &[
        ("Elements", "ratio", &|of| Some(run(of)?.elements as f64)),
        ("Time step", "time step", &|of| Some(run(of)?.time_step_s)),
        ("Steps of the assembly in each", "ratio", &|of| Some(f64::from(run(of)?.assembly_steps?))),
        ("Steps", "ratio", &|of| Some(run(of)?.steps as f64)),
        ("Settled before the window", "time", &|of| {
            Some(run(of)?.settle_s).filter(|of| of.is_finite())
        }),
        ("Axial mass added", "percent", &|of| Some(run(of)?.added_axial_mass_fraction)),
        ("Deepest penetration of the wall", "diameter", &|of| Some(run(of)?.max_penetration_m)),
        ("Energy residual", "percent", &|of| Some(run(of)?.energy_residual)),
        ("Work of top drive, hoist, bit, mud", "energy", &|of| Some(energy(of)?.work_J())),
        ("Losses", "energy", &|of| Some(energy(of)?.loss_J())),
        ("Lost to friction on the wall", "energy", &|of| Some(energy(of)?.friction_loss_J)),
        ("Change of energy", "energy", &|of| Some(energy(of)?.change_J())),
        ("Time that it took", "time", &|of| Some(numerics(of)?.wall_time_s)),
        ("Simulated time over that", "ratio", &|of| Some(numerics(of)?.real_time_factor)),
    ];
    add(&mut page_table, rows, &solved);
    let instructions = solved
        .iter()
        .map(|of| run(of).map_or(Cell::Nothing, |of| Cell::Text(of.instructions.into())));
    page_table.rows.push(named("Instruction set", instructions));
    vec![page_table]
}

/// A table with a column for each model and operation.
fn side_by_side(place: Place, title: &str, solved: &[OperationSummary]) -> PageTable {
    let head = |of: &OperationSummary| {
        format!("{}, {}", readable(&of.operation), of.model.method().long_name)
    };
    PageTable {
        place,
        title: title.into(),
        heads: std::iter::once(String::new()).chain(solved.iter().map(head)).collect(),
        rows: Vec::new(),
    }
}

/// Adds the rows that hold anything.
fn add(page_table: &mut PageTable, rows: &[Row<'_>], solved: &[OperationSummary]) {
    for (label, dimension, value) in rows {
        let cells: Vec<Cell> = solved
            .iter()
            .map(|of| value(of).map_or(Cell::Nothing, |value| Cell::quantity(value, dimension)))
            .collect();
        if cells.iter().any(|cell| *cell != Cell::Nothing) {
            page_table.rows.push(named(label, cells));
        }
    }
}

fn named(label: &str, cells: impl IntoIterator<Item = Cell>) -> Vec<Cell> {
    std::iter::once(Cell::Text(label.into())).chain(cells).collect()
}
