//! Sections of the hole: casing and open hole.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::Roughness;

/// Material of the wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum HoleKind {
    /// Steel casing or liner.
    Casing,
    /// Rock.
    Open,
}

impl HoleKind {
    /// Young's modulus, Pa, and Poisson's ratio of a wall by default: steel, and the rock of Table
    /// 1 of *New Analysis Theory and Method for Drag and Torque Based on Full-Hole System Dynamics
    /// in Highly Deviated Well*.
    pub const fn elastic_constants(self) -> (f64, f64) {
        match self {
            Self::Casing => (210e9, 0.3),
            Self::Open => (51.5e9, 0.33),
        }
    }
}

/// Coulomb friction of a wall.
///
/// Along the hole and around it the coefficient may differ: a pipe that turns rolls over cuttings
/// that it ploughs when it slides.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Friction {
    /// Coefficient while sliding along the hole.
    pub kinetic: f64,
    /// Coefficient at rest along the hole; at least the kinetic one.
    pub at_rest: f64,
    /// Factor of both around the hole.
    pub around: f64,
}

impl Friction {
    /// The same coefficient at rest and sliding, along the hole and around it.
    pub const fn uniform(coefficient: f64) -> Self {
        Self { kinetic: coefficient, at_rest: coefficient, around: 1.0 }
    }
}

/// Level of the friction within the range of its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FrictionLevel {
    /// Less than expected.
    Low,
    /// Expected.
    Expected,
    /// More than expected.
    High,
}

/// Its [name](FrictionLevel::name).
impl fmt::Display for FrictionLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FrictionLevel {
    /// Every level, from the least friction to the most.
    pub const ALL: [Self; 3] = [Self::Low, Self::Expected, Self::High];

    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Low => "low",
            Self::Expected => "expected",
            Self::High => "high",
        }
    }
}

/// The pipe that a cased wall is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CasingPipe {
    /// Outside diameter, m; the inside one is that of the hole.
    pub od_m: f64,
    /// Minimum yield strength, Pa, where the grade is known.
    pub yield_strength_Pa: Option<f64>,
}

/// One stretch of hole with the same diameter, wall and friction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HoleSection {
    /// Casing or rock.
    pub kind: HoleKind,
    /// Measured depth where the section begins, m.
    pub from_md_m: f64,
    /// Measured depth where the section ends, m.
    pub to_md_m: f64,
    /// Diameter of the hole, or inside diameter of the casing, m.
    pub diameter_m: f64,
    /// Friction between string and wall.
    pub friction: Friction,
    /// Young's modulus of the wall, Pa.
    pub youngs_modulus_Pa: f64,
    /// Poisson's ratio of the wall.
    pub poisson_ratio: f64,
    /// Factor of the hole's [`Roughness`] here.
    pub roughness: f64,
    /// The casing's pipe, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub casing: Option<CasingPipe>,
}

/// The hole's sections, from the surface down, without gaps or overlaps.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Hole {
    sections: Vec<HoleSection>,
    roughness: Option<Roughness>,
}

/// Least ratio of the longest wavelength of a wall to the shortest.
pub const NARROWEST_BAND: f64 = 1.2;

/// Ends that differ by less than this meet, m.
const MEETING_M: f64 = 1e-6;

/// Why sections make no hole. Sections count from zero, from the surface down.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HoleError {
    /// No section at all.
    #[error("a hole needs at least one section")]
    Empty,
    /// A number that is not finite or outside its range.
    #[error("hole section {index}: {quantity} is {value}, expected {expected}")]
    OutOfRange {
        /// Which section.
        index: usize,
        /// Which of its numbers.
        quantity: &'static str,
        /// Its value, SI.
        value: f64,
        /// Expected range.
        expected: &'static str,
    },
    /// The roughness of the wall has a number out of its range.
    #[error("roughness of the wall: {quantity} is {value}, expected {expected}")]
    Roughness {
        /// Which of its numbers.
        quantity: &'static str,
        /// Its value, SI.
        value: f64,
        /// Expected range.
        expected: &'static str,
    },
    /// The end of a section is not below its beginning.
    #[error(
        "hole section {index} ends at MD {to_md_m} m, not below its beginning at {from_md_m} m"
    )]
    Reversed {
        /// Which section.
        index: usize,
        /// Its beginning, m.
        from_md_m: f64,
        /// Its end, m.
        to_md_m: f64,
    },
    /// A section does not begin where the one above ends.
    #[error(
        "hole section {index} begins at MD {from_md_m} m, but the section above ends at \
         {above_to_md_m} m"
    )]
    Apart {
        /// Which section.
        index: usize,
        /// Its beginning, m.
        from_md_m: f64,
        /// End of the section above, m.
        above_to_md_m: f64,
    },
}

