//! Tables and charts as an Excel workbook.

mod chart;
mod sheet;

pub use chart::{WorkbookChart, WorkbookSeries};
pub use sheet::{Cells, Sheet, SheetColumn};

use rust_xlsxwriter::{Workbook as File, XlsxError};

/// A workbook: a sheet for each table, and one with all charts, first.
#[derive(Debug, Clone, PartialEq)]
pub struct Workbook {
    /// What it is called.
    pub title: String,
    /// What stands over the charts, line by line.
    pub about: Vec<String>,
    /// Charts, from left to right, two a line.
    pub charts: Vec<WorkbookChart>,
    /// Tables.
    pub sheets: Vec<Sheet>,
}

/// Why a workbook cannot be made.
#[derive(Debug)]
pub struct WorkbookError(XlsxError);

impl std::fmt::Display for WorkbookError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the workbook cannot be made: {}", self.0)
    }
}

impl std::error::Error for WorkbookError {}

impl From<XlsxError> for WorkbookError {
    fn from(error: XlsxError) -> Self {
        Self(error)
    }
}

impl Workbook {
    /// The file's bytes.
    ///
    /// # Errors
    /// More rows than a sheet has, or a text longer than a cell takes.
    pub fn bytes(&self) -> Result<Vec<u8>, WorkbookError> {
        let mut file = File::new();
        if !self.charts.is_empty() {
            chart::write(file.add_worksheet(), &self.title, &self.about, &self.charts)?;
        }
        for sheet in &self.sheets {
            sheet::write(file.add_worksheet(), sheet)?;
        }
        sheet::write_meanings(file.add_worksheet(), &self.sheets)?;
        Ok(file.save_to_buffer()?)
    }
}

#[cfg(test)]
mod tests;
