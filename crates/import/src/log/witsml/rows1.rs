//! The rows of a log of WITSML 1: texts between commas.

use super::super::record::{Row, Rows};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::Note,
    xml::{Event, Xml},
};

/// Maximum number of logs in a file whose names are kept.
pub(super) const LOGS: usize = 1000;

/// Content after the head of a log: its first row, or nothing.
pub(super) enum First {
    Row(String, u64),
    NoRows { in_log: bool },
}

/// Rows of a log, and the names of the logs after it.
pub(super) struct DataRows<'a> {
    xml: Xml<'a>,
    sign: u8,
    columns: usize,
    /// Name of this log, and those of others found in the file.
    names: Vec<String>,
    picked: bool,
    first: Option<(String, u64)>,
    /// Whether the elements `logData` and `log` are open.
    in_data: bool,
    in_log: bool,
    ended: bool,
}

impl<'a> DataRows<'a> {
    /// The rows of a log whose head has been read.
    pub(super) fn new(
        xml: Xml<'a>,
        first: First,
        sign: u8,
        columns: usize,
        title: &str,
        picked: bool,
    ) -> Self {
        let (first, in_data, in_log) = match first {
            First::Row(text, line) => (Some((text, line)), true, true),
            First::NoRows { in_log } => (None, false, in_log),
        };
        let names = vec![title.to_owned()];
        Self { xml, sign, columns, names, picked, first, in_data, in_log, ended: false }
    }

    /// The text of the next row with its line.
    fn text(&mut self, notes: &mut Vec<Note>) -> Result<Option<(String, u64)>, ImportError> {
        if let Some(first) = self.first.take() {
            return Ok(Some(first));
        }
        while self.in_data {
            match self.xml.next()? {
                Event::Start(element) if element.name == "data" => {
                    return Ok(Some((self.xml.text()?, element.line)));
                }
                Event::Start(_) => self.xml.skip()?,
                Event::Text(_) => {}
                Event::End | Event::Eof => self.in_data = false,
            }
        }
        while self.in_log {
            match self.xml.next()? {
                Event::Start(element) => {
                    if element.name == "logData" {
                        let text = format!("a second logData, line {}", element.line);
                        notes.push(Note::LeftOut(text));
                    }
                    self.xml.skip()?;
                }
                Event::Text(_) => {}
                Event::End | Event::Eof => self.in_log = false,
            }
        }
        self.others(notes)?;
        Ok(None)
    }

    /// Searches for further logs after the one that was read.
    fn others(&mut self, notes: &mut Vec<Note>) -> Result<(), ImportError> {
        loop {
            match self.xml.next()? {
                Event::Start(element) if element.name == "log" => {
                    let name = name(&mut self.xml)?;
                    let uid = element.attribute("uid").unwrap_or_default();
                    if self.names.len() < LOGS {
                        self.names.push(if name.is_empty() { uid.to_owned() } else { name });
                    }
                }
                Event::Start(_) => self.xml.skip()?,
                Event::Eof => break,
                Event::Text(_) | Event::End => {}
            }
        }
        if self.names.len() == 1 {
            return Ok(());
        }
        let names = std::mem::take(&mut self.names);
        if self.picked {
            let others = names[1..].join(", ");
            notes.push(Note::LeftOut(format!("the logs after '{}': {others}", names[0])));
            return Ok(());
        }
        let what = "log".to_owned();
        Err(ImportError::new(self.xml.file(), None, ImportErrorKind::Ambiguous { what, names }))
    }
}

/// Name of the log that has begun, which is skipped.
fn name(xml: &mut Xml) -> Result<String, ImportError> {
    let mut name = String::new();
    loop {
        match xml.next()? {
            Event::Start(element) if element.name == "name" => name = xml.text()?,
            Event::Start(_) => xml.skip()?,
            Event::Text(_) => {}
            Event::End | Event::Eof => return Ok(name),
        }
    }
}

impl Rows for DataRows<'_> {
    fn next(&mut self, row: &mut Row, notes: &mut Vec<Note>) -> Result<bool, ImportError> {
        row.clear();
        if self.ended {
            return Ok(false);
        }
        let Some((text, line)) = self.text(notes)? else {
            self.ended = true;
            return Ok(false);
        };
        row.line = line;
        row.bytes.extend_from_slice(text.as_bytes());
        row.part_at(self.sign, 0);
        if row.cells.len() > self.columns {
            let found = row.cells.len();
            let sentence = format!("the row has {found} values; {} were expected", self.columns);
            let place = Some(format!("line {line}"));
            let kind = ImportErrorKind::Refused(sentence);
            return Err(ImportError::new(self.xml.file(), place, kind));
        }
        Ok(true)
    }
}