impl Hole {
    /// A hole of these sections, from the surface down.
    ///
    /// # Errors
    /// No section, sections that overlap or leave a gap, or a number outside its range.
    pub fn new(sections: Vec<HoleSection>) -> Result<Self, HoleError> {
        if sections.is_empty() {
            return Err(HoleError::Empty);
        }
        for (index, section) in sections.iter().enumerate() {
            section.check(index)?;
            let above = index.checked_sub(1).map(|above| sections[above].to_md_m);
            if let Some(above_to_md_m) = above
                && (section.from_md_m - above_to_md_m).abs() > MEETING_M
            {
                return Err(HoleError::Apart {
                    index,
                    from_md_m: section.from_md_m,
                    above_to_md_m,
                });
            }
        }
        Ok(Self { sections, roughness: None })
    }

    /// The same hole with a rough wall, or with a smooth one.
    ///
    /// # Errors
    /// A root mean square that is negative or not finite; wavelengths that are not positive, or of
    /// which the longest is less than 1.2 times the shortest: waves of one length would add up to a
    /// single one of any height.
    pub fn with_roughness(self, roughness: Option<Roughness>) -> Result<Self, HoleError> {
        if let Some(r) = roughness {
            let broad = r.longest_m.is_finite() && r.longest_m >= NARROWEST_BAND * r.shortest_m;
            for (quantity, value, valid, expected) in [
                not_negative("rms of the radius", r.radius_rms_m),
                not_negative("rms of the tortuosity", r.tortuosity_rms_m),
                positive("shortest wavelength", r.shortest_m),
                ("longest wavelength", r.longest_m, broad, "at least 1.2 times the shortest"),
            ] {
                if !valid {
                    return Err(HoleError::Roughness { quantity, value, expected });
                }
            }
        }
        Ok(Self { roughness, ..self })
    }

    /// Roughness of the wall, where it has any.
    pub fn roughness(&self) -> Option<&Roughness> {
        self.roughness.as_ref()
    }

    /// The sections, from the surface down.
    pub fn sections(&self) -> &[HoleSection] {
        &self.sections
    }

    /// The section at a measured depth, m: the upper one where two meet, the first above the hole
    /// and the last below it.
    pub fn at(&self, md_m: f64) -> &HoleSection {
        let index = self.sections.partition_point(|section| section.to_md_m < md_m);
        &self.sections[index.min(self.sections.len() - 1)]
    }

    /// The same hole with one kinetic coefficient of friction everywhere. Coefficients at rest and
    /// around the hole keep their ratios to the kinetic one along it (where that was zero, the one
    /// at rest becomes `kinetic`).
    ///
    /// # Errors
    /// A coefficient that is negative or not finite.
    pub fn with_friction(&self, kinetic: f64) -> Result<Self, HoleError> {
        self.with_friction_of(|_| kinetic)
    }

    /// The same with a kinetic coefficient for each section, counted from zero.
    ///
    /// # Errors
    /// A coefficient that is negative or not finite.
    pub fn with_friction_of(&self, kinetic: impl Fn(usize) -> f64) -> Result<Self, HoleError> {
        let sections = self.sections.iter().enumerate().map(|(index, section)| {
            let (old, kinetic) = (section.friction, kinetic(index));
            let ratio = if old.kinetic > 0.0 { old.at_rest / old.kinetic } else { 1.0 };
            HoleSection {
                friction: Friction { kinetic, at_rest: kinetic * ratio, ..old },
                ..*section
            }
        });
        Self::new(sections.collect())?.with_roughness(self.roughness)
    }
}

