//! The casing that is worn, and what is left of it.

use wholestring::well::{Hole, HoleKind, HoleSection};

use super::Groove;
use crate::strength::{Collapse, MILL_TOLERANCE, PSI_PA, Tube};

/// Wear factor where nothing else is said, 1/Pa: 5e-10 1/psi, among the 2 to 10 that are commonly printed for
/// steel tool joints or casing-friendly hard metal in water-based mud. It varies fifty-fold with mud and hard
/// metal: take one that was measured.
pub const DEFAULT_WEAR_FACTOR_PER_PA: f64 = 5e-10 / PSI_PA;

/// The pipe of a cased section of the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CasingPipe {
    /// Section of the hole, counted from the surface; its diameter is the bore.
    pub section: usize,
    /// Outside diameter, m.
    pub od_m: f64,
    /// Minimum yield strength, Pa, if known.
    pub yield_strength_Pa: Option<f64>,
    /// Wear factor with the string and the mud that pass, 1/Pa.
    pub wear_factor_per_Pa: f64,
}

/// Why casing cannot be worn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CasingError {
    /// No such section, or one without casing.
    #[error("hole section {section} is not cased")]
    NotCased {
        /// Which.
        section: usize,
    },
    /// The outside diameter is no more than that of the bore.
    #[error(
        "casing of hole section {section}: od is {od_m} m, expected more than its bore of {bore_m} m"
    )]
    NoWall {
        /// Which section.
        section: usize,
        /// Outside diameter, m.
        od_m: f64,
        /// Diameter of the bore, m.
        bore_m: f64,
    },
    /// A number that is not more than zero.
    #[error("casing of hole section {section}: {quantity} is {value}, expected more than zero")]
    OutOfRange {
        /// Which section.
        section: usize,
        /// Which number.
        quantity: &'static str,
        /// What it is, SI.
        value: f64,
    },
}

impl CasingPipe {
    /// Its section of the hole, if it is sound.
    pub(super) fn section<'a>(&self, hole: &'a Hole) -> Result<&'a HoleSection, CasingError> {
        let section = self.section;
        let of = hole.sections().get(section).filter(|of| of.kind == HoleKind::Casing);
        let of = of.ok_or(CasingError::NotCased { section })?;
        let (od_m, bore_m) = (self.od_m, of.diameter_m);
        if !(od_m > bore_m && od_m.is_finite()) {
            return Err(CasingError::NoWall { section, od_m, bore_m });
        }
        for (quantity, value) in [
            ("wear factor, 1/Pa,", self.wear_factor_per_Pa),
            ("yield strength, Pa,", self.yield_strength_Pa.unwrap_or(1.0)),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(CasingError::OutOfRange { section, quantity, value });
            }
        }
        Ok(of)
    }
}

/// What is left of a stretch of casing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearRow {
    /// Measured depth of the middle of the stretch, m.
    pub md_m: f64,
    /// Section of the hole.
    pub section: usize,
    /// Volume that is gone, m³ per metre.
    pub worn_m3_per_m: f64,
    /// Depth of the groove, m; more than the wall where it is worn through, none where no groove holds the
    /// volume.
    pub groove_m: Option<f64>,
    /// Nominal wall, m.
    pub wall_m: f64,
    /// Wall that is left at the bottom of the groove, m.
    pub wall_left_m: f64,
    /// Burst of the new and of the worn casing, Pa; none where the yield strength is not known.
    pub burst_Pa: Option<[f64; 2]>,
    /// Collapse of the new and of the worn casing, Pa, without tension; none where the yield strength is not
    /// known.
    pub collapse_Pa: Option<[f64; 2]>,
}

impl WearRow {
    /// Part of the wall that is gone, one at most.
    pub fn worn_part(&self) -> f64 {
        1.0 - self.wall_left_m / self.wall_m
    }

    /// Of a volume that is gone, with what rubbed on this radius, m.
    pub(super) fn of(
        pipe: &CasingPipe,
        section: &HoleSection,
        md_m: f64,
        worn_m3_per_m: f64,
        joint_m: f64,
    ) -> Self {
        let wall_m = 0.5 * (pipe.od_m - section.diameter_m);
        let groove = Groove { bore_m: 0.5 * section.diameter_m, joint_m };
        let groove_m = if worn_m3_per_m > 0.0 { groove.depth_m(worn_m3_per_m) } else { Some(0.0) };
        let wall_left_m = (wall_m - groove_m.unwrap_or(wall_m)).max(0.0);
        let tube = pipe.yield_strength_Pa.map(|yield_strength_Pa| Tube {
            od_m: pipe.od_m,
            id_m: section.diameter_m,
            yield_strength_Pa,
        });
        Self {
            md_m,
            section: pipe.section,
            worn_m3_per_m,
            groove_m,
            wall_m,
            wall_left_m,
            burst_Pa: tube
                .map(|tube| [wall_m, wall_left_m].map(|of| tube.barlow_Pa(MILL_TOLERANCE * of))),
            collapse_Pa: tube.map(|tube| {
                [wall_m, wall_left_m].map(|of| {
                    let slenderness = tube.od_m / of.max(f64::MIN_POSITIVE);
                    Collapse::of(slenderness, tube.yield_strength_Pa, 0.0).pressure_Pa
                })
            }),
        }
    }
}
