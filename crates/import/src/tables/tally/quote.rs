//! Text of cells and values, for a case and for messages.

use wholestring_tabular::{Holds, TallyCell};
use wholestring_units::{Dimension, Unit, number_text};

use crate::fragment::{Origin, Value};

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
