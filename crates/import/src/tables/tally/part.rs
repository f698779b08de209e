//! A component of a tally before it is written to a case: its length and its metal.

use wholestring_tabular::{Column, TallyCell, TallyRow};
use wholestring_units::Unit;

use super::quote::{origin, quantity, written};
use crate::{
    error::ImportErrorKind,
    fragment::{Block, Origin},
};

/// Reason why a tally cannot be converted to a string, and the place.
pub(crate) type Refusal = (Option<String>, ImportErrorKind);

/// A component: a row, or several identical rows of one joint each.
#[derive(Debug, Clone)]
pub(crate) struct Part<'a> {
    pub(crate) rows: Vec<&'a TallyRow>,
    pub(crate) name: String,
    pub(crate) length: Length,
}

impl<'a> Part<'a> {
    /// The first of its rows, which represents all of them.
    pub(crate) fn row(&self) -> &'a TallyRow {
        self.rows[0]
    }
}

// The length of a component.

/// Length of a component.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Length {
    /// It fills the rest of the string.
    ToSurface,
    /// A given length.
    Of { number: f64, unit: &'static Unit, origin: Origin, joints: Option<f64> },
}

impl Length {
    pub(crate) fn si_m(&self) -> Option<f64> {
        match self {
            Length::ToSurface => None,
            Length::Of { number, unit, .. } => Some(unit.to_si(*number)),
        }
    }
}

// Material of a component of a tally, other than the usual steel.

/// A material column: its key in the case, the minimum and maximum that a case accepts, in SI, and
/// this range in words.
type Kind = (Column, &'static str, [f64; 2], &'static str);

const DENSITY: Kind = (Column::MetalDensity, "density", [1000.0, 25_000.0], "1000 to 25000 kg/m3");
const MODULI: [Kind; 2] = [
    (Column::YoungsModulus, "youngs_modulus", [1e9, 1e12], "1 to 1000 GPa"),
    (Column::ShearModulus, "shear_modulus", [1e9, 1e12], "1 to 1000 GPa"),
];

/// Density of the metal, kg/m³, and its cell; `None` if the table has none.
pub(super) fn density<'a>(part: &Part<'a>) -> Result<Option<(&'a TallyCell, f64)>, Refusal> {
    cell(part, &DENSITY)
}

/// Adds the material keys of the row.
pub(super) fn metal_of(part: &Part, block: &mut Block) -> Result<(), Refusal> {
    for kind in [&DENSITY, &MODULI[0], &MODULI[1]] {
        if let Some((cell, _)) = cell(part, kind)? {
            block.push(kind.1, quantity(cell), origin(cell));
        }
    }
    Ok(())
}

fn cell<'a>(
    part: &Part<'a>,
    (column, _, [least, most], expected): &Kind,
) -> Result<Option<(&'a TallyCell, f64)>, Refusal> {
    let cell = part.row().get(*column);
    let Some((cell, si)) = cell.and_then(|cell| Some((cell, cell.si().filter(|si| *si != 0.0)?)))
    else {
        return Ok(None);
    };
    if (*least..=*most).contains(&si) {
        return Ok(Some((cell, si)));
    }
    let kind = ImportErrorKind::OutOfRange {
        what: format!("{column} of '{}'", part.name),
        found: written(cell),
        expected: (*expected).to_owned(),
    };
    Err((Some(cell.place.clone()), kind))
}
