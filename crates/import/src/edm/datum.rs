//! Reference of depths.

use super::{
    chooser::{Chosen, label},
    reader::{Reader, parent},
    row::Row,
    table::Table,
    unit_set::{Found, Measure},
};
use crate::{error::ImportError, fragment::Value};

/// Tolerance within which elevations are equal, m.
const SAME_M: f64 = 0.05;

/// Shift of the depths in a file so that they begin at the rig's datum.
///
/// Landmark's applications count depths from a datum of the rig. Stored depths may begin at the
/// system's datum below it, such as the mean sea level; the surface is then at minus the elevation
/// of the rig's datum.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Depths {
    pub(super) shift_m: f64,
}

impl Depths {
    /// Determines it from the depth of the first station, and adds a note on the datum.
    pub(super) fn found<'a>(
        reader: &mut Reader<'a>,
        chosen: &Chosen<'a>,
        first: Found,
    ) -> Result<Self, ImportError> {
        let datum = datum(reader, chosen)?;
        let elevation = match datum {
            Some(row) => reader.units.quantity(row, "datum_elevation", Measure::Length)?,
            None => None,
        };
        let name = match (datum, elevation) {
            (Some(row), Some(elevation)) => {
                format!("'{}' at an elevation of {}", label(row), elevation.text())
            }
            (Some(row), None) => format!("'{}'", label(row)),
            (None, _) => "of the rig, which the file does not name".to_owned(),
        };
        if first.si() >= 0.0 {
            reader.assumed(format!("depths are counted from the datum {name}"));
            return Ok(Self::default());
        }
        let shift_m = -first.si();
        let agrees = elevation.is_some_and(|own| (own.si() - shift_m).abs() < SAME_M);
        let text = format!(
            "the path begins at {}: depths of the file are counted from {}, and were moved to begin \
             at the datum {name}",
            first.text(),
            if agrees { "mean sea level or similar" } else { "elsewhere" }
        );
        match agrees {
            true => reader.checked(text),
            false => reader.assumed(text),
        }
        Ok(Self { shift_m })
    }

    /// A depth from the datum, in the unit of the file.
    pub(super) fn moved(self, found: Found) -> Value {
        if self.shift_m == 0.0 {
            return found.value();
        }
        let number = found.unit.from_si(found.si() + self.shift_m);
        Value::quantity((number * 1e4).round() / 1e4, found.unit)
    }
}

/// The datum of the case, or the default one of the well.
fn datum<'a>(reader: &mut Reader<'a>, chosen: &Chosen<'a>) -> Result<Option<Row<'a>>, ImportError> {
    for (what, row) in [("case", chosen.case), ("scenario", chosen.scenario)] {
        let Some((row, id)) = row.and_then(|row| Some((row, row.get("datum_id")?))) else {
            continue;
        };
        let found = parent(reader.rows, Table::Datum, row, &["well_id", "datum_id"])?;
        if found.is_some() {
            return Ok(found);
        }
        reader.warning(format!(
            "the {what} refers to the datum '{id}', which the file does not have; depths may begin \
             elsewhere"
        ));
    }
    let Some(id) = chosen.well.and_then(|well| well.get("well_id")) else { return Ok(None) };
    let own = || reader.rows.of(Table::Datum).filter(move |row| row.get("well_id") == Some(id));
    let default = own().find(|row| row.get("is_default") == Some("Y"));
    Ok(default.or_else(|| if own().count() == 1 { own().next() } else { None }))
}
