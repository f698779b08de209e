//! A number with its unit.

use std::collections::BTreeMap;

use wholestring_units::{Dimension, Unit, number_text};

use super::tree::Node;
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::{Block, Note, Origin, Value},
};

/// Maximum length of quoted foreign text in a sentence, characters: a name or a remark.
const LONGEST: usize = 80;

/// A number with its unit and its location.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Measure {
    pub(crate) number: f64,
    pub(crate) unit: &'static Unit,
    pub(crate) origin: Origin,
    /// The text as written: `25 lbm/ft`.
    pub(crate) written: String,
    pub(crate) line: u64,
}

impl Measure {
    pub(crate) fn si(&self) -> f64 {
        self.unit.to_si(self.number)
    }

    pub(crate) fn value(&self) -> Value {
        Value::quantity(self.number, self.unit)
    }
}

/// The file being read and the user's choices.
pub(crate) struct Source<'a> {
    pub(crate) file: &'a str,
    pub(crate) choices: &'a Choices,
}

impl Source<'_> {
    /// An error in a line.
    pub(crate) fn error(&self, line: u64, kind: ImportErrorKind) -> ImportError {
        ImportError::new(self.file, Some(format!("line {line}")), kind)
    }

    /// Reads the quantity in a child element; `None` if the element is missing or empty.
    ///
    /// The first of the names is the one used in messages and in `--unit`.
    pub(crate) fn measure(
        &self,
        node: &Node,
        names: &str,
        dimension: Dimension,
    ) -> Result<Option<Measure>, ImportError> {
        match node.child(names) {
            Some(child) => self.measure_of(child, name_of(names), None, dimension),
            None => Ok(None),
        }
    }

    /// Reads the quantity of an element, or of its child that has a unit, as depths have it in 2.1;
    /// its unit may be given next to it.
    pub(crate) fn measure_of(
        &self,
        node: &Node,
        name: &str,
        beside: Option<&str>,
        dimension: Dimension,
    ) -> Result<Option<Measure>, ImportError> {
        let outer = node;
        let within = node.children().iter().find(|child| child.attribute("uom").is_some());
        let node = if node.text.is_empty() { within.unwrap_or(node) } else { node };
        let Some(number) = self.number_of(node, name)? else { return Ok(None) };
        let place = format!("line {}, {}", node.line, outer.name);
        let (unit, origin, written) = match node.attribute("uom").or(beside) {
            Some(uom) => {
                let wrong = || ImportErrorKind::WrongUnit { found: short(uom), dimension };
                let unit = dimension.find_unit(uom);
                let unit = unit.ok_or_else(|| self.error(node.line, wrong()))?;
                // Two adjacent numbers such as `27 x 1000 lbf.ft` would be read as one.
                let times = if uom.starts_with(|c: char| c.is_ascii_digit()) { "x " } else { "" };
                let written = format!("{} {times}{}", short(&node.text), short(uom));
                let as_written = unit.symbol == uom;
                let origin =
                    if as_written { Origin::at(place) } else { Origin::written(place, &written) };
                (unit, origin, written)
            }
            None => {
                let missing = || ImportErrorKind::MissingUnit {
                    what: name.to_owned(),
                    name: name.to_owned(),
                    dimension,
                };
                let chosen = self.choices.unit_of(&[name], dimension);
                let unit = chosen.and_then(|unit| unit.ok_or_else(missing));
                let unit = unit.map_err(|kind| self.error(node.line, kind))?;
                (unit, Origin::written(place, short(&node.text)), short(&node.text))
            }
        };
        Ok(Some(Measure { number, unit, origin, written, line: node.line }))
    }

    /// A number without a unit.
    pub(crate) fn number_of(&self, node: &Node, name: &str) -> Result<Option<f64>, ImportError> {
        if node.text.is_empty() {
            return Ok(None);
        }
        match node.text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Some(number)),
            _ => {
                let found = short(&node.text);
                let kind = ImportErrorKind::NotANumber { what: name.to_owned(), found };
                Err(self.error(node.line, kind))
            }
        }
    }

    /// Reads a quantity above zero. Zero means unknown and is noted.
    pub(crate) fn positive(
        &self,
        node: &Node,
        names: &str,
        dimension: Dimension,
        (label, notes): (&str, &mut Vec<Note>),
    ) -> Result<Option<Measure>, ImportError> {
        let Some(measure) = self.measure(node, names, dimension)? else { return Ok(None) };
        if measure.number < 0.0 {
            return Err(self.out_of_range(&measure, name_of(names), "more than 0"));
        }
        if measure.number == 0.0 {
            let name = name_of(names);
            notes.push(Note::LeftOut(format!("the {name} of {label}, which is 0: not known")));
            return Ok(None);
        }
        Ok(Some(measure))
    }

    /// Reads a quantity that a case does not need: an unreadable one is left out with a note.
    pub(crate) fn optional(
        &self,
        node: &Node,
        names: &str,
        dimension: Dimension,
        notes: &mut Vec<Note>,
    ) -> Result<Option<Measure>, ImportError> {
        match self.measure(node, names, dimension) {
            Err(error)
                if matches!(
                    error.kind(),
                    ImportErrorKind::WrongUnit { .. } | ImportErrorKind::NotANumber { .. }
                ) =>
            {
                let place = error.place().unwrap_or_default();
                let name = name_of(names);
                notes.push(Note::LeftOut(format!("{name} in {place}: {}", error.kind())));
                Ok(None)
            }
            measure => measure,
        }
    }

    pub(crate) fn out_of_range(&self, found: &Measure, name: &str, expected: &str) -> ImportError {
        let kind = ImportErrorKind::OutOfRange {
            what: name.to_owned(),
            found: found.written.clone(),
            expected: expected.to_owned(),
        };
        self.error(found.line, kind)
    }
}

