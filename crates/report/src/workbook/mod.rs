//! Tables and charts as an Excel workbook.

mod chart;
mod sheet;

pub use chart::{WorkbookChart, WorkbookSeries};
pub use sheet::{Cells, Sheet, SheetColumn};

use rust_xlsxwriter::{Workbook as File, XlsxError};

/// A workbook: sheets to be read first, one with all charts, and a sheet for each table.
#[derive(Debug, Clone, PartialEq)]
pub struct Workbook {
    /// Its title.
    pub title: String,
    /// Text over the charts, line by line.
    pub about: Vec<String>,
    /// Sheets before the charts, printed as a whole.
    pub first: Vec<Sheet>,
    /// Charts, from left to right, two a line.
    pub charts: Vec<WorkbookChart>,
    /// Tables.
    pub sheets: Vec<Sheet>,
    /// Number of printed rows of each table; all where it is `None`.
    pub printed_rows: Option<u32>,
}

/// Error of writing a workbook.
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
    /// More rows than a sheet has, or a text longer than a cell allows.
    pub fn bytes(&self) -> Result<Vec<u8>, WorkbookError> {
        let mut file = File::new();
        for sheet in &self.first {
            sheet::write(file.add_worksheet(), sheet, None)?;
        }
        if !self.charts.is_empty() {
            chart::write(file.add_worksheet(), &self.title, &self.about, &self.charts)?;
        }
        for sheet in &self.sheets {
            sheet::write(file.add_worksheet(), sheet, self.printed_rows)?;
        }
        let all = self.first.iter().chain(&self.sheets);
        sheet::write_meanings(file.add_worksheet(), all)?;
        Ok(file.save_to_buffer()?)
    }
}

#[cfg(test)]
mod tests;
