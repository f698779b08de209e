//! Numbers that are accepted but probably unintended: a unit was forgotten, or another one was
//! intended.

use wholestring_units::{Dimension, Unit, UnitSet, number_text};

use crate::{
    bare::Bare,
    diagnostic::Diagnostic,
    node::{Node, Value},
    range::Range,
    reader::Reader,
    source::COMMAND_LINE,
};

/// Maximum number of units in a help line.
const MAX_UNITS: usize = 3;

/// Maximum number of underlined numbers without a unit, of all keys and of one key.
const MAX_BARE: usize = 6;
const MAX_BARE_OF_A_KEY: usize = 2;

/// The written value of a quantity.
pub(crate) struct Entry<'a> {
    pub(crate) dimension: Dimension,
    pub(crate) range: &'a Range,
    /// The unit of a number without one.
    pub(crate) unit: &'static str,
    pub(crate) number: f64,
    pub(crate) si: f64,
    pub(crate) node: &'a Node,
}

impl Entry<'_> {
    fn is_bare(&self) -> bool {
        matches!(self.node.value, Value::Number { .. })
    }

    /// The units in which the number would be usual: those of the case first, then those of other
    /// unit sets, then the others.
    fn fitting_units(&self, set: UnitSet) -> Vec<&'static Unit> {
        let Some((from, to)) = self.range.usual_numbers() else {
            return Vec::new();
        };
        let sets = std::iter::once(&set).chain(UnitSet::ALL);
        let everyday = sets.map(|set| self.dimension.unit_in(*set));
        // Users who write in feet and pounds mean `lbf` before `N`.
        let own =
            self.dimension.units().iter().filter(|unit| set == UnitSet::Field && unit.is_field());
        let mut units: Vec<&'static Unit> = Vec::new();
        let first = std::iter::once(self.dimension.unit_in(set));
        for unit in first.chain(own).chain(everyday).chain(self.dimension.units()) {
            let si = unit.to_si(self.number);
            let known = units.iter().any(|other| other.factor == unit.factor);
            if (from..=to).contains(&si) && !known {
                units.push(unit);
            }
        }
        units.truncate(MAX_UNITS);
        units
    }

    /// The units in which the number would be sensible.
    pub(crate) fn advice(&self, reader: &Reader) -> Option<String> {
        let units = self.fitting_units(reader.units());
        let first = units.first()?;
        let symbols: Vec<&str> = units.iter().map(|unit| unit.symbol).collect();
        let number = number_text(self.number);
        Some(format!(
            "{number} would make sense in {}: write {}\"{number} {}\"",
            alternatives(&symbols),
            if units.len() > 1 { "such as " } else { "" },
            first.symbol
        ))
    }

    /// Warns about a number that is accepted, but not usual.
    pub(crate) fn check(&self, reader: &mut Reader) {
        let Some(side) = unusual(self.si, self.range) else {
            return self.note_bare(reader);
        };
        let set = reader.units();
        let (from, to) = self.range.usual_numbers().unwrap_or_default();
        let show = |si: f64| self.dimension.format(si, set);
        let value = if self.is_bare() {
            format!("{} {}", number_text(self.number), self.unit)
        } else {
            reader.written(self.node.place)
        };
        let mut diagnostic =
            Diagnostic::warning(format!("`{}` is unusually {side}: {value}", reader.key))
                .at(self.node.place, format!("usual are {} to {}", show(from), show(to)));
        if self.is_bare() {
            diagnostic = diagnostic.help(format!("a number without unit is in {}", self.unit));
        }
        if let Some(advice) = self.advice(reader) {
            diagnostic = diagnostic.help(advice);
        }
        reader.report(diagnostic);
    }

    /// Records a number in SI if other units are displayed.
    fn note_bare(&self, reader: &mut Reader) {
        let (own, set) = (self.dimension.si_symbol(), reader.units());
        let symbol = self.dimension.unit_in(set).symbol;
        // A survey or a table of a bit has its own units.
        let in_the_case = self.node.place.source == 0;
        if set != UnitSet::Field
            || !self.is_bare()
            || !in_the_case
            || self.unit != own
            || symbol == own
            || self.si == 0.0
        {
            return;
        }
        let number = number_text(self.number);
        let key = reader.key;
        let taken = self.dimension.format(self.si, set);
        reader.note_bare(Bare {
            key,
            place: self.node.place,
            text: format!("taken as {number} {own}, {taken}"),
            meant: match self.plausible(set) {
                Some(unit) => format!("\"{number} {}\"", unit.symbol),
                None => format!("\"{number} {own}\", which is {taken}"),
            },
        });
    }

    /// The unit of a set, or another of the same kind, in which the number has the usual magnitude.
    fn plausible(&self, set: UnitSet) -> Option<&'static Unit> {
        let is_of_set = |unit: &&Unit| (set == UnitSet::Field) == unit.is_field();
        if self.range.usual_numbers().is_some() {
            return self.fitting_units(set).into_iter().find(is_of_set);
        }
        let unit = self.dimension.unit_in(set);
        self.range.holds(unit.to_si(self.number)).then_some(unit)
    }

    /// A number without a unit that is usual in no unit.
    fn unit_of_no_size(&self, from: f64, to: f64, reader: &Reader) -> Diagnostic {
        let show = |si: f64| self.dimension.format(si, reader.units());
        let symbols: Vec<&str> = self.dimension.units().iter().map(|unit| unit.symbol).collect();
        Diagnostic::error(format!("`{}` needs a unit", reader.key))
            .at(self.node.place, "expected a unit after the number")
            .help(format!("usual are {} to {}", show(from), show(to)))
            .help(format!("units of {}: {}", self.dimension.name(), symbols.join(", ")))
    }

    /// A number without a unit, whose quotes the shell may have removed.
    pub(crate) fn needs_unit(&self, reader: &Reader) -> Diagnostic {
        let set = reader.units();
        let fitting = self.fitting_units(set);
        let unit = match (fitting.first(), self.range.usual_numbers()) {
            (Some(unit), _) => unit.symbol,
            (None, Some((from, to))) => return self.unit_of_no_size(from, to, reader),
            // Its magnitude is unknown: the interpretation of a file.
            (None, None) => self.unit,
        };
        let symbols = self.dimension.units().iter().map(|unit| unit.symbol);
        let symbols: Vec<&str> = symbols.collect();
        let place = self.node.place;
        let written = reader.text_at(place).trim_matches(['"', '\'']);
        let with_unit = with_unit(written, unit);
        let source = reader.sources.get(place.source);
        let argument = source
            .filter(|source| source.name == COMMAND_LINE)
            .and_then(|source| source.text.split_once('='));
        let diagnostic = Diagnostic::error(format!("`{}` needs a unit", reader.key))
            .at(place, "expected a unit after the number");
        match argument {
            Some((key, _)) if with_unit.contains(' ') => diagnostic
                .help(format!("such as '{}={with_unit}', in quotes for the shell", key.trim_end())),
            Some((key, _)) => diagnostic.help(format!(
                "such as {}={with_unit}: without a blank it needs no quotes, which a shell removes",
                key.trim_end()
            )),
            None => diagnostic.help(format!("such as \"{with_unit}\"")),
        }
        .help(format!("units of {}: {}", self.dimension.name(), symbols.join(", ")))
    }
}

