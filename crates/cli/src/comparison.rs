//! The table at the end of a run: models and operations side by side, in the chosen units.

use wholestring::operation::OperationKind;
use wholestring_results::{Numerics, OperationSummary, Status, Summary};
use wholestring_runner::{ComparedRow, Comparison, Drift, checks::quantities::deviation};
use wholestring_units::{Dimension, UnitSet};

use crate::progress::real_time_factor;

/// Space between columns of one operation, and before the first of the next.
const NARROW: usize = 2;
const WIDE: usize = 4;

/// One column of numbers under its heading.
struct Column {
    operation: OperationKind,
    heading: String,
    /// Whether the same operation already has a column to the left.
    joined: bool,
    cells: Vec<String>,
    width: usize,
}

/// The whole table. Where the operations do not fit in `width` columns of the screen they continue
/// below, with the labels again.
pub(crate) fn table(summary: &Summary, units: UnitSet, width: Option<usize>) -> String {
    let comparison = Comparison::of(summary, units);
    let rows = &comparison.rows;
    let label_width = rows.iter().map(|row| row.label.len()).max().unwrap_or(0);
    let symbol_width = rows.iter().map(|row| row.symbol.len()).max().unwrap_or(0);
    let stub = label_width + NARROW + symbol_width;

    let mut text = String::new();
    for block in blocks(columns(&comparison), stub, width) {
        if !text.is_empty() {
            text.push('\n');
        }
        let line: usize = stub + block.iter().map(Column::full_width).sum::<usize>();
        let mut operations = " ".repeat(stub);
        let mut headings = operations.clone();
        for (index, column) in block.iter().enumerate() {
            if !column.joined {
                // An operation's name is centred over its columns.
                let group = block[index + 1..].iter().take_while(|next| next.joined);
                let across = column.width + group.map(Column::full_width).sum::<usize>();
                operations += &format!("{:WIDE$}{:^across$}", "", column.operation);
            }
            headings += &format!("{:1$}", "", column.gap());
            headings += &format!("{:>1$}", column.heading, column.width);
        }
        text += &format!("{}\n{}\n", operations.trim_end(), headings.trim_end());
        text += &format!("{}\n", "─".repeat(line));
        for (row, ComparedRow { label, symbol, .. }) in rows.iter().enumerate() {
            let mut cells = format!("{label:label_width$}{:NARROW$}{symbol:symbol_width$}", "");
            for column in &block {
                cells += &format!("{:1$}", "", column.gap());
                cells += &format!("{:>1$}", column.cells[row], column.width);
            }
            text += &format!("{}\n", cells.trim_end());
        }
    }
    text
}

/// Notes below the table: incomplete columns, and the cost and numerical quality of the dynamic
/// ones.
pub(crate) fn notes(summary: &Summary, units: UnitSet) -> String {
    let mut notes = String::new();
    let incomplete = |solved: &OperationSummary| solved.status != Status::Complete;
    if summary.operations.iter().any(incomplete) {
        notes += "* as far as it was computed\n";
    }
    for solved in &summary.operations {
        let Some(lift) = solved.lift else { continue };
        notes += &format!(
            "Lift: {} for a mean weight on bit of {}, found in {} runs\n",
            Dimension::Force.format(lift.hook_load_N, units),
            Dimension::Force.format(lift.weight_on_bit_N, units),
            lift.runs,
        );
    }
    let all = || summary.operations.iter().filter_map(|solved| solved.numerics.as_ref());
    if all().next().is_some() {
        let largest = |numerics: fn(&Numerics) -> f64| all().map(numerics).fold(0.0, f64::max);
        let took_s: f64 = all().map(|numerics| numerics.wall_time_s).sum();
        let simulated_s: f64 =
            all().map(|numerics| numerics.real_time_factor * numerics.wall_time_s).sum();
        let shortest_step_s =
            all().map(|numerics| numerics.run.time_step_s).fold(f64::INFINITY, f64::min);
        let parts = largest(|numerics| f64::from(numerics.run.assembly_steps.unwrap_or(1)));
        let within =
            if parts > 1.0 { format!(", {parts} in it of the assembly") } else { String::new() };
        notes += &format!(
            "Dynamics: {} elements, step {:.3} ms{within}, added axial mass {:.2} %; \
             {simulated_s:.1} s simulated in {took_s:.1} s, {}\n",
            largest(|numerics| numerics.run.elements as f64),
            shortest_step_s * 1e3,
            largest(|numerics| numerics.run.added_axial_mass_fraction) * 100.0,
            real_time_factor(simulated_s / took_s),
        );
    }
    notes
}

impl Column {
    fn gap(&self) -> usize {
        if self.joined { NARROW } else { WIDE }
    }

    fn full_width(&self) -> usize {
        self.gap() + self.width
    }
}

