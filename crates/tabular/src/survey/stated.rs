//! Values of stations in a file that are not needed to compute the path: columns with which a
//! reading is checked.

use wholestring_units::{Dimension, Unit};

use super::{imported::StatedPosition, reader::Reader};
use crate::{
    cells::table::{Row, Table},
    columns::{column::Column, heading, layout::Layout},
};

/// The column of dogleg severities and its unit.
pub(crate) struct Dogleg {
    index: usize,
    unit: &'static Unit,
}

impl Dogleg {
    /// Returns the column, if there is one with a unit.
    pub(crate) fn of(table: &Table, layout: &Layout) -> Option<Self> {
        let is_dogleg = |text: &String| {
            let plain: String = text.chars().filter(|c| c.is_alphabetic()).collect();
            let plain = plain.to_lowercase();
            plain.starts_with("dls") || plain.starts_with("dogleg") || plain.starts_with("dlsev")
        };
        let index = layout.header.iter().position(is_dogleg)?;
        let find = |text: &str| Dimension::DoglegSeverity.find_unit(text);
        let (_, brackets) = heading::part_brackets(&layout.header[index]);
        let in_row = || {
            let row = table.rows.get(layout.data.checked_sub(1)?)?;
            find(heading::bare_unit(row.text(index)))
        };
        let unit = brackets.iter().find_map(|bracket| find(bracket)).or_else(in_row)?;
        Some(Self { index, unit })
    }
}

/// Values of a station in a row; `None` for those that are not numbers.
pub(crate) fn position(
    reader: &Reader,
    layout: &Layout,
    dogleg: Option<&Dogleg>,
    row: &Row,
) -> StatedPosition {
    let length_m = |column: Column| {
        let found = layout.column(column)?;
        let cell = row.cells.get(found.index)?;
        reader.number(cell, column, found.unit).filter(|_| !reader.is_null(cell, column))
    };
    let dogleg_severity_rad_per_m = dogleg.and_then(|dogleg| {
        reader.number(row.cells.get(dogleg.index)?, Column::Inclination, dogleg.unit)
    });
    StatedPosition {
        tvd_m: length_m(Column::TrueVerticalDepth),
        north_m: length_m(Column::North),
        east_m: length_m(Column::East),
        dogleg_severity_rad_per_m,
    }
}
