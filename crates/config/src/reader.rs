//! Collects the mistakes while a case is read, so that all are reported at once.

use serde_json::Value as Json;
use wholestring_units::{Dimension, UnitSet, number_text};

use crate::{
    bare::Bare,
    diagnostic::{Diagnostic, Report, Severity},
    kind::Kind,
    names::{nearest, short},
    node::{Entries, Node, Value},
    schema::homes_of,
    source::{COMMAND_LINE, Source, Span},
};

/// The texts read so far and the mistakes found in them.
#[derive(Debug, Default)]
pub struct Reader {
    /// The texts, in the order in which they were read.
    pub sources: Vec<Source>,
    /// The key whose value is being read, for messages.
    pub key: &'static str,
    /// Numbers without a unit that may have been intended in a unit other than SI.
    pub(crate) bare: Vec<Bare>,
    /// The display units.
    units: Option<UnitSet>,
    /// Places where a number without a unit is refused.
    asking: Vec<Span>,
    diagnostics: Vec<Diagnostic>,
    /// Whether diagnostics are discarded.
    is_muted: bool,
    /// The kind of file; none for arguments.
    kind: Option<&'static Kind>,
}

impl Diagnostic {
    /// Adds it to the reader's diagnostics.
    pub fn report(self, reader: &mut Reader) {
        reader.report(self);
    }

    /// Adds it to the reader's diagnostics, and returns no value.
    pub fn refuse<T>(self, reader: &mut Reader) -> Option<T> {
        reader.report(self);
        None
    }
}

/// A quantity in the units of a set, to a thousandth of its unit.
pub fn shown(dimension: Dimension, si: f64, set: UnitSet) -> String {
    rounded(dimension, si, set, f64::round)
}

/// The same rounded up, so that the written bound is valid.
pub fn at_least(dimension: Dimension, si: f64, set: UnitSet) -> String {
    rounded(dimension, si, set, |thousandths| (thousandths - LAST_DIGITS).ceil())
}

/// The same rounded down.
pub fn at_most(dimension: Dimension, si: f64, set: UnitSet) -> String {
    rounded(dimension, si, set, |thousandths| (thousandths + LAST_DIGITS).floor())
}

/// Tolerance for converted whole numbers, in thousandths of a unit.
const LAST_DIGITS: f64 = 1e-6;

fn rounded(dimension: Dimension, si: f64, set: UnitSet, round: fn(f64) -> f64) -> String {
    let unit = dimension.unit_in(set);
    let value = unit.from_si(si);
    let value = if value.abs() < 1.0 { value } else { round(value * 1e3) / 1e3 };
    format!("{} {}", number_text(value), unit.symbol)
}

/// Maximum number of mistakes kept: with more, the file is probably something else.
const MAX: usize = 100;

impl Reader {
    /// A reader of this kind of file.
    pub fn of(kind: &'static Kind) -> Self {
        Self { kind: Some(kind), ..Self::default() }
    }