/// A number, or each of a range, with a unit.
fn with_unit(written: &str, unit: &str) -> String {
    // A unit such as 1/s needs a blank before its digit.
    let blank = if unit.starts_with(|first: char| first.is_ascii_digit()) { " " } else { "" };
    let unit = &format!("{blank}{unit}");
    let Some((from, rest)) = written.split_once("..") else {
        return format!("{written}{unit}");
    };
    let rest: Vec<String> = rest.split('/').map(|part| format!("{}{unit}", part.trim())).collect();
    format!("{}{unit}..{}", from.trim(), rest.join("/"))
}

/// `small` or `large`, if a number is not usual.
fn unusual(si: f64, range: &Range) -> Option<&'static str> {
    let (from, to) = range.usual_numbers()?;
    match si {
        _ if si == 0.0 => None,
        _ if si < from => Some("small"),
        _ if si > to => Some("large"),
        _ => None,
    }
}

/// Warns about a number in the only unit it can have.
pub(crate) fn check_number(
    value: f64,
    range: &Range,
    unit: &str,
    node: &Node,
    reader: &mut Reader,
) {
    let (Some(side), Some((from, to))) = (unusual(value, range), range.usual_numbers()) else {
        return;
    };
    let message = format!("`{}` is unusually {side}: {}", reader.key, reader.written(node.place));
    let usual = format!("usual are {} to {} {unit}", number_text(from), number_text(to));
    reader.report(Diagnostic::warning(message).at(node.place, usual.trim_end()));
}

/// Warns, once, about numbers without a unit in a case that is shown in field units.
pub fn warn_of_bare(reader: &mut Reader) {
    let bare = std::mem::take(&mut reader.bare);
    let Some(first) = bare.first() else {
        return;
    };
    let mut diagnostic =
        Diagnostic::warning("a number without unit is SI, with units = \"field\" too");
    let mut listing: Vec<&Bare> = Vec::new();
    for number in &bare {
        let of_key = listing.iter().filter(|other| other.key == number.key).count();
        if listing.len() < MAX_BARE && of_key < MAX_BARE_OF_A_KEY {
            diagnostic = diagnostic.at(number.place, &number.text);
            listing.push(number);
        }
    }
    let more = bare.len() - listing.len();
    if more > 0 {
        diagnostic = diagnostic.help(format!("and {more} more"));
    }
    reader.report(diagnostic.help(format!("write the intended unit, such as {}", first.meant)));
}

/// `ppg, sg or g/cm3`.
fn alternatives(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} or {last}", first.join(", ")),
    }
}
