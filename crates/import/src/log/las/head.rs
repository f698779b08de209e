//! The sections before the data.

use wholestring_units::Dimension;

use super::{
    super::{
        channel::{Column, is_no_unit, unit},
        lines::{Lines, text},
        mnemonics,
        moment::{Order, has_zone, moment},
        number::{Marks, marked},
        quantity::Quantity,
        record::COLUMNS,
    },
    item::{Item, item},
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::Note,
};

/// Maximum number of lines before the data, including parameters and remarks.
const LINES: u64 = 200_000;

/// Separator of the cells of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Parted {
    Blanks,
    By(u8),
}

/// Contents of the sections before the data.
#[derive(Debug, Default)]
pub(super) struct Head {
    pub(super) version: String,
    pub(super) wrapped: bool,
    pub(super) parted: Option<Parted>,
    pub(super) null: Option<f64>,
    pub(super) well: Option<String>,
    pub(super) start: Option<String>,
    pub(super) columns: Vec<Column>,
    pub(super) notes: Vec<Note>,
    index_unit: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Section {
    Version,
    Well,
    Curves,
    Data,
    Other,
}

/// Reads up to the title of the data.
pub(super) fn read(lines: &mut Lines) -> Result<Head, ImportError> {
    let mut head = Head::default();
    let mut section = Section::Other;
    let mut line = Vec::new();
    let mut passed_over = Vec::new();
    let mut without_point = Vec::new();
    loop {
        line.clear();
        if !lines.next(&mut line)? {
            let what = "the section ~A with the data".to_owned();
            return Err(ImportError::new(lines.file(), None, ImportErrorKind::Missing { what }));
        }
        if lines.line() > LINES {
            let most = format!("{LINES} lines");
            let found = format!("more than {most} before the data");
            return Err(lines.error(ImportErrorKind::TooMuch { found, most }));
        }
        let written = text(&line);
        let written = written.trim().trim_start_matches('"').trim_end_matches('\0');
        if written.is_empty() || written.starts_with('#') {
            continue;
        }
        if let Some(title) = written.strip_prefix('~') {
            section = section_of(title);
            if section == Section::Data {
                named_in_title(title, &mut head);
                break;
            }
            let name = title.split([' ', '\t', '|']).next().unwrap_or_default();
            if section == Section::Other && name.to_ascii_lowercase().ends_with("_data") {
                passed_over.push(format!("~{name}"));
            }
            continue;
        }
        match section {
            Section::Version | Section::Well => head.said(&item(written, false)),
            Section::Curves => {
                let item = item(written, true);
                if item.without_point {
                    without_point.push(item.mnemonic.clone());
                }
                head.curve(item, lines)?;
            }
            Section::Data | Section::Other => {}
        }
    }
    if head.columns.is_empty() {
        let sentence =
            "there is no section ~Curve before the data, and the line ~A names no curves; \
             expected one of them"
                .to_owned();
        return Err(lines.error(ImportErrorKind::Refused(sentence)));
    }
    if !passed_over.is_empty() {
        let text = format!("the sections {}, which are not the log", passed_over.join(", "));
        head.notes.push(Note::LeftOut(text));
    }
    if !without_point.is_empty() {
        head.notes.push(Note::Read(format!(
            "lines of curves without a point after the name, and so without a unit: {}",
            without_point[..without_point.len().min(20)].join(", ")
        )));
    }
    head.index();
    Ok(head)
}

fn section_of(title: &str) -> Section {
    let lower = title.trim_start().to_ascii_lowercase();
    let name = lower.split([' ', '\t', '|', '[']).next().unwrap_or_default();
    match name {
        "log_data" => Section::Data,
        "log_definition" => Section::Curves,
        _ if name.contains('_') => Section::Other,
        _ => match name.bytes().next() {
            Some(b'v') => Section::Version,
            Some(b'w') => Section::Well,
            Some(b'c') => Section::Curves,
            Some(b'a') => Section::Data,
            _ => Section::Other,
        },
    }
}

/// Names after `~A`, if no section declares curves.
fn named_in_title(title: &str, head: &mut Head) {
    let mut words = title.split_ascii_whitespace();
    let is_own = |word: &str| {
        let lower = word.to_ascii_lowercase();
        ["a", "ascii", "log", "data", "ascii_data"].contains(&lower.as_str())
    };
    words.next();
    let names: Vec<&str> = words.skip_while(|word| is_own(word)).take(COLUMNS).collect();
    if head.columns.is_empty() && names.len() >= 2 {
        let column = |name: &&str| Column { mnemonic: (*name).to_owned(), ..Column::default() };
        head.columns = names.iter().map(column).collect();
        let text = "no section ~Curve: the names after ~A are used as the curves'".to_owned();
        head.notes.push(Note::Assumed(text));
    }
}

impl Head {
    fn said(&mut self, item: &Item) {
        let Item { mnemonic, unit, data, description, .. } = item;
        // "WRAP.NO" has no blank after its point.
        let fixed = if data.is_empty() { unit } else { data };
        // LAS 1.2 has names after the colon.
        let name = || {
            let old = self.version.starts_with("1.") || data.is_empty();
            let name = if old && !description.is_empty() { description } else { data };
            Some(name.clone()).filter(|name| !name.is_empty() && !name.eq_ignore_ascii_case("WELL"))
        };
        match mnemonic.to_ascii_uppercase().as_str() {
            "VERS" => self.version = fixed.split_whitespace().next().unwrap_or_default().to_owned(),
            "WRAP" => self.wrapped = fixed.to_ascii_uppercase().starts_with('Y'),
            "DLM" => {
                self.parted = match fixed.to_ascii_uppercase().as_str() {
                    "COMMA" | "," => Some(Parted::By(b',')),
                    "TAB" => Some(Parted::By(b'\t')),
                    "SPACE" => Some(Parted::Blanks),
                    _ => None,
                }
            }
            "NULL" => self.null = marked(fixed.as_bytes(), Marks::Either),
            "STRT" => self.index_unit.clone_from(unit),
            "WELL" => self.well = name(),
            "DATE" => {
                let date = name().unwrap_or_default();
                // A date without a time is that of the logging, not of the first row.
                let is_time = date.contains(':');
                let read = moment(date.as_bytes(), Order::DayFirst);
                let zone = if has_zone(date.as_bytes()) { " UTC" } else { "" };
                self.start = read
                    .filter(|(_, either)| is_time && !either)
                    .map(|(moment, _)| format!("{}{zone}", moment.text()));
            }
            _ => {}
        }
    }