/// A number, whether it is in its range, and that range.
type Checked = (&'static str, f64, bool, &'static str);

fn positive(quantity: &'static str, value: f64) -> Checked {
    (quantity, value, value > 0.0 && value.is_finite(), "more than zero")
}

fn not_negative(quantity: &'static str, value: f64) -> Checked {
    (quantity, value, value >= 0.0 && value.is_finite(), "zero or more")
}

impl HoleSection {
    fn check(&self, index: usize) -> Result<(), HoleError> {
        let Friction { kinetic, at_rest, around } = self.friction;
        let finite = |quantity, value: f64| (quantity, value, value.is_finite(), "a finite depth");
        let holds = at_rest >= kinetic && at_rest.is_finite();
        let poisson = (0.0..0.5).contains(&self.poisson_ratio);
        for (quantity, value, valid, expected) in [
            finite("beginning", self.from_md_m),
            finite("end", self.to_md_m),
            positive("diameter", self.diameter_m),
            not_negative("kinetic friction", kinetic),
            ("friction at rest", at_rest, holds, "at least the kinetic one"),
            not_negative("ratio of rotational friction to that along it", around),
            positive("Young's modulus", self.youngs_modulus_Pa),
            ("Poisson's ratio", self.poisson_ratio, poisson, "from 0 to below 0.5"),
            not_negative("roughness", self.roughness),
        ] {
            if !valid {
                return Err(HoleError::OutOfRange { index, quantity, value, expected });
            }
        }
        if self.to_md_m <= self.from_md_m {
            return Err(HoleError::Reversed {
                index,
                from_md_m: self.from_md_m,
                to_md_m: self.to_md_m,
            });
        }
        Ok(())
    }
}

// Friction that varies along the hole.

impl Hole {
    /// The same hole with a friction that is a function of measured depth, m: every section becomes
    /// pieces of equal length, no longer than `max_length_m`, each with the friction at its middle.
    ///
    /// These are coefficients along the hole, sliding and at rest, for every solver. How the
    /// coefficient falls with the sliding speed is
    /// [`DynamicsSettings::stribeck_speed_m_per_s`](crate::dynamics::DynamicsSettings); in the
    /// dynamics a coefficient may be any function of speed, force and depth, by a
    /// [`FrictionCoefficient`](crate::dynamics::FrictionCoefficient). How friction is shared
    /// between the two directions is [`FrictionLaw`](crate::dynamics::FrictionLaw).
    ///
    /// # Errors
    /// A coefficient that is negative, not finite, or less at rest than sliding; a length that is
    /// not positive.
    pub fn with_friction_profile(
        &self,
        max_length_m: f64,
        friction: impl Fn(f64) -> Friction,
    ) -> Result<Self, HoleError> {
        let mut pieces = Vec::new();
        for (index, section) in self.sections().iter().enumerate() {
            if !(max_length_m.is_finite() && max_length_m > 0.0) {
                return Err(HoleError::OutOfRange {
                    index,
                    quantity: "longest piece of one friction",
                    value: max_length_m,
                    expected: "more than zero",
                });
            }
            let (from, length_m) = (section.from_md_m, section.to_md_m - section.from_md_m);
            let count = (length_m / max_length_m).ceil().max(1.0);
            let end = |piece: usize| from + length_m * piece as f64 / count;
            pieces.extend((0..count as usize).map(|piece| {
                let (from_md_m, to_md_m) = (end(piece), end(piece + 1));
                HoleSection {
                    from_md_m,
                    to_md_m,
                    friction: friction(0.5 * (from_md_m + to_md_m)),
                    ..*section
                }
            }));
        }
        Self::new(pieces)?.with_roughness(self.roughness().copied())
    }
}
