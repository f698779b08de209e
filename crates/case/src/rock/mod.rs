//! `[rock]`: the solid rock, and what drills it.

use serde_json::{Value as Json, json};
use wholestring::rock::{BitShape, DrillingSpec, Rock, RockError};
use wholestring_units::Dimension;

use crate::{
    bit::{BitTable, face_settings},
    diagnostic::Diagnostic,
    quantity::Quantity,
    range::{Number, Range, number_text},
    reader::Reader,
    rule::At,
    source::Place,
    table::{Field, default, optional, table},
};

/// Where the case does not say: bricks across the bit, and over how far the cutters stand out of its body.
const BRICKS_ACROSS: f64 = 18.0;
const OVER_EXPOSURE: f64 = 1.5;
/// From which on the body meets the ridges of the bricks, and the bit jams.
const JAMS: f64 = 1.6;

/// Factor on the density where the case does not say.
const DENSITY_FACTOR: f64 = 400.0;
/// Part of the strength that scaled density times the square of the rim's speed may be: the mean forces then move by
/// less than 5 %.
const MOST_INERTIA: f64 = 0.0625;

/// More bricks than this fill the memory.
const MOST_BRICKS: f64 = 4e6;
/// More brick-steps than this are weeks of computing.
const MOST_BRICK_STEPS: f64 = 3e13;
/// Wider bricks than this part of the bit's diameter make no bottom.
const WIDEST: f64 = 0.25;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn pressure(range: Range, example: &'static str) -> Quantity {
    Quantity::si(Dimension::Pressure, range, example)
}

fn angle(range: Range, example: &'static str) -> Quantity {
    Quantity::si(Dimension::Angle, range, example).bare("deg", DEGREE)
}

fn toughness(example: &'static str) -> Quantity {
    Quantity::si(Dimension::FractureEnergy, Range::positive_to(1e8), example)
}

fn length(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Diameter, Range::positive_to(5.0), example)
}

table! {
    /// The solid rock under the bit: of the law "rock" and of a bit test. Its strength alone is needed, or its
    /// cohesion; the rest is typical of sandstone and limestone.
    RockTable in "[rock]" {
        /// Unconfined compressive strength. Raising it slows the bit down.
        strength: f64 = optional(pressure(Range::from_to(1e5, 1e9), "60 MPa"));
        /// In place of the strength: cohesion of Mohr and Coulomb.
        cohesion: f64 = optional(pressure(Range::from_to(1e4, 1e9), "15 MPa"));
        /// Friction angle of Mohr and Coulomb; a bare number is in deg. Raising it makes the rock the stronger the more it is
        /// confined.
        friction_angle: f64 = default(
            angle(Range::from_to(DEGREE, 70.0 * DEGREE), "35 deg"),
            35.0 * DEGREE,
        );
        /// Dilation angle, at most the friction angle; a bare number is in deg. Raising it lets sheared rock swell and
        /// wedge itself. Default: 10 deg, or the friction angle where that is less.
        dilation_angle: f64 = optional(angle(Range::from_to(0.0, 70.0 * DEGREE), "10 deg"));
        /// Young's modulus. Raising it makes the rock stiffer and more brittle, shortens its steps, and takes more work per
        /// drilled volume: 1.3 times at twice the default, for which `crushing_energy` is calibrated. Default: 300 times the
        /// strength.
        youngs_modulus: f64 = optional(pressure(Range::from_to(1e7, 1e12), "18 GPa"));
        /// Poisson's ratio.
        poisson_ratio: f64 = default(Number { unit: "", range: Range::from_to(0.0, 0.45) }, 0.25);
        /// Density. Raising it lengthens the rock's steps.
        density: f64 = default(
            Quantity::si(Dimension::Density, Range::from_to(500.0, 10_000.0), "2500 kg/m3"),
            2500.0,
        );
        /// Strength in uniaxial tension. Raising it leaves less to chip and more to crush. Default: a tenth of the
        /// strength.
        tensile_strength: f64 = optional(pressure(Range::from_to(1e3, 1e9), "6 MPa"));
        /// Energy that failure takes per volume at the least, in tension and in compression. Raising it raises the bit's work per
        /// drilled volume about as much. Default: 0.085 of the strength, with which that work is about the strength.
        crushing_energy: f64 = optional(pressure(Range::positive_to(1e9), "5 MJ/m3"));
        /// Energy that a tensile crack takes per area. Bricks of more than some millimetres are crushed all through and
        /// do not feel it. Default: 80 J/m2.
        tensile_fracture_energy: f64 = optional(toughness("80 J/m2"));
        /// Energy that a crushed band takes per area. Bricks of more than 2 mm do not feel the default: 2 mm times
        /// `crushing_energy`.
        compressive_fracture_energy: f64 = optional(toughness("8 kJ/m2"));
        /// Pressure of the mud at the bottom over that in the rock's pores. Raising it strengthens the rock.
        pressure: f64 = default(pressure(Range::from_to(0.0, 5e8), "10 MPa"), 0.0);
        /// Initial pressure in the rock across the hole, over that in its pores. Default: that of the mud.
        confinement: f64 = optional(pressure(Range::from_to(0.0, 5e8), "15 MPa"));
        /// Friction between bit and rock. Raising it drags more rock along.
        friction: f64 = default(Number { unit: "", range: Range::from_to(0.0, 2.0) }, 0.3);
        /// Edge of the bricks. Halving it costs eight times the bricks and twice the steps. Default: an eighteenth of the
        /// bit's diameter, or one and a half times what the cutters stand out of its body where that is less.
        element_size: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::from_to(5e-4, 0.2),
            "12 mm",
        ));
        /// Factor on the density of the bricks, for longer steps: twenty times the step at 400. Raising it makes a run
        /// faster, until the rock's inertia is felt in the forces; a warning says from where on.
        density_factor: f64 = default(
            Number { unit: "", range: Range::from_to(1.0, 1e6) },
            DENSITY_FACTOR,
        );
        /// Rock beside the bit, on each side. Default: an eighth of its diameter, two bricks at least.
        beside: f64 = optional(length("27 mm"));
        /// Rock below the bit. Default: a quarter of its diameter, four bricks at least.
        below: f64 = optional(length("54 mm"));
    }
}

