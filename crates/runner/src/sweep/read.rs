//! `sweep.csv` as a table, with numeric columns.

use std::path::Path;

use wholestring::outcome::{self, Quantity};
use wholestring_case::dimension_at;
use wholestring_results::{Column, Data, ResultsError, Table};

use super::{
    indicators::INDICATORS,
    table::{FILE, SCALARS, STATISTICS},
};

/// Text columns with their meanings.
const WORDS: [(&str, &str); 9] = [
    ("model", "The model that solved it."),
    ("operation", "The operation."),
    ("drifting", "The quantities that drift over the window."),
    ("worst_check", "Kind of the most severe check."),
    ("worst_check_sentence", "The most severe check in a sentence."),
    ("worst_check_parts", "The sentence as JSON: texts, and quantities in SI."),
    ("status", "Status: complete, interrupted or failed."),
    ("message", "Why it failed."),
    ("folder", "Name of the case's folder."),
];

/// Numeric columns other than scalars and their statistics: unit and meaning.
const NUMBERS: [(&str, &str, &str); 7] = [
    ("bit_depth_m", "m", "Measured depth of the bit."),
    ("settle_s", "s", "Start of the window of the statistics."),
    ("lift_hook_load_N", "N", "The hook load that the lift is tuned to."),
    ("lift_weight_on_bit_N", "N", "The weight on bit that the tuned lift gives."),
    ("lift_runs", "", "Number of runs to find the lift."),
    ("errors", "", "Checks that are errors."),
    ("warnings", "", "Checks that are warnings."),
];

/// Reads the `sweep.csv` of a folder, and returns the number of its leading columns that were
/// varied. Varied columns are in SI if all values are numbers of the key's dimension, and as
/// written otherwise; every other column has its unit and meaning.
///
/// # Errors
/// A file that does not exist or does not belong to a sweep.
pub fn read(folder: &Path) -> Result<(usize, Table), ResultsError> {
    let path = folder.join(FILE);
    let table = Table::read_csv(&path)?;
    let varied = varied(&path, table.columns())?;
    Ok((varied, described(&table, varied)))
}

/// The table of a sweep with `varied` leading columns of varied keys, with numeric columns, and the
/// unit and the meaning of each column.
pub(super) fn described(table: &Table, varied: usize) -> Table {
    let columns = table.columns().iter().enumerate();
    let columns = columns.map(|(place, column)| match &column.data {
        Data::Text(words) if place < varied => key(&column.name, words),
        Data::Text(words) => answer(&column.name, words),
        Data::Number(_) => {
            let (unit, meaning) = about(&column.name).unwrap_or_default();
            Column { unit: unit.to_owned(), meaning, ..column.clone() }
        }
    });
    Table::new(columns.collect())
}

/// Number of leading columns that were varied.
///
/// # Errors
/// Columns that are not those of a sweep.
pub(super) fn varied(path: &Path, columns: &[Column]) -> Result<usize, ResultsError> {
    // A key may have the name of another column, such as `model`; keys are the leading columns.
    let begins = |rest: &[Column]| {
        let names = rest.iter().map(|column| column.name.as_str());
        names.eq(["model", "operation", SCALARS[0]])
    };
    let varied = columns.windows(3).position(begins).filter(|keys| *keys > 0);
    varied.ok_or_else(|| ResultsError::Format {
        path: path.to_owned(),
        reason: format!(
            "its columns are not those of a sweep: expected the keys that were varied, then \
             model, operation, {}",
            SCALARS[0]
        ),
    })
}

/// Column of a varied key.
fn key(name: &str, words: &[String]) -> Column {
    let dimension = dimension_at(name);
    let number = |word: &String| match dimension {
        Some(dimension) => dimension.parse(word).ok(),
        None => word.parse().ok(),
    };
    let numbers: Option<Vec<f64>> = words.iter().map(number).collect();
    let data = match numbers {
        Some(numbers) => Data::Number(numbers.into_iter().map(Some).collect()),
        None => Data::Text(words.to_vec()),
    };
    let is_number = matches!(data, Data::Number(_));
    let unit = dimension.filter(|_| is_number).map_or("", |dimension| dimension.si_symbol());
    let meaning = "Varied key of the case file.";
    Column { name: name.to_owned(), unit: unit.to_owned(), meaning: meaning.to_owned(), data }
}

/// Column of results.
fn answer(name: &str, words: &[String]) -> Column {
    let name = name.to_owned();
    if let Some((_, meaning)) = WORDS.iter().find(|(column, _)| *column == name) {
        let (unit, meaning) = (String::new(), (*meaning).to_owned());
        return Column { name, unit, meaning, data: Data::Text(words.to_vec()) };
    }
    let (unit, meaning) = about(&name).unwrap_or_default();
    let numbers = words.iter().map(|word| word.parse().ok()).collect();
    Column { name, unit: unit.to_owned(), meaning, data: Data::Number(numbers) }
}

/// Unit and meaning of a numeric column.
fn about(name: &str) -> Option<(&'static str, String)> {
    let declared = NUMBERS.iter().chain(INDICATORS.iter().map(|indicator| &indicator.about));
    if let Some((_, unit, meaning)) = declared.into_iter().find(|(declared, ..)| *declared == name)
    {
        return Some((unit, (*meaning).to_owned()));
    }
    let scalars = outcome::SCALARS.iter().map(|scalar| scalar.quantity);
    let in_time = outcome::TIME_SERIES.iter().map(|series| series.quantity);
    let all: Vec<Quantity> = scalars.chain(in_time).collect();
    if let Some(quantity) = all.iter().find(|quantity| quantity.name == name) {
        return Some((quantity.unit, quantity.meaning.to_owned()));
    }
    STATISTICS.iter().find_map(|statistic| {
        let quantity = name.strip_suffix(statistic)?.strip_suffix('_')?;
        let described = all.iter().find(|described| described.name == quantity)?;
        Some((described.unit, format!("`{statistic}` over the window of: {}", described.meaning)))
    })
}
