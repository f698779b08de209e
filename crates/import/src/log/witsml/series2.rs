//! A log of WITSML 2.0 or 2.1: sets of channels whose rows are JSON.

use super::{
    super::{
        channel::Column,
        log::Opened,
        mnemonics,
        number::Marks,
        quantity::Quantity,
        record::{COLUMNS, Row, Rows},
    },
    json::Json,
    pick::{is_picked, missing},
};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::Note,
    xml::{Element, Event, Xml},
};

/// Maximum bytes of the rows of a set. They form one XML text, which is read whole.
const LARGEST: usize = 64 << 20;

/// Maximum number of channel sets in a log.
const SETS: usize = 1000;

/// A set of channels.
#[derive(Debug, Default)]
struct Set {
    title: String,
    indexes: Vec<Column>,
    channels: Vec<Column>,
    data: String,
    line: u64,
}

struct JsonRows {
    file: String,
    json: Json,
    /// Line on which the rows begin, then that of the next row.
    line: u64,
    columns: usize,
    indexes: usize,
}

/// Reads the sets of a log and chooses one.
pub(super) fn open<'a>(
    mut xml: Xml<'a>,
    root: &Element,
    choices: &Choices,
) -> Result<Opened<'a>, ImportError> {
    let picked = choices.picked("log").map(str::to_owned);
    let version = root.attribute("schemaVersion").unwrap_or("2").to_owned();
    let mut sets: Vec<Set> = Vec::new();
    let mut title = String::new();
    if root.name == "ChannelSet" {
        sets.push(set(&mut xml, true)?);
    } else {
        loop {
            let element = match xml.next()? {
                Event::Start(element) => element,
                Event::Text(_) => continue,
                Event::End | Event::Eof => break,
            };
            match element.name.as_str() {
                "Citation" => title = self::title(&mut xml)?,
                "ChannelSet" => {
                    if sets.len() == SETS {
                        let (found, most) = (format!("more than {SETS} sets"), SETS.to_string());
                        return Err(xml.error(ImportErrorKind::TooMuch { found, most }));
                    }
                    // The rows of one set are kept: the first, or the picked one.
                    let with_rows = picked.is_some() || sets.is_empty();
                    let mut set = set(&mut xml, with_rows)?;
                    if !is_picked(picked.as_deref(), &[&set.title]) {
                        set.data = String::new();
                    }
                    sets.push(set);
                }
                _ => xml.skip()?,
            }
        }
    }
    let titles = || sets.iter().map(|set| set.title.clone()).collect::<Vec<_>>();
    let what = "log".to_owned();
    let at = match (&picked, sets.len()) {
        (_, 0) => return Err(missing(&xml, "a ChannelSet with the channels of the log")),
        (None, 1) => 0,
        (None, _) => {
            let kind = ImportErrorKind::Ambiguous { what, names: titles() };
            return Err(ImportError::new(xml.file(), None, kind));
        }
        (Some(name), _) => sets.iter().position(|set| set.title == *name).ok_or_else(|| {
            let kind = ImportErrorKind::NoSuch { what, name: name.clone(), names: titles() };
            ImportError::new(xml.file(), None, kind)
        })?,
    };
    let others: Vec<String> =
        titles().into_iter().filter(|title| *title != sets[at].title).collect();
    let set = sets.swap_remove(at);
    let mut notes = Vec::new();
    if !others.is_empty() {
        notes.push(Note::LeftOut(format!("the other sets of channels: {}", others.join(", "))));
    }
    let indexes = set.indexes.len();
    let columns: Vec<Column> = set.indexes.into_iter().chain(set.channels).collect();
    let title = if set.title.is_empty() { title } else { set.title };
    Ok(Opened {
        file: xml.file().to_owned(),
        what: format!("WITSML {version}, log '{title}'"),
        well: None,
        null: None,
        marks: Marks::Point,
        start: None,
        notes,
        rows: Box::new(JsonRows {
            file: xml.file().to_owned(),
            json: Json::new(set.data),
            line: set.line,
            columns: columns.len(),
            indexes,
        }),
        columns,
    })
}

fn title(xml: &mut Xml) -> Result<String, ImportError> {
    let mut title = String::new();
    loop {
        match xml.next()? {
            Event::Start(element) if element.name == "Title" => title = xml.text()?,
            Event::Start(_) => xml.skip()?,
            Event::Text(_) => {}
            Event::End | Event::Eof => return Ok(title),
        }
    }
}

