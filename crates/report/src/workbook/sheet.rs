//! A table as a sheet.

use rust_xlsxwriter::{Format, FormatAlign, FormatBorder, Worksheet, XlsxError};

/// A table as a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Its name on the tab, 31 letters at most.
    pub name: String,
    /// Meaning of a row, in a sentence.
    pub about: String,
    /// Its columns, all of one length.
    pub columns: Vec<SheetColumn>,
}

/// A column.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetColumn {
    /// Its heading.
    pub heading: String,
    /// Its unit, which is in the heading; empty where it has none.
    pub unit: String,
    /// Its meaning, in a sentence.
    pub meaning: String,
    /// Its cells.
    pub cells: Cells,
}

/// Cells of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Cells {
    /// Numbers, in the column's unit; empty where there is none.
    Numbers(Vec<Option<f64>>),
    /// Words.
    Words(Vec<String>),
}

impl Cells {
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Words(words) => words.len(),
        }
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl SheetColumn {
    /// Heading and unit: `Hook load, kN`.
    pub fn head(&self) -> String {
        match self.unit.as_str() {
            "" => self.heading.clone(),
            unit => format!("{}, {unit}", self.heading),
        }
    }
}

/// First row of numbers: under the heading.
pub(super) const FIRST_ROW: u32 = 1;

fn heading() -> Format {
    let format = Format::new().set_bold().set_text_wrap().set_align(FormatAlign::Bottom);
    format.set_border_bottom(FormatBorder::Thin)
}

/// Width of a column of words, in letters, beyond which they are wrapped.
const WIDEST: usize = 60;

/// Writes a sheet with this many printed rows; all where none is given.
pub(super) fn write(
    on: &mut Worksheet,
    sheet: &Sheet,
    printed_rows: Option<u32>,
) -> Result<(), XlsxError> {
    on.set_name(&sheet.name)?;
    on.set_freeze_panes(FIRST_ROW, 0)?;
    for (place, column) in (0u16..).zip(&sheet.columns) {
        let head = column.head();
        on.write_with_format(0, place, &head, &heading())?;
        let mut widest = head.len().min(14);
        match &column.cells {
            Cells::Numbers(values) => {
                let rows = (FIRST_ROW..).zip(values);
                for (row, value) in rows {
                    if let Some(value) = value.filter(|value| value.is_finite()) {
                        let number = Format::new().set_num_format(digits(value));
                        on.write_number_with_format(row, place, value, &number)?;
                    }
                }
            }
            Cells::Words(words) => {
                let wrapped = Format::new().set_text_wrap().set_align(FormatAlign::Top);
                for (row, word) in (FIRST_ROW..).zip(words) {
                    let letters = word.chars().count();
                    widest = widest.max(letters.min(WIDEST));
                    match letters > WIDEST {
                        true => on.write_string_with_format(row, place, word, &wrapped)?,
                        false => on.write_string(row, place, word)?,
                    };
                }
            }
        }
        on.set_column_width(place, widest as f64 + 2.0)?;
    }
    let rows = sheet.columns.first().map_or(0, |first| first.cells.len());
    if let (Some(last), true) = (sheet.columns.len().checked_sub(1), rows > 0) {
        on.autofilter(0, 0, rows as u32, last as u16)?;
    }
    on.set_landscape().set_print_fit_to_pages(1, 0).set_repeat_rows(0, 0)?;
    let mut footer = "&L&A&RPage &P of &N".to_owned();
    if let (Some(printed), Some(last)) = (printed_rows, sheet.columns.len().checked_sub(1))
        && rows as u32 > printed
    {
        on.set_print_area(0, 0, printed, last as u16)?;
        footer = format!("&L&A: the first {printed} of {rows} rows&RPage &P of &N");
    }
    on.set_footer(footer);
    Ok(())
}

/// Number format: about four digits, which are enough to read; the cell holds all.
fn digits(value: f64) -> &'static str {
    match value.abs() {
        0.0 => "0",
        size if !(1e-3..1e6).contains(&size) => "0.000E+00",
        size if size >= 1e3 => "0",
        size if size >= 1e2 => "0.0",
        size if size >= 1e1 => "0.00",
        _ => "0.000",
    }
}

/// Meaning of a row of each sheet, and of each of its columns.
pub(super) fn write_meanings<'a>(
    on: &mut Worksheet,
    sheets: impl Iterator<Item = &'a Sheet>,
) -> Result<(), XlsxError> {
    on.set_name("Columns")?;
    on.set_freeze_panes(FIRST_ROW, 0)?;
    for (place, head) in (0u16..).zip(["sheet", "column", "unit", "meaning"]) {
        on.write_with_format(0, place, head, &heading())?;
    }
    let of_sheet = |sheet: &Sheet| {
        let rows = sheet.columns.iter();
        let rows =
            rows.map(|row| [&sheet.name, &row.heading, &row.unit, &row.meaning].map(String::clone));
        let first = [sheet.name.clone(), String::new(), String::new(), sheet.about.clone()];
        [first].into_iter().chain(rows).collect::<Vec<_>>()
    };
    let wrapped = Format::new().set_text_wrap().set_align(FormatAlign::Top);
    for (row, texts) in (FIRST_ROW..).zip(sheets.flat_map(of_sheet)) {
        for (place, text) in (0u16..).zip(texts) {
            on.write_string_with_format(row, place, text, &wrapped)?;
        }
    }
    on.set_landscape().set_print_fit_to_pages(1, 0).set_repeat_rows(0, 0)?;
    for (place, width) in (0u16..).zip([18.0, 26.0, 10.0, 100.0]) {
        on.set_column_width(place, width)?;
    }
    Ok(())
}
