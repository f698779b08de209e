//! A log of WITSML 1.3.1.1 or 1.4.1.1: rows of text between commas.

use std::collections::BTreeMap;

use super::{
    super::{
        channel::Column,
        log::Opened,
        mnemonics,
        number::{Marks, number},
        quantity::Quantity,
        record::COLUMNS,
    },
    pick::{is_picked, missing},
    rows1::{DataRows, First, LOGS},
};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::Note,
    xml::{Element, Event, Xml},
};

/// Head of a log: its content before the rows.
#[derive(Debug, Default)]
struct Head {
    name: String,
    uid: String,
    well: Option<String>,
    index_type: String,
    index_curve: String,
    null: Option<f64>,
    sign: Option<u8>,
    curves: Vec<Column>,
    mnemonics: Vec<String>,
    units: Vec<String>,
}

/// Reads up to the first row of the picked log, or of the first one.
pub(super) fn open<'a>(
    mut xml: Xml<'a>,
    root: &Element,
    choices: &Choices,
) -> Result<Opened<'a>, ImportError> {
    let picked = choices.picked("log").map(str::to_owned);
    let version = root.attribute("version").unwrap_or("1").to_owned();
    let mut passed: Vec<String> = Vec::new();
    let mut alone = root.name == "log";
    loop {
        let element = if std::mem::take(&mut alone) {
            root.clone()
        } else {
            match xml.next()? {
                Event::Start(element) if element.name == "log" => element,
                Event::Start(_) => {
                    xml.skip()?;
                    continue;
                }
                Event::Eof => break,
                Event::Text(_) | Event::End => continue,
            }
        };
        let mut head = Head {
            uid: element.attribute("uid").unwrap_or_default().to_owned(),
            ..Head::default()
        };
        let first = read(&mut xml, &mut head, picked.as_deref())?;
        let Some(first) = first else {
            if passed.len() < LOGS {
                passed.push(head.title());
            }
            continue;
        };
        return Ok(opened(xml, head, first, passed, picked.is_some(), &version));
    }
    match picked {
        Some(name) if !passed.is_empty() => {
            Err(xml.error(ImportErrorKind::NoSuch { what: "log".to_owned(), name, names: passed }))
        }
        _ => Err(missing(&xml, "a log with curves (logCurveInfo)")),
    }
}

/// Reads a log up to its first row; returns `None` for a log that is not picked, which is skipped.
fn read(
    xml: &mut Xml,
    head: &mut Head,
    picked: Option<&str>,
) -> Result<Option<First>, ImportError> {
    loop {
        let element = match xml.next()? {
            Event::Start(element) => element,
            Event::Text(_) => continue,
            // A log without rows.
            Event::End | Event::Eof => {
                let is_picked = is_picked(picked, &[&head.name, &head.uid]);
                return Ok(is_picked.then_some(First::NoRows { in_log: false }));
            }
        };
        match element.name.as_str() {
            "nameWell" => head.well = Some(xml.text()?).filter(|name| !name.is_empty()),
            "name" => head.name = xml.text()?,
            "indexType" => head.index_type = xml.text()?,
            "indexCurve" => head.index_curve = xml.text()?,
            "nullValue" => head.null = number(xml.text()?.as_bytes()),
            "dataDelimiter" => head.sign = xml.text()?.bytes().next(),
            "logCurveInfo" => {
                let curve = curve(xml)?;
                if head.curves.len() == COLUMNS {
                    let (found, most) =
                        (format!("more than {COLUMNS} curves"), COLUMNS.to_string());
                    return Err(xml.error(ImportErrorKind::TooMuch { found, most }));
                }
                head.curves.push(curve);
            }
            "logData" if is_picked(picked, &[&head.name, &head.uid]) => {
                return data(xml, head).map(Some);
            }
            _ => xml.skip()?,
        }
    }
}

