//! The table of the errors of each mesh.

use std::fmt::Write as _;

use serde_json::Value;

use super::cases::{CASES, Case, Error, MESHES, MODES, MOTIONS, Quantity, RINGING};
use crate::command::Failure;

const ELEMENTS: &str = "elements";

/// Titles of the table's columns.
pub(super) fn head() -> String {
    let [converged, others @ ..] = MESHES;
    let mut head = format!("| case | | {} |", converged.name);
    let mut line = "|---|---|---|".to_owned();
    for mesh in others {
        let _ = write!(head, " {} |", mesh.name);
        line += "---|";
    }
    format!("{head}\n{line}\n")
}

/// Rows of a case: a list of runs, one for each seed, for each mesh.
pub(super) fn rows(case: &Case, runs: &[Vec<Value>]) -> Result<String, Failure> {
    let elements: Result<Vec<f64>, _> =
        runs.iter().map(|run| mean(run, "/numerics/elements")).collect();
    let mut text = row(case.title, ELEMENTS, elements?.iter().map(f64::to_string));
    for quantity in case.quantities {
        let values: Result<Vec<f64>, _> =
            runs.iter().map(|run| mean(run, quantity.pointer)).collect();
        text += &row("", quantity.label, cells(quantity, &values?));
    }
    Ok(text)
}

/// Rows of natural frequencies, of each mesh an answer.
pub(super) fn frequency_rows(answers: &[Value]) -> Result<String, Failure> {
    let mut text = String::new();
    for (label, [motion, mode]) in frequency_labels() {
        let pointer = format!("/{motion}/{mode}");
        let values: Result<Vec<f64>, _> =
            answers.iter().map(|answer| number(answer, &pointer)).collect();
        let title = if text.is_empty() { ringing_title() } else { String::new() };
        let decimals = [4, 3];
        let quantity =
            Quantity { label: "", pointer: "", scale: 1.0, decimals, error: Error::Percent };
        text += &row(&title, &label, cells(&quantity, &values?));
    }
    Ok(text)
}

/// Checks the rows and columns of a table against those that would be written, regardless of its
/// numbers.
pub(super) fn check(written: &str) -> Result<(), Failure> {
    let stale = |what: &str| {
        let reason =
            format!("the table of accuracy has {what}; run `cargo xtask accuracy --write`");
        Err(Failure::new(reason))
    };
    let Some(rows) = written.trim().strip_prefix(head().trim()) else {
        return stale("other columns");
    };
    let named = rows.trim().lines().map(|row| {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        [1, 2].map(|cell| cells.get(cell).copied().unwrap_or_default().to_owned())
    });
    if named.eq(labels()) { Ok(()) } else { stale("other rows") }
}

/// The first two cells of each row.
fn labels() -> Vec<[String; 2]> {
    let of_cases = CASES.iter().flat_map(|case| {
        let quantities =
            case.quantities.iter().map(|quantity| [String::new(), quantity.label.to_owned()]);
        [[case.title.to_owned(), ELEMENTS.to_owned()]].into_iter().chain(quantities)
    });
    let first = |row: usize| if row == 0 { ringing_title() } else { String::new() };
    let of_frequencies =
        frequency_labels().into_iter().enumerate().map(|(row, (label, _))| [first(row), label]);
    of_cases.chain(of_frequencies).collect()
}

fn ringing_title() -> String {
    let well = RINGING.title.split(',').next().unwrap_or_default();
    format!("{well}, natural frequencies")
}

/// The label of each mode, with its motion and number.
fn frequency_labels() -> Vec<(String, [String; 2])> {
    let modes = |[words, motion]: [&'static str; 2]| {
        (0..MODES).map(move |mode| {
            (format!("{words}, {}, Hz", mode + 1), [motion.to_owned(), mode.to_string()])
        })
    };
    MOTIONS.into_iter().flat_map(modes).collect()
}

/// The converged value, and the errors of the others.
fn cells(quantity: &Quantity, values: &[f64]) -> impl Iterator<Item = String> {
    let [digits, error_digits] = quantity.decimals;
    let converged = values[0];
    values.iter().enumerate().map(move |(mesh, value)| match (mesh, quantity.error) {
        (0, _) => format!("{:.digits$}", quantity.scale * value),
        (_, Error::Percent) => {
            format!("{:+.error_digits$} %", 100.0 * (value - converged) / converged.abs())
        }
        (_, Error::Difference) => {
            format!("{:+.error_digits$}", quantity.scale * (value - converged))
        }
    })
}

fn row(title: &str, label: &str, cells: impl Iterator<Item = String>) -> String {
    let mut text = format!("| {title} | {label} |");
    for cell in cells {
        let _ = write!(text, " {cell} |");
    }
    text + "\n"
}

/// The mean over runs.
fn mean(runs: &[Value], pointer: &str) -> Result<f64, Failure> {
    let mut sum = 0.0;
    for run in runs {
        sum += number(run, pointer)?;
    }
    Ok(sum / runs.len() as f64)
}

fn number(run: &Value, pointer: &str) -> Result<f64, Failure> {
    let value = run.pointer(pointer).and_then(Value::as_f64);
    value.ok_or_else(|| Failure::new(format!("no number `{pointer}` in the results of a run")))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn of(result: Result<String, Failure>) -> String {
        result.unwrap_or_else(|failure| panic!("{}", failure.reason))
    }

    #[test]
    fn errors_are_of_the_converged_run() {
        let case = Case { quantities: &CASES[0].quantities[5..], ..CASES[0] };
        let run =
            |depth_m: f64| json!({ "numerics": { "elements": 3 }, "cutoff_depth_m": depth_m });
        let runs = [vec![run(1000.0), run(1002.0)], vec![run(1002.0), run(1002.5)]];
        let rows = of(rows(&case, &runs));
        assert_eq!(
            rows,
            format!(
                "| {} | elements | 3 | 3 |\n|  | cut-off depth, m | 1001.00 | +1.25 |\n",
                case.title
            )
        );
        let percent = Quantity { error: Error::Percent, ..case.quantities[0] };
        let cells: Vec<String> = cells(&percent, &[-200.0, -201.0]).collect();
        assert_eq!(cells, ["-200.00", "-0.50 %"]);
    }

    #[test]
    fn a_frequency_for_each_mode() {
        let modes = |factor: f64| json!([factor, 2.0 * factor, 3.0 * factor]);
        let answer = |factor: f64| json!({ "axial_Hz": modes(factor), "torsional_Hz": modes(1.0), "lateral_Hz": modes(1.0) });
        let rows = of(frequency_rows(&[answer(1.0), answer(1.01)]));
        assert_eq!(rows.lines().count(), MODES * MOTIONS.len());
        assert!(rows.contains("|  | along the string, 2, Hz | 2.0000 | +1.000 % |\n"), "{rows}");
        assert!(frequency_rows(&[json!({})]).is_err());
    }

    #[test]
    fn a_table_that_lacks_a_row_is_stale() {
        let row = |[title, label]: [String; 2]| format!("| {title} | {label} | 1 |\n");
        let rows: Vec<String> = labels().into_iter().map(row).collect();
        let table = |rows: &[String]| format!("\n{}{}\n", head(), rows.concat());
        assert!(check(&table(&rows)).is_ok());
        assert!(check(&table(&rows[1..])).is_err());
        assert!(check(&table(&rows).replace("coarse", "rough")).is_err());
        assert!(check("").is_err());
    }
}
