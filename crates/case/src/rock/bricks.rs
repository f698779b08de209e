//! The rock cut into bricks under a bit.

use wholestring::rock::{BitShape, DrillingSpec, Rock};

use wholestring_units::number_text;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, source::Place};

use super::table::RockTable;
use crate::bit::{self, BitTable};

/// Where the case does not say: bricks across the bit, and over how far the cutters stand out of its body.
const BRICKS_ACROSS: f64 = 18.0;
const OVER_EXPOSURE: f64 = 1.5;
/// From which on the body meets the ridges of the bricks, and the bit jams.
const JAMS: f64 = 1.6;

/// Wider bricks than this part of the bit's diameter make no bottom.
const WIDEST: f64 = 0.25;

/// More bricks than this fill the memory.
const MOST_BRICKS: f64 = 4e6;
/// Where tables stand.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places {
    /// The rock's.
    pub(crate) rock: Place,
    /// The bit's diameter.
    pub(crate) od: Place,
}

impl RockTable {
    /// The rock in bricks under a bit `diameter_m` wide.
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
        let size_m = element.map_or(
            (diameter_m / BRICKS_ACROSS).min(OVER_EXPOSURE * exposure_m),
            |at| at.value,
        );
        if let Some(element) = element.filter(|at| at.value > WIDEST * diameter_m) {
            let most = number_text((WIDEST * diameter_m * 1e4).floor() * 1e-1);
            reader.report(
                Diagnostic::error("the bricks are too large for this bit")
                    .at(element.place, format!("expected at most {most} mm"))
                    .at(places.od, "a quarter of its diameter"),
            );
            return None;
        }
        if let Some(element) = element.filter(|at| at.value > JAMS * exposure_m) {
            let most = number_text((JAMS * exposure_m * 1e4).floor() * 1e-1);
            reader.report(
                Diagnostic::warning("the bricks are large for the bit's cutters")
                    .at(element.place, format!("expected at most {most} mm"))
                    .help("its body meets the ridges between the cutters, and the bit jams: lower element_size"),
            );
        }
        let mut spec = match DrillingSpec::new(rock, shape, size_m) {
            Ok(spec) => spec,
            Err(error) => {
                reader.report(bit::misfit(&error, bit, places.od));
                return None;
            }
        };
        let bricks = |m: f64| (m / size_m).ceil() as usize;
        if let Some(beside) = self.beside.optional()? {
            let across = bricks(diameter_m) + 2 * bricks(beside.value);
            spec.block.cells[0] = across;
            spec.block.cells[1] = across;
        }
        if let Some(below) = self.below.optional()? {
            let above = (spec.wall_m / size_m).round() as usize + 1;
            spec.block.cells[2] = above + bricks(below.value).max(2);
        }
        spec.contact.friction = *self.friction.get()?;
        spec.block.pressure_Pa = *self.pressure.get()?;
        let confinement = self.confinement.optional()?;
        spec.block.confinement_Pa = confinement.map_or(spec.block.pressure_Pa, |at| at.value);
        spec.block.numerics.density_factor = *self.density_factor.get()?;
        if let Err(error) = spec.block.step_s() {
            reader.report(self.unsound(&error, places.rock));
            return None;
        }
        let count = spec.block.cells.iter().map(|&n| n as f64).product::<f64>();
        if count > MOST_BRICKS {
            let place = self
                .element_size
                .place()
                .or(self.beside.place())
                .or(self.below.place());
            reader.report(
                Diagnostic::error(format!(
                    "the rock would be cut into {} bricks",
                    number_text(count)
                ))
                .at(
                    place.unwrap_or(places.rock),
                    format!("expected at most {}", number_text(MOST_BRICKS)),
                )
                .help("raise element_size"),
            );
            return None;
        }
        Some(spec)
    }
}