/// Reads the lists at the beginning of `logData` and the first row.
fn data(xml: &mut Xml, head: &mut Head) -> Result<First, ImportError> {
    loop {
        match xml.next()? {
            Event::Start(element) => match element.name.as_str() {
                "mnemonicList" => head.mnemonics = listed(&xml.text()?),
                "unitList" => head.units = listed(&xml.text()?),
                "data" => return Ok(First::Row(xml.text()?, element.line)),
                _ => xml.skip()?,
            },
            Event::Text(_) => {}
            Event::End | Event::Eof => return Ok(First::NoRows { in_log: true }),
        }
    }
}

fn listed(text: &str) -> Vec<String> {
    text.split(',').take(COLUMNS + 1).map(|name| name.trim().to_owned()).collect()
}

fn curve(xml: &mut Xml) -> Result<Column, ImportError> {
    let mut column = Column::default();
    loop {
        match xml.next()? {
            Event::Start(element) => match element.name.as_str() {
                "mnemonic" => column.mnemonic = xml.text()?,
                "unit" => column.unit = xml.text()?,
                "mnemAlias" => column.alias = Some(xml.text()?),
                "curveDescription" => column.description = xml.text()?,
                "nullValue" => column.null = number(xml.text()?.as_bytes()),
                _ => xml.skip()?,
            },
            Event::Text(_) => {}
            Event::End | Event::Eof => return Ok(column),
        }
    }
}

impl Head {
    fn title(&self) -> String {
        if self.name.is_empty() { self.uid.clone() } else { self.name.clone() }
    }

    /// Columns of the rows in order: those of the list, completed by the curve descriptions.
    fn columns(&mut self, notes: &mut Vec<Note>) -> Vec<Column> {
        let mut columns = if self.mnemonics.is_empty() {
            std::mem::take(&mut self.curves)
        } else {
            let mut by_name: BTreeMap<&str, Vec<&Column>> = BTreeMap::new();
            for curve in self.curves.iter().rev() {
                by_name.entry(&curve.mnemonic).or_default().push(curve);
            }
            let mut columns = Vec::with_capacity(self.mnemonics.len());
            for (at, mnemonic) in self.mnemonics.iter().enumerate() {
                let known = by_name.get_mut(mnemonic.as_str()).and_then(Vec::pop);
                let mut column = known.cloned().unwrap_or_default();
                column.mnemonic.clone_from(mnemonic);
                // The list next to the rows takes precedence over the curve's own unit.
                if let Some(unit) = self.units.get(at).filter(|unit| !unit.is_empty()) {
                    if !column.unit.is_empty() && column.unit != *unit {
                        notes.push(Note::Checked(format!(
                            "{mnemonic} has the unit '{}' in its logCurveInfo and '{unit}' in the \
                             unitList, which is taken",
                            column.unit
                        )));
                    }
                    column.unit.clone_from(unit);
                }
                columns.push(column);
            }
            columns
        };
        let is_index = |column: &Column| column.mnemonic == self.index_curve;
        let index = columns.iter().position(is_index).unwrap_or(0);
        if let Some(index) = columns.get_mut(index) {
            index.index = match self.index_type.as_str() {
                "date time" | "elapsed time" => Some(Quantity::Time),
                "measured depth" => {
                    let named = mnemonics::quantity(&index.mnemonic).map(|(quantity, _)| quantity);
                    Some(if named == Some(Quantity::BitDepth) {
                        Quantity::BitDepth
                    } else {
                        Quantity::HoleDepth
                    })
                }
                _ => None,
            };
        }
        columns
    }
}

fn opened<'a>(
    xml: Xml<'a>,
    mut head: Head,
    first: First,
    passed: Vec<String>,
    picked: bool,
    version: &str,
) -> Opened<'a> {
    let mut notes = Vec::new();
    let columns = head.columns(&mut notes);
    let title = head.title();
    if picked && !passed.is_empty() {
        notes.push(Note::LeftOut(format!("the logs before '{title}': {}", passed.join(", "))));
    }
    let file = xml.file().to_owned();
    let sign = head.sign.unwrap_or(b',');
    let rows = DataRows::new(xml, first, sign, columns.len(), &title, picked);
    Opened {
        file,
        what: format!("WITSML {version}, log '{title}'"),
        well: head.well,
        columns,
        null: head.null,
        marks: Marks::Point,
        start: None,
        notes,
        rows: Box::new(rows),
    }
}
