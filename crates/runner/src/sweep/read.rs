//! `sweep.csv` as a table, with numeric columns.

use std::path::Path;

use wholestring::outcome::{self, Quantity};
use wholestring_case::{dimension_at, unit_of_key};
use wholestring_results::{Column, Data, ResultsError, Table};
use wholestring_units::Dimension;

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
/// varied. Varied columns are in SI, rotary speeds in rev/min, if all values are numbers of the
/// key's dimension, and as written otherwise; a key that a case leaves as it is has no number;
/// every other column has its unit and meaning.
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

/// Column of a varied key, in the unit of its bare numbers.
fn key(name: &str, words: &[String]) -> Column {
    let unit = unit_of_key(name);
    let dimension = dimension_at(name);
    let number = |word: &String| {
        let (Some(dimension), Some(unit)) = (dimension, unit) else { return word.parse().ok() };
        let bare = || word.parse().ok().filter(|_| dimension == Dimension::RotarySpeed);
        bare().or_else(|| Some(unit.from_si(dimension.parse(word).ok()?)))
    };
    // A case that leaves the key as it is has no value.
    let value = |word: &String| match word.is_empty() {
        true => Some(None),
        false => number(word).map(Some),
    };
    let numbers: Option<Vec<Option<f64>>> = words.iter().map(value).collect();
    let (unit, data) = match numbers {
        Some(numbers) => (unit, Data::Number(numbers)),
        None => (None, Data::Text(words.to_vec())),
    };
    let unit = unit.map_or("", |unit| unit.symbol).to_owned();
    let meaning = "Varied key of the case file.".to_owned();
    Column { name: name.to_owned(), unit, meaning, data }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn column(name: &str, words: &[&str]) -> (String, Data) {
        let words: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
        let column = key(name, &words);
        (column.unit, column.data)
    }

    /// A rotary speed is in rev/min, as its bare number in a case file, with or without its unit.
    #[test]
    fn a_varied_key_has_the_unit_of_its_bare_numbers() {
        let numbers = |values: &[Option<f64>]| Data::Number(values.to_vec());
        for words in [["60 rpm", "1.5 rev/s"], ["60", "90"]] {
            let (unit, Data::Number(speeds)) = column("rpm", &words) else {
                panic!("{words:?} are numbers")
            };
            assert_eq!(unit, "rpm");
            for (speed, expected) in speeds.into_iter().flatten().zip([60.0_f64, 90.0]) {
                assert!((speed - expected).abs() < 1e-12 * expected, "{speed}, {expected}");
            }
        }
        assert_eq!(column("wob", &["50 kN", ""]), ("N".to_owned(), numbers(&[Some(5e4), None])));
        assert_eq!(column("friction", &["0.2"]), (String::new(), numbers(&[Some(0.2)])));
        let written = Data::Text(vec!["soft".to_owned(), "stiff".to_owned()]);
        assert_eq!(column("model", &["soft", "stiff"]), (String::new(), written));
    }
}
