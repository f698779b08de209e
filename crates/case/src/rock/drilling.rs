//! The rock under the bit.

use wholestring::rock::DrillingSpec;
use wholestring_config::prelude::*;

use super::{elements::Places, table::RockTable};
use crate::bit::BitTable;

/// Returns the rock under the bit, if anything requires solid rock: `required_by` is the place of
/// the requirement.
pub(crate) fn drilling(
    table: &Field<RockTable>,
    bit: &BitTable,
    required_by: Option<(Span, &str)>,
    lowest: Option<(f64, Span)>,
    reader: &mut Reader,
) -> Option<Option<DrillingSpec>> {
    let rock = match (table.given(), required_by) {
        (None, None) => return Some(None),
        (Some(entry), None) => {
            Diagnostic::warning("[rock] has no effect here")
                .at(entry.place, "used with law = \"rock\", and by a bit test")
                .help("set the law under [bit], or add [bit_test]")
                .report(reader);
            return Some(None);
        }
        (None, Some((place, who))) => {
            if !matches!(table, Field::Bad) {
                Diagnostic::error(format!("{who} needs a rock"))
                    .at(place, "[rock] is missing")
                    .help("such as [rock] with strength = \"60 MPa\"")
                    .report(reader);
            }
            return None;
        }
        (Some(entry), Some(_)) => entry,
    };
    build(rock, bit, lowest, reader).map(Some)
}

fn build(
    table: &Spanned<RockTable>,
    bit: &BitTable,
    lowest: Option<(f64, Span)>,
    reader: &mut Reader,
) -> Option<DrillingSpec> {
    let rock = table.value.rock(table.place, reader);
    let (diameter_m, od) = lowest?;
    let shape = bit.shape(0.5 * diameter_m, reader)?;
    let places = Places { rock: table.place, od };
    table.value.drilling(rock?, shape, diameter_m, (bit, places), reader)
}
