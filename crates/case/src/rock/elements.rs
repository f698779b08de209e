//! The rock cut into elements under a bit.

use wholestring::rock::{BitShape, DrillingSpec, Rock};

use wholestring_units::{Dimension, number_text};

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, source::Span};

use super::table::RockTable;
use crate::bit::{self, BitTable};

/// Defaults: number of elements across the bit, and element size over the exposure of the cutters.
const ELEMENTS_ACROSS: f64 = 18.0;
const OVER_EXPOSURE: f64 = 1.5;
/// Element size over exposure from which the body touches the ridges of the elements, so that the
/// bit jams.
const JAMS: f64 = 1.6;

/// Largest element size as a part of the bit's diameter.
const WIDEST: f64 = 0.25;

/// Maximum number of elements, limited by memory.
const MAX_ELEMENTS: f64 = 4e6;
/// Places of tables.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places {
    /// Place of the rock.
    pub(crate) rock: Span,
    /// Place of the bit's diameter.
    pub(crate) od: Span,
}

impl RockTable {
    /// Builds the rock in elements under a bit `diameter_m` wide.
    pub(super) fn drilling(
        &self,
        rock: Rock,
        shape: BitShape,
        diameter_m: f64,
        (bit, places): (&BitTable, Places),
        reader: &mut Reader,
    ) -> Option<DrillingSpec> {
        let element = self.element_size.optional()?;
        let exposure_m = match shape {
            BitShape::Pdc(bit) => bit.exposure_m,
            BitShape::Insert(bit) => bit.protrusion_m,
        };
        let size_m = element
            .map_or((diameter_m / ELEMENTS_ACROSS).min(OVER_EXPOSURE * exposure_m), |at| at.value);
        if let Some(element) = element.filter(|at| at.value > WIDEST * diameter_m) {
            let most = reader.at_most(Dimension::Diameter, WIDEST * diameter_m);
            return Diagnostic::error("the elements are too large for this bit")
                .at(element.place, format!("expected at most {most}"))
                .at(places.od, "a quarter of its diameter")
                .refuse(reader);
        }
        if let Some(element) = element.filter(|at| at.value > JAMS * exposure_m) {
            let most = reader.at_most(Dimension::Diameter, JAMS * exposure_m);
            Diagnostic::warning("the elements are large for the bit's cutters")
                .at(element.place, format!("expected at most {most}"))
                .help(
                    "its body touches the ridges between the cutters, and the bit jams: lower element_size",
                )
                .report(reader);
        }
        let mut spec = match DrillingSpec::new(rock, shape, size_m) {
            Ok(spec) => spec,
            Err(error) => {
                reader.report(bit::misfit(&error, bit, places.od, reader.units()));
                return None;
            }
        };
        let elements = |m: f64| (m / size_m).ceil() as usize;
        if let Some(beside) = self.beside.optional()? {
            let across = elements(diameter_m) + 2 * elements(beside.value);
            spec.block.cells[0] = across;
            spec.block.cells[1] = across;
        }
        if let Some(below) = self.below.optional()? {
            let above = (spec.wall_m / size_m).round() as usize + 1;
            spec.block.cells[2] = above + elements(below.value).max(2);
        }
        spec.contact.friction = *self.friction.get()?;
        spec.block.pressure_Pa = *self.pressure.get()?;
        let confinement = self.confinement.optional()?;
        spec.block.confinement_Pa = confinement.map_or(spec.block.pressure_Pa, |at| at.value);
        spec.block.numerics.density_factor = *self.density_factor.get()?;
        if let Err(error) = spec.block.step_s() {
            reader.report(self.unsound(&error, places.rock, reader.units()));
            return None;
        }
        let count = spec.block.cells.iter().map(|&n| n as f64).product::<f64>();
        if count > MAX_ELEMENTS {
            let place = self.element_size.place().or(self.beside.place()).or(self.below.place());
            return Diagnostic::error(format!(
                "the rock would be cut into {} elements",
                number_text(count)
            ))
            .at(
                place.unwrap_or(places.rock),
                format!("expected at most {}", number_text(MAX_ELEMENTS)),
            )
            .help("raise element_size")
            .refuse(reader);
        }
        Some(spec)
    }
}
