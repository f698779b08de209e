//! The rock under the bit.

use wholestring::rock::{BitShape, DrillingSpec};
use wholestring_config::{diagnostic::Diagnostic, prelude::*, reader::Reader, source::Span};
use wholestring_units::{number_text, significant};

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

// Limits of the inertia of the elements and of their simulated time.

/// Limit of scaled density times the square of the rim's speed, as a part of the strength: below it
/// the mean forces move by less than 5 %.
const MAX_INERTIA: f64 = 0.0625;

/// Maximum number of element-steps; more are weeks of computing.
const MAX_ELEMENT_STEPS: f64 = 3e13;
impl RockTable {
    /// Warns of elements whose inertia affects the forces on the bit at a speed.
    pub(crate) fn warn_of_inertia(
        &self,
        spec: &DrillingSpec,
        fastest_rad_per_s: f64,
        whole: Span,
        reader: &mut Reader,
    ) {
        let rock = &spec.block.rock;
        let rim_m_per_s = 0.5 * fastest_rad_per_s * diameter_m(&spec.bit);
        let min_Pa = rock.density_kg_per_m3 * rim_m_per_s.powi(2);
        let most = (MAX_INERTIA * rock.ucs_Pa() / min_Pa).max(1.0);
        if spec.block.numerics.density_factor <= most * (1.0 + 1e-9) {
            return;
        }
        let speed = number_text((fastest_rad_per_s * 30.0 / std::f64::consts::PI).round());
        Diagnostic::warning(format!(
            "at {speed} rev/min the bit feels the inertia of the rock, whose density is scaled"
        ))
        .at(
            self.density_factor.place().unwrap_or(whole),
            format!("expected a density_factor of {} or less", number_text(most.floor())),
        )
        .help("more moves the mean forces by 5 % and beyond")
        .report(reader);
    }

    /// Returns the place of the key that makes the elements heavy, if the case has it.
    pub(crate) fn weighty_place(&self) -> Option<Span> {
        self.density_factor.place().or(self.element_size.place()).or(self.density.place())
    }

    /// Refuses a duration of moving rock that would take weeks to compute.
    pub(crate) fn check_effort(
        &self,
        spec: &DrillingSpec,
        time_s: f64,
        whole: Span,
        reader: &mut Reader,
    ) -> Option<()> {
        let step_s = spec.block.step_s().ok()?;
        if spec.block.elements() as f64 * time_s / step_s <= MAX_ELEMENT_STEPS {
            return Some(());
        }
        let message = format!(
            "{} elements over {} s would take weeks",
            spec.block.elements(),
            number_text(time_s.round())
        );
        Diagnostic::error(message)
            .at(
                self.element_size.place().unwrap_or(whole),
                format!("steps of {} s", number_text(significant(step_s, 2))),
            )
            .help("raise element_size or density_factor, or shorten the time")
            .refuse(reader)
    }
}

fn diameter_m(bit: &BitShape) -> f64 {
    match bit {
        BitShape::Pdc(bit) => bit.diameter_m,
        BitShape::Insert(bit) => bit.diameter_m,
    }
}
