//! How heavy the elements may be, and how long they may move.

use wholestring::rock::{BitShape, DrillingSpec};

use wholestring_units::number_text;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, source::Span};

use super::table::RockTable;

/// Part of the strength that scaled density times the square of the rim's speed may be: the mean
/// forces then move by less than 5 %.
const MAX_INERTIA: f64 = 0.0625;

/// More element-steps than this are weeks of computing.
const MAX_ELEMENT_STEPS: f64 = 3e13;
impl RockTable {
    /// Warns of elements so heavy that the bit feels them at a speed.
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

    /// What makes the elements heavy, if it stands in the case.
    pub(crate) fn weighty_place(&self) -> Option<Span> {
        self.density_factor.place().or(self.element_size.place()).or(self.density.place())
    }

    /// Refuses what would take weeks: the rock moving for so long.
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
                format!(
                    "steps of {} s",
                    number_text(format!("{step_s:.1e}").parse().unwrap_or(step_s))
                ),
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
