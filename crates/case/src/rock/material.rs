//! The rock material: strength, stiffness, toughness.

use wholestring::rock::{Rock, RockError, RockNumber};

use wholestring_units::{Dimension, UnitSet, number_text};

use wholestring_config::{
    diagnostic::Diagnostic,
    reader::{Reader, at_most},
    source::Span,
};

use super::table::{DEGREE, RockTable};

impl RockTable {
    /// Builds the rock; `place` is that of the table.
    pub(super) fn rock(&self, place: Span, reader: &mut Reader) -> Option<Rock> {
        let friction_angle_rad = *self.friction_angle.get()?;
        let (sin, cos) = libm::sincos(friction_angle_rad);
        // Unconfined compressive strength over cohesion.
        let ratio = 2.0 * cos / (1.0 - sin);
        let strength_Pa = match (self.strength.optional()?, self.cohesion.optional()?) {
            (Some(strength), None) => strength.value,
            (None, Some(cohesion)) => cohesion.value * ratio,
            (Some(strength), Some(cohesion)) => {
                return Diagnostic::error("the strength of the rock is given twice")
                    .at(strength.place, "by its unconfined strength")
                    .at(cohesion.place, "by its cohesion")
                    .help(
                        "keep one of `strength` and `cohesion`; with the friction angle the \
                               one follows from the other",
                    )
                    .refuse(reader);
            }
            (None, None) => {
                return Diagnostic::error("[rock] lacks `strength`")
                    .at(place, "`strength` is missing")
                    .help("such as strength = \"60 MPa\", unconfined and in compression")
                    .refuse(reader);
            }
        };
        let mut rock = Rock::for_drilling(strength_Pa);
        rock.cohesion_Pa = strength_Pa / ratio;
        rock.friction_angle_rad = friction_angle_rad;
        rock.dilation_angle_rad = rock.dilation_angle_rad.min(friction_angle_rad);
        rock.poisson_ratio = *self.poisson_ratio.get()?;
        rock.density_kg_per_m3 = *self.density.get()?;
        if let Some(crushing) = self.crushing_energy.optional()? {
            rock.compressive_fracture_energy_J_per_m2 *=
                crushing.value / rock.crushing_energy_J_per_m3;
            rock.crushing_energy_J_per_m3 = crushing.value;
        }
        for (number, field) in [
            (&mut rock.dilation_angle_rad, &self.dilation_angle),
            (&mut rock.youngs_modulus_Pa, &self.youngs_modulus),
            (&mut rock.tensile_strength_Pa, &self.tensile_strength),
            (&mut rock.tensile_fracture_energy_J_per_m2, &self.tensile_fracture_energy),
            (&mut rock.compressive_fracture_energy_J_per_m2, &self.compressive_fracture_energy),
        ] {
            if let Some(at) = field.optional()? {
                *number = at.value;
            }
        }
        if let Some(dilation) = self.dilation_angle.given()
            && dilation.value > friction_angle_rad
        {
            let most = number_text((friction_angle_rad / DEGREE * 1e3).round() * 1e-3);
            let mut diagnostic =
                Diagnostic::error("the rock's dilation angle is larger than its friction angle")
                    .at(dilation.place, format!("expected at most {most} deg"));
            if let Some(friction) = self.friction_angle.given() {
                diagnostic = diagnostic.at(friction.place, "the friction angle");
            }
            return diagnostic.refuse(reader);
        }
        if let Err(error) = rock.check() {
            reader.report(self.unsound(&error, place, reader.units()));
            return None;
        }
        let bears_Pa = rock.largest_tension_Pa();
        if let Some(entry) = self.tensile_strength.given()
            && bears_Pa < entry.value
        {
            let most = reader.shown(Dimension::Stress, bears_Pa);
            Diagnostic::warning("the rock shears before it reaches this tension")
                .at(entry.place, format!("its cone allows {most} in sum of the principal stresses"))
                .report(reader);
        }
        Some(rock)
    }

    /// Returns the mistake, at those of its numbers that the case gives.
    pub(super) fn unsound(&self, error: &RockError, whole: Span, units: UnitSet) -> Diagnostic {
        match error {
            RockError::OutOfRange { number, value, expected } => {
                let place = match number {
                    RockNumber::Density => self.density.place(),
                    RockNumber::YoungsModulus => self.youngs_modulus.place(),
                    RockNumber::PoissonRatio => self.poisson_ratio.place(),
                    RockNumber::Cohesion => self.cohesion.place(),
                    RockNumber::FrictionAngle => self.friction_angle.place(),
                    RockNumber::DilationAngle => self.dilation_angle.place(),
                    RockNumber::TensileStrength => self.tensile_strength.place(),
                    RockNumber::TensileFractureEnergy => self.tensile_fracture_energy.place(),
                    RockNumber::CompressiveFractureEnergy => {
                        self.compressive_fracture_energy.place()
                    }
                    RockNumber::CrushingEnergy => self.crushing_energy.place(),
                };
                Diagnostic::error(format!("no rock has this: {number}")).at(
                    place.unwrap_or(whole),
                    format!("expected {expected}, found {}", number_text(*value)),
                )
            }
            RockError::TooLarge { largest_m, .. } => {
                let most = at_most(Dimension::Diameter, *largest_m, units);
                Diagnostic::error(
                    "the elements are too large for this rock: they would snap, not \
                                   soften",
                )
                .at(
                    self.element_size
                        .place()
                        .or(self.crushing_energy.place())
                        .or(self.tensile_fracture_energy.place())
                        .or(self.compressive_fracture_energy.place())
                        .unwrap_or(whole),
                    format!("expected elements below {most}"),
                )
                .help(
                    "raise crushing_energy or youngs_modulus, or lower element_size and raise the \
                     fracture energies: an element stores more elastic energy than its failure \
                     absorbs",
                )
            }
            RockError::Cells(..) => Diagnostic::error(error.to_string())
                .at(self.element_size.place().unwrap_or(whole), "raise it"),
        }
    }
}
