//! A folder with the results of a command.

use std::{
    fs,
    path::{Path, PathBuf},
};

use wholestring::outcome::SCALARS;
use wholestring_results::{Column, Data, ResultsError, TABLES, Table};
use wholestring_runner::{check_summary, results_kind};

/// Tables without a Parquet file: of a sweep; of a study, in its folders.
const SWEEP: &str = "sweep";
const OF_STUDY: [&str; 2] = ["figures", "tables"];

/// A folder with the results of a command.
pub(crate) struct Folder {
    pub(crate) path: PathBuf,
    /// Its kind: `a run`, `a plan`, ...
    pub(crate) kind: &'static str,
    /// `summary.json`.
    pub(crate) summary: String,
}

impl Folder {
    /// Reads the results of a command from a folder.
    pub(crate) fn read(path: PathBuf) -> Result<Self, ResultsError> {
        let kind = results_kind(&path).map_err(|error| ResultsError::Format {
            path: path.clone(),
            reason: error.to_string(),
        })?;
        let summary = path.join("summary.json");
        if !summary.is_file() {
            return Ok(Self { path, kind, summary: "{}".to_owned() });
        }
        check_summary(&path)?;
        let text = fs::read_to_string(&summary);
        let text = text.map_err(|source| ResultsError::Read { path: summary, source })?;
        Ok(Self { path, kind, summary: text })
    }

    /// Names of its tables.
    pub(crate) fn tables(&self) -> Vec<String> {
        let is_there = |name: &str| self.path.join(format!("{name}.parquet")).is_file();
        let names = TABLES.iter().map(|(name, _)| *name).filter(|name| is_there(name));
        let mut names: Vec<String> = names.map(str::to_owned).collect();
        names.extend(self.csv(SWEEP).is_file().then(|| SWEEP.to_owned()));
        for folder in OF_STUDY {
            let entries = fs::read_dir(self.path.join(folder)).into_iter().flatten().flatten();
            let of_csv = |entry: fs::DirEntry| {
                let name = entry.file_name().into_string().ok()?;
                Some(format!("{folder}/{}", name.strip_suffix(".csv")?))
            };
            let mut found: Vec<String> = entries.filter_map(of_csv).collect();
            found.sort();
            names.append(&mut found);
        }
        names
    }

    fn csv(&self, name: &str) -> PathBuf {
        self.path.join(format!("{name}.csv"))
    }

    /// One of its tables.
    pub(crate) fn table(&self, name: &str) -> Result<Table, ResultsError> {
        let parquet = self.path.join(format!("{name}.parquet"));
        if parquet.is_file() {
            return Table::read_parquet(&parquet);
        }
        let table = Table::read_csv(&self.csv(name))?;
        Ok(Table::new(table.columns().iter().map(with_numbers).collect()))
    }

    /// Writes the tables as CSV too, into a copy of the folder.
    pub(crate) fn write_csv(&self, to: &Path) -> Result<(), ResultsError> {
        for name in self.tables() {
            let file = to.join(format!("{name}.csv"));
            if !file.is_file() {
                self.table(&name)?.write_csv(&file)?;
            }
        }
        Ok(())
    }
}

/// A text column as numbers if each non-empty value is one.
fn with_numbers(column: &Column) -> Column {
    let Data::Text(words) = &column.data else { return column.clone() };
    let number = |word: &String| match word.is_empty() {
        true => Some(None),
        false => word.parse::<f64>().ok().map(Some),
    };
    let numbers: Option<Vec<Option<f64>>> = words.iter().map(number).collect();
    let some = words.iter().any(|word| !word.is_empty());
    let about =
        SCALARS.iter().map(|scalar| &scalar.quantity).find(|quantity| quantity.name == column.name);
    let [unit, meaning] =
        about.map_or(["", ""], |about| [about.unit, about.meaning]).map(str::to_owned);
    let data = match numbers.filter(|_| some) {
        Some(numbers) => Data::Number(numbers),
        None => column.data.clone(),
    };
    Column { name: column.name.clone(), unit, meaning, data }
}