fn place<T>(field: &Field<T>) -> Option<Place> {
    field.given().map(|at| at.place)
}

impl RockTable {
    /// The rock; `place` is that of the table.
    fn rock(&self, place: Place, reader: &mut Reader) -> Option<Rock> {
        let friction_angle_rad = *self.friction_angle.get()?;
        let (sin, cos) = friction_angle_rad.sin_cos();
        // Unconfined compressive strength over cohesion.
        let ratio = 2.0 * cos / (1.0 - sin);
        let strength_Pa = match (self.strength.optional()?, self.cohesion.optional()?) {
            (Some(strength), None) => strength.value,
            (None, Some(cohesion)) => cohesion.value * ratio,
            (Some(strength), Some(cohesion)) => {
                reader.report(
                    Diagnostic::error("the strength of the rock is given twice")
                        .at(strength.place, "by what it bears unconfined")
                        .at(cohesion.place, "by its cohesion")
                        .help("keep one of `strength` and `cohesion`; with the friction angle the one follows from the other"),
                );
                return None;
            }
            (None, None) => {
                reader.report(
                    Diagnostic::error("[rock] lacks `strength`")
                        .at(place, "`strength` is missing")
                        .help("such as strength = \"60 MPa\", unconfined and in compression"),
                );
                return None;
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
            (
                &mut rock.tensile_fracture_energy_J_per_m2,
                &self.tensile_fracture_energy,
            ),
            (
                &mut rock.compressive_fracture_energy_J_per_m2,
                &self.compressive_fracture_energy,
            ),
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
            reader.report(diagnostic);
            return None;
        }
        if let Err(error) = rock.check() {
            reader.report(self.unsound(&error, place));
            return None;
        }
        let bears_Pa = rock.largest_tension_Pa();
        if let Some(given) = self.tensile_strength.given()
            && bears_Pa < given.value
        {
            let most = number_text((bears_Pa * 1e-5).round() * 1e-1);
            reader.report(
                Diagnostic::warning("the rock shears before it bears this tension").at(
                    given.place,
                    format!("its cone allows {most} MPa in sum of the principal stresses"),
                ),
            );
        }
        Some(rock)
    }

    /// The mistake, at those of its numbers that stand in the case.
    fn unsound(&self, error: &RockError, whole: Place) -> Diagnostic {
        match error {
            RockError::OutOfRange {
                quantity,
                value,
                expected,
            } => {
                let known = [
                    ("the density", place(&self.density)),
                    ("Young's modulus", place(&self.youngs_modulus)),
                    ("Poisson's ratio", place(&self.poisson_ratio)),
                    ("the cohesion", place(&self.cohesion)),
                    ("the friction angle", place(&self.friction_angle)),
                    ("the dilation angle", place(&self.dilation_angle)),
                    ("the tensile strength", place(&self.tensile_strength)),
                    (
                        "the fracture energy in tension",
                        place(&self.tensile_fracture_energy),
                    ),
                    (
                        "the fracture energy in compression",
                        place(&self.compressive_fracture_energy),
                    ),
                    ("the crushing energy", place(&self.crushing_energy)),
                ];
                let found = known.iter().find(|(name, _)| name == quantity);
                let message = format!("no rock has this: {quantity}");
                Diagnostic::error(message).at(
                    found.and_then(|(_, place)| *place).unwrap_or(whole),
                    format!("expected {expected}, found {}", number_text(*value)),
                )
            }
            RockError::TooLarge { largest_m, .. } => {
                let most = number_text((largest_m * 1e4).floor() * 1e-1);
                Diagnostic::error("the bricks are too large for this rock: they would snap, not soften")
                    .at(
                        place(&self.element_size)
                            .or(place(&self.crushing_energy))
                            .or(place(&self.tensile_fracture_energy))
                            .or(place(&self.compressive_fracture_energy))
                            .unwrap_or(whole),
                        format!("expected bricks below {most} mm"),
                    )
                    .help("raise crushing_energy or youngs_modulus, or lower element_size and raise the fracture energies: a brick holds more elastic energy than its failure takes")
            }
            RockError::Cells(..) => Diagnostic::error(error.to_string())
                .at(place(&self.element_size).unwrap_or(whole), "raise it"),
        }
    }

    /// The rock in bricks under a bit `diameter_m` wide.
    fn drilling(
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
                reader.report(bit.misfit(&error, places.od));
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
            let place = place(&self.element_size)
                .or(place(&self.beside))
                .or(place(&self.below));
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

    /// Warns of bricks so heavy that the bit feels them at a speed.
    pub(crate) fn warn_of_inertia(
        &self,
        spec: &DrillingSpec,
        fastest_rad_per_s: f64,
        whole: Place,
        reader: &mut Reader,
    ) {
        let rock = &spec.block.rock;
        let rim_m_per_s = 0.5 * fastest_rad_per_s * diameter_m(&spec.bit);
        let least_Pa = rock.density_kg_per_m3 * rim_m_per_s.powi(2);
        let most = (MOST_INERTIA * rock.ucs_Pa() / least_Pa).max(1.0);
        if spec.block.numerics.density_factor <= most * (1.0 + 1e-9) {
            return;
        }
        let speed = number_text((fastest_rad_per_s * 30.0 / std::f64::consts::PI).round());
        reader.report(
            Diagnostic::warning(format!(
                "at {speed} rev/min the bit feels the inertia of the rock, whose density is scaled"
            ))
            .at(
                place(&self.density_factor).unwrap_or(whole),
                format!(
                    "expected a density_factor of {} or less",
                    number_text(most.floor())
                ),
            )
            .help("more moves the mean forces by 5 % and beyond"),
        );
    }

    /// What makes the bricks heavy, if it stands in the case.
    pub(crate) fn weighty_place(&self) -> Option<Place> {
        place(&self.density_factor)
            .or(place(&self.element_size))
            .or(place(&self.density))
    }

    /// Refuses what would take weeks: the rock moving for so long.
    pub(crate) fn check_effort(
        &self,
        spec: &DrillingSpec,
        time_s: f64,
        whole: Place,
        reader: &mut Reader,
    ) -> Option<()> {
        let step_s = spec.block.step_s().ok()?;
        if spec.block.bricks() as f64 * time_s / step_s <= MOST_BRICK_STEPS {
            return Some(());
        }
        let message = format!(
            "{} bricks over {} s would take weeks",
            spec.block.bricks(),
            number_text(time_s.round())
        );
        reader.report(
            Diagnostic::error(message)
                .at(
                    place(&self.element_size).unwrap_or(whole),
                    format!(
                        "steps of {} s",
                        number_text(format!("{step_s:.1e}").parse().unwrap_or(step_s))
                    ),
                )
                .help("raise element_size or density_factor, or shorten the time"),
        );
        None
    }
}

fn diameter_m(bit: &BitShape) -> f64 {
    match bit {
        BitShape::Pdc(bit) => bit.diameter_m,
        BitShape::Insert(bit) => bit.diameter_m,
    }
}

/// Where tables stand.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places {
    /// The rock's.
    pub(crate) rock: Place,
    /// The bit's diameter.
    pub(crate) od: Place,
}

/// What the bit drills, if anything asks for solid rock: `asks` is where.
pub(crate) fn drilling(
    table: &Field<RockTable>,
    bit: &BitTable,
    asks: Option<(Place, &str)>,
    lowest: Option<(f64, Place)>,
    reader: &mut Reader,
) -> Option<Option<DrillingSpec>> {
    let rock = match (table.given(), asks) {
        (None, None) => return Some(None),
        (Some(given), None) => {
            reader.report(
                Diagnostic::warning("[rock] has no effect here")
                    .at(given.place, "used with law = \"rock\", and by a bit test")
                    .help("set the law under [bit], or add [bit_test]"),
            );
            return Some(None);
        }
        (None, Some((place, who))) => {
            if !matches!(table, Field::Bad) {
                reader.report(
                    Diagnostic::error(format!("{who} needs a rock"))
                        .at(place, "[rock] is missing")
                        .help("such as [rock] with strength = \"60 MPa\""),
                );
            }
            return None;
        }
        (Some(given), Some(_)) => given,
    };
    build(rock, bit, lowest, reader).map(Some)
}

fn build(
    table: &At<RockTable>,
    bit: &BitTable,
    lowest: Option<(f64, Place)>,
    reader: &mut Reader,
) -> Option<DrillingSpec> {
    let rock = table.value.rock(table.place, reader);
    let (diameter_m, od) = lowest?;
    let shape = bit.shape(0.5 * diameter_m, reader)?;
    let places = Places {
        rock: table.place,
        od,
    };
    table
        .value
        .drilling(rock?, shape, diameter_m, (bit, places), reader)
}

/// The rock in bricks and the bit's face, for the record of a run.
pub(crate) fn settings(spec: &DrillingSpec) -> [Json; 2] {
    let (rock, block) = (&spec.block.rock, &spec.block);
    let json = json!({
        "strength_Pa": rock.ucs_Pa(),
        "cohesion_Pa": rock.cohesion_Pa,
        "friction_angle_rad": rock.friction_angle_rad,
        "dilation_angle_rad": rock.dilation_angle_rad,
        "youngs_modulus_Pa": rock.youngs_modulus_Pa,
        "poisson_ratio": rock.poisson_ratio,
        "density_kg_per_m3": rock.density_kg_per_m3,
        "tensile_strength_Pa": rock.tensile_strength_Pa,
        "tensile_fracture_energy_J_per_m2": rock.tensile_fracture_energy_J_per_m2,
        "crushing_energy_J_per_m3": rock.crushing_energy_J_per_m3,
        "compressive_fracture_energy_J_per_m2": rock.compressive_fracture_energy_J_per_m2,
        "pressure_Pa": block.pressure_Pa,
        "confinement_Pa": block.confinement_Pa,
        "friction": spec.contact.friction,
        "element_size_m": block.size_m[0],
        "density_factor": block.numerics.density_factor,
        "cells": block.cells,
    });
    [json, face_settings(&spec.bit)]
}