    fn curve(&mut self, item: Item, lines: &Lines) -> Result<(), ImportError> {
        if self.columns.len() == COLUMNS {
            let (found, most) = (format!("more than {COLUMNS} curves"), COLUMNS.to_string());
            return Err(lines.error(ImportErrorKind::TooMuch { found, most }));
        }
        let Item { mnemonic, unit, description, .. } = item;
        // LAS 3.0 has the format and an association after the description.
        let end = description.find(['{', '|']).unwrap_or(description.len());
        let mut description = description[..end].trim();
        // Some descriptions begin with the curve's number, which is redundant.
        let number = (self.columns.len() + 1).to_string();
        if let Some(rest) = description.strip_prefix(&number)
            && (rest.is_empty() || rest.starts_with(char::is_whitespace))
        {
            description = rest.trim();
        }
        let mnemonic = match mnemonic.as_str() {
            "" => "UNKNOWN".to_owned(),
            _ => mnemonic,
        };
        let description = description.to_owned();
        self.columns.push(Column { mnemonic, unit, description, ..Column::default() });
        Ok(())
    }

    /// The first curve is the index: a time or a depth, by its unit.
    fn index(&mut self) {
        let Some(first) = self.columns.first_mut() else { return };
        if is_no_unit(&first.unit) && !is_no_unit(&self.index_unit) {
            first.unit.clone_from(&self.index_unit);
            let name = &first.mnemonic;
            let note = format!("{name} has no unit and is taken to be in '{}' as STRT", first.unit);
            self.notes.push(Note::Assumed(note));
        }
        let by_name = mnemonics::quantity(&first.mnemonic).map(|(quantity, _)| quantity);
        first.index = match by_name {
            Some(quantity) => Some(quantity),
            // A date in days has its time in another column.
            None if mnemonics::is_date(&first.mnemonic) => None,
            None if unit(Dimension::Time, &first.unit).is_some() => Some(Quantity::Time),
            None => None,
        };
    }
}