/// The first of several names.
pub(crate) fn name_of(names: &str) -> &str {
    names.split('|').next().unwrap_or(names)
}

/// Formats foreign text for a sentence: on one line and shortened.
pub(crate) fn short(text: &str) -> String {
    let words: Vec<&str> = text.split(|c: char| c.is_whitespace() || c.is_control()).collect();
    let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
    words.join(" ").chars().take(LONGEST).collect()
}

/// Formats a length for a sentence, m.
pub(crate) fn metres(length_m: f64) -> String {
    format!("{} m", number_text((length_m * 1e3).round() / 1e3))
}

/// Adds a key if it has a value.
pub(crate) fn push(block: &mut Block, key: &'static str, measure: Option<&Measure>) {
    if let Some(measure) = measure {
        block.push(key, measure.value(), measure.origin.clone());
    }
}

// The units of a survey's columns: measured depth, inclination, azimuth.

/// Units of the stations and how often each occurs.
#[derive(Default)]
pub(crate) struct Units(BTreeMap<(usize, &'static str), usize>);

impl Units {
    /// Counts a number of a column.
    pub(crate) fn add(&mut self, column: usize, measure: &Measure) {
        *self.0.entry((column, measure.unit.symbol)).or_default() += 1;
    }

    /// Units of a column, the most common first.
    fn of(&self, index: usize) -> Vec<&'static str> {
        let mut found: Vec<(usize, &str)> = self
            .0
            .iter()
            .filter(|((column, _), _)| *column == index)
            .map(|((_, symbol), count)| (*count, *symbol))
            .collect();
        found.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
        found.into_iter().map(|(_, symbol)| symbol).collect()
    }

    /// The most common unit of each column: `ft, deg, deg`.
    pub(crate) fn said(&self) -> String {
        let commonest = |index| self.of(index).first().copied().unwrap_or("deg");
        [0, 1, 2].map(commonest).join(", ")
    }

    /// Note if a column has several units, or angles are not in degrees.
    pub(crate) fn note(&self) -> Option<Note> {
        let columns = [0, 1, 2].map(|index| self.of(index).join(" and "));
        let plain = self.of(0).len() == 1
            && columns[1..].iter().all(|column| ["", "deg"].contains(&column.as_str()));
        let text = format!("md, incl and azi of the stations are in {}", columns.join(", "));
        (!plain).then_some(Note::Read(text))
    }
}

// Datum of the depths of an object.

/// Note on the datum of depths, if the file gives it.
pub(crate) fn datum(depth: Option<&Node>) -> Option<Note> {
    let depth = depth?;
    let within = || depth.child("Datum").and_then(|datum| datum.text_of("Title"));
    let datum = depth.attribute("datum").or_else(within)?;
    let known = !datum.eq_ignore_ascii_case("unknown");
    known.then(|| Note::Read(format!("measured depths are from the datum '{}'", short(datum))))
}