/// The columns of every operation and model, with the deviations of the dynamic ones.
fn columns(comparison: &Comparison) -> Vec<Column> {
    let mut columns: Vec<Column> = Vec::new();
    for solved in &comparison.columns {
        let operation = solved.operation;
        let mut push = |heading: String, cells: Vec<String>, across: usize| {
            let joined = columns.last().is_some_and(|last| last.operation == operation);
            let widest = cells.iter().map(|cell| cell.chars().count()).max();
            columns.push(Column {
                width: widest.unwrap_or(0).max(heading_width(&heading)).max(across),
                operation,
                heading,
                joined,
                cells,
            });
        };
        let incomplete = if solved.is_complete { "" } else { "*" };
        let heading = format!("{}{incomplete}", solved.model.name());
        let values = solved.values.iter().zip(&comparison.rows);
        let cells = values.map(|(value, row)| cell(*value, row.decimals));
        // The name of an operation with only one column must fit in that column.
        let all = comparison.columns.iter();
        let alone = all.filter(|other| other.operation == solved.operation);
        let across = if alone.count() == 1 { operation.words().len() } else { 0 };
        push(heading, cells.collect(), across);
        if let Some(deviations) = &solved.deviations {
            let deviations = deviations.iter().map(|spread| match spread {
                Some(spread) => format!("{}{}", deviation(spread.std), mark(spread.drift)),
                None => String::new(),
            });
            push("± std".to_owned(), aligned(deviations.collect()), 0);
        }
    }
    columns
}

fn cell(value: Option<f64>, decimals: usize) -> String {
    let Some(value) = value.filter(|value| value.is_finite()) else {
        return "–".to_owned();
    };
    let text = format!("{value:.decimals$}");
    // A value that rounds to zero has no sign.
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|byte| matches!(byte, b'0' | b'.')) => digits.to_owned(),
        _ => text,
    }
}

fn heading_width(heading: &str) -> usize {
    heading.chars().count()
}

/// Columns in blocks that fit the screen; the columns of an operation stay together.
fn blocks(columns: Vec<Column>, stub: usize, width: Option<usize>) -> Vec<Vec<Column>> {
    let mut groups: Vec<Vec<Column>> = Vec::new();
    for column in columns {
        match groups.last_mut() {
            Some(group) if column.joined => group.push(column),
            _ => groups.push(vec![column]),
        }
    }
    let mut blocks: Vec<Vec<Column>> = Vec::new();
    let mut used = 0;
    for group in groups {
        let needed: usize = group.iter().map(Column::full_width).sum();
        match blocks.last_mut() {
            Some(block) if width.is_none_or(|width| used + needed <= width) => block.extend(group),
            _ => {
                blocks.push(group);
                used = stub;
            }
        }
        used += needed;
    }
    blocks
}

// Marks in the table for means that drift.

/// The mark after the deviation of a drifting quantity.
fn mark(drift: Drift) -> &'static str {
    match drift {
        Drift::None => "",
        Drift::Upwards => " ↗",
        Drift::Downwards => " ↘",
    }
}

/// A column of deviations, padded so that marked and unmarked ones align.
fn aligned(cells: Vec<String>) -> Vec<String> {
    let is_marked = |cell: &String| cell.ends_with(['↗', '↘']);
    if !cells.iter().any(is_marked) {
        return cells;
    }
    let pad = |cell: String| if is_marked(&cell) { cell } else { cell + "  " };
    cells.into_iter().map(pad).collect()
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};
    use wholestring_results::Summary;
    use wholestring_units::UnitSet;

    use super::table;

    /// The table of one operation whose quantities have these deviations and drifts.
    fn screen(spreads: &[(&str, f64, f64, bool)]) -> String {
        let statistics = spreads.iter().map(|(name, std, drift, drifts)| {
            let statistic = json!({
                "mean": 200e3, "std": std, "min": 0.0, "max": 0.0, "p05": 0.0, "p95": 0.0, "std_error": 10.0,
                "drift": drift, "drifts": drifts,
            });
            ((*name).to_owned(), statistic)
        });
        let statistics: serde_json::Map<String, Value> = statistics.collect();
        let solved = json!({
            "model": "dynamic", "operation": "trip_in", "status": "complete", "friction": 0.3, "bit_depth_m": 1000.0,
            "weight_on_bit_N": 0.0, "bit_torque_N_m": 0.0, "hook_load_N": 200e3, "surface_torque_N_m": 0.0,
            "friction_torque_N_m": 0.0, "axial_friction_N": 0.0, "side_force_total_N": 0.0, "twist_rad": 0.0,
            "stretch_m": 0.2, "neutral_point_m": null, "cutoff_depth_m": null, "statistics": statistics,
        });
        let summary = Summary {
            schema_version: wholestring_results::SCHEMA_VERSION,
            engine_version: None,
            identity: None,
            case: "a case".into(),
            settings: Value::Null,
            operations: vec![serde_json::from_value(solved).expect("a summary")],
        };
        table(&summary, UnitSet::Si, None)
    }

    #[test]
    fn what_drifts_is_marked() {
        let screen = screen(&[
            ("hook_load_N", 700.0, -2100.0, true),
            ("axial_friction_N", 700.0, -2000.0, false),
            ("stretch_m", 0.003, 0.01, true),
        ]);
        let row = |label: &str| screen.lines().find(|line| line.starts_with(label)).unwrap();
        assert!(row("Hook load").ends_with("0.70 ↘"), "{screen}");
        assert!(row("Stretch").ends_with("0.0030 ↗"), "{screen}");
        // Digits are aligned.
        assert!(row("Axial friction").ends_with("0.70"), "{screen}");
        let place = |label| row(label).chars().position(|letter| letter == '.');
        assert_eq!(place("Axial friction"), place("Hook load"), "{screen}");
    }

    #[test]
    fn what_stands_still_is_not_marked() {
        let still = screen(&[("hook_load_N", 700.0, 0.0, false)]);
        assert!(!still.contains(['↗', '↘']), "{still}");
    }
}