fn set(xml: &mut Xml, with_rows: bool) -> Result<Set, ImportError> {
    let mut set = Set::default();
    loop {
        let element = match xml.next()? {
            Event::Start(element) => element,
            Event::Text(_) => continue,
            Event::End | Event::Eof => return Ok(set),
        };
        match element.name.as_str() {
            "Citation" => set.title = title(xml)?,
            "Index" => set.indexes.push(channel(xml, true)?),
            "Channel" => set.channels.push(channel(xml, false)?),
            "Data" if with_rows => data(xml, &mut set)?,
            _ => xml.skip()?,
        }
        if set.indexes.len() + set.channels.len() > COLUMNS {
            let (found, most) = (format!("more than {COLUMNS} channels"), COLUMNS.to_string());
            return Err(xml.error(ImportErrorKind::TooMuch { found, most }));
        }
    }
}

/// Reads the rows: text of `Data` within `Data`, or of the outer one.
fn data(xml: &mut Xml, set: &mut Set) -> Result<(), ImportError> {
    let mut depth = 1;
    while depth > 0 {
        let event = xml.next().map_err(|error| match error.kind() {
            ImportErrorKind::TooMuch { .. } => too_long(xml),
            _ => error,
        });
        match event? {
            Event::Start(element) if element.name == "Data" => depth += 1,
            Event::Start(element) if element.name == "FileUri" => {
                let sentence = "the rows are in another file (FileUri), which is not read";
                return Err(xml.error(ImportErrorKind::Refused(sentence.to_owned())));
            }
            Event::Start(_) => xml.skip()?,
            Event::Text(text) => {
                if set.data.trim().is_empty() {
                    set.data.clear();
                    let ends = text.bytes().filter(|b| *b == b'\n').count() as u64;
                    set.line = xml.line().saturating_sub(ends);
                }
                if set.data.len() + text.len() > LARGEST {
                    return Err(too_long(xml));
                }
                set.data.push_str(&text);
            }
            Event::End => depth -= 1,
            Event::Eof => break,
        }
    }
    Ok(())
}

/// The error of a set with too many rows, with the remedy.
fn too_long(xml: &Xml) -> ImportError {
    xml.error(ImportErrorKind::Refused(format!(
        "a ChannelSet has rows of more than {} MB, and WITSML 2 stores them in one text, which is \
         read whole; save the log as WITSML 1.4.1.1, LAS or CSV, which may be of any length, or \
         in parts",
        LARGEST >> 20
    )))
}

fn channel(xml: &mut Xml, is_index: bool) -> Result<Column, ImportError> {
    let mut column = Column::default();
    let mut kind = String::new();
    loop {
        match xml.next()? {
            Event::Start(element) => match element.name.as_str() {
                "Mnemonic" => column.mnemonic = xml.text()?,
                "Uom" => column.unit = xml.text()?,
                "IndexType" | "IndexKind" => kind = xml.text()?,
                "Citation" => column.description = title(xml)?,
                _ => xml.skip()?,
            },
            Event::Text(_) => {}
            Event::End | Event::Eof => break,
        }
    }
    if is_index {
        let named = mnemonics::quantity(&column.mnemonic).map(|(quantity, _)| quantity);
        column.index = match kind.to_ascii_lowercase().as_str() {
            "date time" | "datetime" | "elapsed time" | "time" => Some(Quantity::Time),
            "measured depth" | "depth" if named == Some(Quantity::BitDepth) => named,
            "measured depth" => Some(Quantity::HoleDepth),
            _ => None,
        };
    }
    Ok(column)
}

impl Rows for JsonRows {
    fn next(&mut self, row: &mut Row, _: &mut Vec<Note>) -> Result<bool, ImportError> {
        row.clear();
        let from = self.json.at();
        row.line = self.line;
        let refused = |sentence: String, line: u64| {
            let place = Some(format!("line {line}"));
            ImportError::new(&self.file, place, ImportErrorKind::Refused(sentence))
        };
        let found = self.json.row(row);
        self.line += self.json.lines(from);
        let index = match found {
            Ok(Some(index)) => index,
            Ok(None) => return Ok(false),
            Err(expected) => {
                let sentence = format!("the rows are not JSON as WITSML defines it: {expected}");
                return Err(refused(sentence, self.line));
            }
        };
        if index != self.indexes || row.cells.len() > self.columns {
            let sentence = format!(
                "the row has {index} indexes and {} values; {} and at most {} were expected",
                row.cells.len() - index,
                self.indexes,
                self.columns - self.indexes
            );
            return Err(refused(sentence, self.line));
        }
        Ok(true)
    }
}
