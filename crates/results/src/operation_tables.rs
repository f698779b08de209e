//! Tables of a run, operation by operation.

use std::path::{Path, PathBuf};

use wholestring::{operation::OperationKind, outcome::ModelKind};

use crate::{ResultsError, Table, parquet_file::read_groups_with};

/// The tables of a run in its folder. They are large and are read operation by operation.
#[derive(Debug, Clone)]
pub struct OperationTables {
    folder: PathBuf,
}

impl OperationTables {
    /// The tables in a folder.
    pub fn of_folder(folder: &Path) -> Self {
        Self { folder: folder.to_owned() }
    }

    /// The rows of a table for an operation, and for a model if the table distinguishes models;
    /// without columns if the file has none, or does not exist.
    ///
    /// # Errors
    /// A file that cannot be read, or is damaged.
    pub fn read(
        &self,
        name: &str,
        model: Option<ModelKind>,
        operation: OperationKind,
    ) -> Result<Table, ResultsError> {
        let mut found: Option<Table> = None;
        self.pieces(name, (model, operation), None, |piece| match &mut found {
            None => found = Some(piece),
            Some(found) => found.extend(piece),
        })?;
        Ok(found.unwrap_or_else(|| Table::new(Vec::new())))
    }

    /// Checks that each row of a table names an operation: rows of no known one belong to none that
    /// is read.
    ///
    /// # Errors
    /// The first row that names none, and those of [`OperationTables::read`].
    pub fn check_operations(&self, name: &str) -> Result<(), ResultsError> {
        let path = self.folder.join(format!("{name}.parquet"));
        if !path.is_file() {
            return Ok(());
        }
        let table = Table::read_parquet(&path)?;
        let Some(names) = table.words("operation") else {
            return Err(ResultsError::format(&path, "it has no column 'operation'"));
        };
        match (1..).zip(names).find(|(_, name)| OperationKind::from_name(name).is_none()) {
            Some((row, name)) => {
                Err(ResultsError::format(&path, format!("'{name}' in row {row} is no operation")))
            }
            None => Ok(()),
        }
    }

    /// Calls `take` with the same rows, piece by piece, because together they may be larger than
    /// memory. The pieces have the columns that are named, or all.
    ///
    /// # Errors
    /// Those of [`OperationTables::read`].
    pub fn pieces(
        &self,
        name: &str,
        (model, operation): (Option<ModelKind>, OperationKind),
        columns: Option<&[&str]>,
        mut take: impl FnMut(Table),
    ) -> Result<(), ResultsError> {
        let path = self.folder.join(format!("{name}.parquet"));
        if !path.is_file() {
            return Ok(());
        }
        let columns = columns.map(|columns| [columns, &["model"]].concat());
        let columns = columns.as_deref();
        read_groups_with(&path, ("operation", operation.name()), columns, |piece| {
            let models = piece.words("model").zip(model);
            let is_of = |row: usize| models.is_none_or(|(all, model)| all[row] == model.name());
            let operations = piece.words("operation").unwrap_or_default().iter().enumerate();
            let keep: Vec<bool> =
                operations.map(|(row, name)| name == operation.name() && is_of(row)).collect();
            take(piece.filtered(&keep));
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Column;

    #[test]
    fn a_name_of_no_operation_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let tables = OperationTables::of_folder(folder.path());
        assert!(tables.check_operations("spectra").is_ok(), "no such file");
        let write = |names: [&str; 2]| {
            let names = names.map(str::to_owned).to_vec();
            let table = Table::new(vec![Column::words("operation", names)]);
            table.write_parquet(&folder.path().join("spectra.parquet")).unwrap();
        };
        write(["drill", "trip_out"]);
        assert!(tables.check_operations("spectra").is_ok());
        write(["drill", "trip"]);
        let error = tables.check_operations("spectra").expect_err("no operation").to_string();
        assert!(error.contains("spectra.parquet"), "{error}");
        assert!(error.contains("'trip' in row 2 is no operation"), "{error}");
    }

    /// Rows of one operation and one model, whole and in pieces of some columns.
    #[test]
    fn rows_are_those_of_the_operation() {
        let folder = tempfile::tempdir().unwrap();
        let words = |words: [&str; 3]| words.map(str::to_owned).to_vec();
        let table = Table::new(vec![
            Column::words("model", words(["soft", "stiff", "soft"])),
            Column::words("operation", words(["drill", "drill", "trip_out"])),
            Column::numbers("md_m", vec![Some(1.0), Some(2.0), Some(3.0)]),
            Column::numbers("tension_N", vec![None; 3]),
        ]);
        table.write_parquet(&folder.path().join("nodes.parquet")).unwrap();
        let tables = OperationTables::of_folder(folder.path());
        let depths =
            |model, operation| tables.read("nodes", model, operation).unwrap().values("md_m");
        let (drill, soft) = (OperationKind::Drill, Some(ModelKind::Soft));
        assert_eq!(depths(None, drill), [1.0, 2.0]);
        assert_eq!(depths(soft, drill), [1.0]);
        assert_eq!(depths(soft, OperationKind::TripOut), [3.0]);
        assert!(depths(soft, OperationKind::TripIn).is_empty());
        let mut pieces = 0;
        let take = |piece: Table| {
            pieces += 1;
            assert_eq!(piece.numbers("tension_N"), None, "it is not named");
            assert_eq!(piece.values("md_m"), [1.0, 2.0]);
        };
        tables.pieces("nodes", (None, drill), Some(&["md_m"]), take).unwrap();
        assert_eq!(pieces, 1);
        assert_eq!(tables.read("time", None, drill).unwrap().rows(), 0, "no such file");
    }
}