    /// The schema of the tables of the file; none for arguments.
    pub fn tables(&self) -> Option<&'static Json> {
        self.kind.map(|kind| (kind.tables)())
    }

    /// Adds a text that places can refer to, and returns its index.
    pub fn add_source(&mut self, name: &str, text: &str) -> usize {
        self.sources.push(Source { name: name.to_owned(), text: text.to_owned() });
        self.sources.len() - 1
    }

    /// The display units of the case.
    pub fn units(&self) -> UnitSet {
        self.units.unwrap_or(UnitSet::Si)
    }

    /// A quantity in the display units of the case, to a thousandth of its unit.
    pub fn shown(&self, dimension: Dimension, si: f64) -> String {
        shown(dimension, si, self.units())
    }

    /// The same rounded up, for "at least".
    pub fn at_least(&self, dimension: Dimension, si: f64) -> String {
        at_least(dimension, si, self.units())
    }

    /// The same rounded down, for "at most".
    pub fn at_most(&self, dimension: Dimension, si: f64) -> String {
        at_most(dimension, si, self.units())
    }

    /// Sets the display units of the case.
    pub fn show_in(&mut self, units: UnitSet) {
        self.units = Some(units);
    }

    /// Requires a unit for this number, or each of this list, if it is read as a quantity, because
    /// a shell may have removed the quotes and the missing unit has no meaning.
    pub fn ask_unit(&mut self, node: &Node) {
        let items = match &node.value {
            Value::List(items) => items.as_slice(),
            _ => std::slice::from_ref(node),
        };
        let numbers = items.iter().filter(|item| matches!(item.value, Value::Number { .. }));
        self.asking.extend(numbers.map(|number| number.place));
    }

    /// Whether a number at this place is refused without a unit.
    pub fn asks_unit(&self, place: Span) -> bool {
        self.asking.contains(&place)
    }

    /// Whether a place is in an argument of the command.
    pub fn is_argument(&self, place: Span) -> bool {
        let source = self.sources.get(place.source);
        source.is_some_and(|source| source.name == COMMAND_LINE)
    }

    /// Reads a value again without reporting its mistakes twice.
    pub(crate) fn muted<T>(&mut self, read: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.is_muted, true);
        let value = read(self);
        self.is_muted = before;
        value
    }

    /// Records a number without a unit that may have been intended in another one.
    pub(crate) fn note_bare(&mut self, bare: Bare) {
        if !self.is_muted {
            self.bare.push(bare);
        }
    }

    /// Keeps a diagnostic, unless there are too many already.
    pub fn report(&mut self, diagnostic: Diagnostic) {
        if self.is_muted {
            return;
        }
        if self.diagnostics.len() >= MAX {
            if diagnostic.severity == Severity::Warning || self.has_errors() {
                return;
            }
            // An error is never dropped in favour of warnings.
            self.diagnostics.pop();
        }
        self.diagnostics.push(diagnostic);
    }

    /// Whether there is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }

    /// All diagnostics, in the order of their places.
    pub fn into_report(self) -> Report {
        let diagnostics = self.diagnostics;
        // One argument may set several values, each with a mistake.
        let mut unique: Vec<Diagnostic> = Vec::new();
        for diagnostic in diagnostics {
            if !unique.contains(&diagnostic) {
                unique.push(diagnostic);
            }
        }
        let mut diagnostics = unique;
        diagnostics.sort_by_key(|diagnostic| {
            let place = diagnostic.labels.first().map(|label| label.place);
            place.map_or((0, 0), |place| (place.source, place.start))
        });
        Report { sources: self.sources, diagnostics }
    }

    /// The user's text at a place, shortened for quoting.
    pub fn written(&self, place: Span) -> String {
        short(self.text_at(place))
    }

    /// The user's text at a place.
    pub fn text_at(&self, place: Span) -> &str {
        let text = self.sources.get(place.source).map(|source| &source.text);
        text.and_then(|text| text.get(place.start..place.end)).unwrap_or_default()
    }

    /// A value of the wrong kind.
    pub fn expected(&mut self, node: &Node, expected: &str) {
        let message = format!("`{}` cannot be {}", self.key, node.value.noun());
        self.report(Diagnostic::error(message).at(node.place, format!("expected {expected}")));
    }

    /// The table at a node.
    pub fn table<'a>(&mut self, node: &'a Node, heading: &str) -> Option<&'a Entries> {
        if let Value::Table(entries) = &node.value {
            return Some(entries);
        }
        let mut diagnostic = Diagnostic::error(format!(
            "{heading} is a table with keys, found {}",
            node.value.noun()
        ))
        .at(node.place, "expected a table");
        if let Value::List(items) = &node.value
            && matches!(items.first().map(|item| &item.value), Some(Value::Table(_)))
        {
            diagnostic = diagnostic.help("there is one of it, not a list: write single brackets");
        }
        self.report(diagnostic);
        None
    }

    /// Reports the keys of a table that are not in `names`, and returns the names that they were
    /// probably meant to be.
    pub fn check_names(
        &mut self,
        table: &Entries,
        names: &[&'static str],
        heading: &str,
    ) -> Vec<&'static str> {
        let mut meant = Vec::new();
        for (key, _) in &table.0 {
            if names.contains(&key.name.as_str()) || self.diagnostics.len() >= MAX {
                continue;
            }
            let mut diagnostic =
                Diagnostic::error(format!("unknown key `{}` in {heading}", short(&key.name)))
                    .at(key.place, "unknown key");
            let tables = self.tables();
            let homes = tables.map_or_else(Vec::new, |tables| homes_of(tables, &key.name));
            if let Some(nearest) = nearest(&key.name, names.iter().copied()) {
                diagnostic = diagnostic.help(format!("did you mean `{nearest}`?"));
                meant.push(nearest);
            } else if !homes.is_empty() {
                diagnostic =
                    diagnostic.help(format!("`{}` belongs to {}", key.name, homes.join(", ")));
            }
            diagnostic = diagnostic.help(format!("keys of {heading}: {}", names.join(", ")));
            self.report(diagnostic);
        }
        meant
    }
}
