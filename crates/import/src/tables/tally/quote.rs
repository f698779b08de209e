//! Text of cells and values, and notes that combine several components.

use wholestring_tabular::{Holds, TallyCell};
use wholestring_units::{Dimension, Unit, number_text};

use crate::fragment::{Note, Origin, Value};

/// Returns a unit by its symbol.
pub(crate) fn unit(dimension: Dimension, symbol: &str) -> &'static Unit {
    dimension.find_unit(symbol).unwrap_or(&dimension.units()[0])
}

/// Origin of a cell's value, with the written text if the value differs from it.
pub(crate) fn origin(cell: &TallyCell) -> Origin {
    let shows = match cell.holds {
        Holds::Quantity { number, .. } | Holds::Count(number) => {
            number_text(number) == cell.written
        }
        Holds::Words => true,
        Holds::ToSurface => false,
    };
    if shows { Origin::at(&cell.place) } else { Origin::written(&cell.place, &cell.written) }
}

/// The cell as a value of a case.
pub(crate) fn quantity(cell: &TallyCell) -> Value {
    match cell.holds {
        Holds::Quantity { number, unit, .. } => Value::quantity(number, unit),
        Holds::Count(number) => Value::Number(number),
        Holds::Words | Holds::ToSurface => Value::text(&cell.written),
    }
}

/// The cell with its unit, for messages.
pub(crate) fn written(cell: &TallyCell) -> String {
    shown(&quantity(cell))
}

/// A value, for messages.
pub(crate) fn shown(value: &Value) -> String {
    match value {
        Value::Quantity { number, unit } => {
            format!("{} {}", number_text(*number), unit.symbol)
        }
        Value::Number(number) => number_text(*number),
        Value::Text(text) => text.clone(),
        Value::Words(words) => words.join(", "),
    }
}

// Notes that combine several components.

/// Notes that combine several components.
#[derive(Debug, Default)]
pub(crate) struct Said {
    /// Blades without a length.
    pub(crate) bladed: Vec<String>,
    /// Components called stabilisers, without a gauge.
    pub(crate) bladeless: Vec<String>,
    /// Pipe without a weight.
    pub(crate) unweighed_pipe: Vec<String>,
    /// Components without a weight.
    pub(crate) unweighed: Vec<String>,
    /// Components with a nominal weight only.
    pub(crate) nominal: Vec<String>,
    /// Grades with unknown yield strength, each with a component and its place.
    pub(crate) grades: Vec<(String, String)>,
}

impl Said {
    pub(crate) fn tell(self, notes: &mut Vec<Note>) {
        let mut tell = |names: Vec<String>, text: &str| {
            if names.is_empty() {
                return;
            }
            let names: Vec<String> = names.iter().map(|name| format!("'{name}'")).collect();
            notes.push(Note::Assumed(format!("{}: {text}", names.join(", "))));
        };
        tell(
            self.bladed,
            "the gauge is assumed for blades along the whole component; give blade_length if they \
             are shorter",
        );
        tell(
            self.bladeless,
            "called a stabiliser or reamer, and without a gauge: it touches the wall with its body; \
             give blade_od",
        );
        tell(
            self.unweighed_pipe,
            "no weight; computed from the diameters as steel, WITHOUT TOOL JOINTS, which make pipe a \
             tenth heavier or more: give mass_per_length, or catalogue",
        );
        tell(self.unweighed, "no weight; computed from the diameters as steel");
        tell(self.nominal, "the nominal weight is used as the weight, without tool joints");
        for (grade, first, count) in counted(&self.grades) {
            let others = match count {
                1 => String::new(),
                count => format!(" and {} more", count - 1),
            };
            notes.push(Note::LeftOut(format!(
                "the grade '{grade}' of {first}{others}: its yield strength is not known; give \
                 yield_strength"
            )));
        }
    }
}

/// Each grade once, with the first component that has it and the number of components.
fn counted(grades: &[(String, String)]) -> Vec<(&str, &str, usize)> {
    let mut counted: Vec<(&str, &str, usize)> = Vec::new();
    for (grade, component) in grades {
        match counted.iter_mut().find(|(known, ..)| known == grade) {
            Some((.., count)) => *count += 1,
            None => counted.push((grade, component, 1)),
        }
    }
    counted
}
