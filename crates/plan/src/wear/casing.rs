//! The worn casing and its remaining strength.

use wholestring::well::{HoleKind, HoleSection};

use super::Groove;
use wholestring_judge::strength::{Collapse, MILL_TOLERANCE, PSI_PA, Tube};

/// Default wear factor, 1/Pa: 5e-10 1/psi, among the 2 to 10 that are commonly printed for steel
/// tool joints or casing-friendly hard metal in water-based mud. It varies fifty-fold with mud and
/// hard metal, so that a measured one should be used.
pub const DEFAULT_WEAR_FACTOR_PER_PA: f64 = 5e-10 / PSI_PA;

/// Wear factors of the casings of a hole.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct WearFactors {
    /// Wear factor where no other is given, 1/Pa.
    pub usual_per_Pa: f64,
    /// Wear factors of sections of the hole, counted from the surface, 1/Pa.
    pub of_section_per_Pa: Vec<(usize, f64)>,
}

impl Default for WearFactors {
    fn default() -> Self {
        Self { usual_per_Pa: DEFAULT_WEAR_FACTOR_PER_PA, of_section_per_Pa: Vec::new() }
    }
}

impl WearFactors {
    /// Returns the wear factor of a section, 1/Pa.
    pub fn of_per_Pa(&self, section: usize) -> f64 {
        let own = self.of_section_per_Pa.iter().find(|(index, _)| *index == section);
        own.map_or(self.usual_per_Pa, |(_, factor)| *factor)
    }
}

/// The reason why casing cannot be worn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CasingError {
    /// A wear factor of a section that does not exist or has no casing.
    #[error("hole section {section} is not cased")]
    NotCased {
        /// The section.
        section: usize,
    },
    /// The outside diameter is no more than that of the bore.
    #[error(
        "casing of hole section {section}: od is {od_m} m, expected more than its bore of \
         {bore_m} m"
    )]
    NoWall {
        /// The section.
        section: usize,
        /// Outside diameter, m.
        od_m: f64,
        /// Diameter of the bore, m.
        bore_m: f64,
    },
    /// A wear factor that is not more than zero.
    #[error(
        "casing of hole section {section}: wear factor is {factor_per_Pa} 1/Pa, expected more \
         than zero"
    )]
    Factor {
        /// The section.
        section: usize,
        /// The wear factor, 1/Pa.
        factor_per_Pa: f64,
    },
}

/// Whether a section of the hole is cased, if all of it is valid.
pub(super) fn is_cased(
    index: usize,
    section: &HoleSection,
    factors: &WearFactors,
) -> Result<bool, CasingError> {
    if section.kind != HoleKind::Casing {
        return Ok(false);
    }
    let (bore_m, factor_per_Pa) = (section.diameter_m, factors.of_per_Pa(index));
    if let Some(pipe) = section.casing
        && !(pipe.od_m > bore_m && pipe.od_m.is_finite())
    {
        return Err(CasingError::NoWall { section: index, od_m: pipe.od_m, bore_m });
    }
    if factor_per_Pa > 0.0 && factor_per_Pa.is_finite() {
        Ok(true)
    } else {
        Err(CasingError::Factor { section: index, factor_per_Pa })
    }
}

/// Remaining casing of a stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearRow {
    /// Measured depth of the middle of the stretch, m.
    pub md_m: f64,
    /// Section of the hole.
    pub section: usize,
    /// Worn volume, m³ per metre.
    pub worn_m3_per_m: f64,
    /// Depth of the groove, m; more than the wall where it is worn through, `None` where no groove
    /// has that volume.
    pub groove_m: Option<f64>,
    /// Remaining pipe; `None` where the casing's pipe is not known.
    pub pipe: Option<WornPipe>,
}

/// Remaining strength of a casing's pipe.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WornPipe {
    /// Nominal wall, m.
    pub wall_m: f64,
    /// Remaining wall at the bottom of the groove, m; zero where it is worn through.
    pub wall_left_m: f64,
    /// Burst of the new and of the worn casing, Pa; `None` where the yield strength is not known.
    pub burst_Pa: Option<[f64; 2]>,
    /// Collapse of the new and of the worn casing, Pa, without tension; `None` where the yield
    /// strength is not known.
    pub collapse_Pa: Option<[f64; 2]>,
}

impl WornPipe {
    /// Returns the worn part of the wall, one at most.
    pub fn worn_part(&self) -> f64 {
        1.0 - self.wall_left_m / self.wall_m
    }

    /// Returns the pipe with a groove of a depth, m.
    fn of(section: &HoleSection, groove_m: Option<f64>) -> Option<Self> {
        let pipe = section.casing?;
        let wall_m = 0.5 * (pipe.od_m - section.diameter_m);
        let wall_left_m = (wall_m - groove_m.unwrap_or(wall_m)).max(0.0);
        let walls_m = [wall_m, wall_left_m];
        let tube = pipe.yield_strength_Pa.map(|yield_strength_Pa| Tube {
            od_m: pipe.od_m,
            id_m: section.diameter_m,
            yield_strength_Pa,
        });
        let burst_Pa =
            tube.map(|tube| walls_m.map(|wall_m| tube.barlow_Pa(MILL_TOLERANCE * wall_m)));
        let collapse = |tube: Tube, wall_m: f64| {
            if wall_m <= 0.0 {
                return 0.0;
            }
            Collapse::of(tube.od_m / wall_m, tube.yield_strength_Pa, 0.0).pressure_Pa
        };
        let collapse_Pa = tube.map(|tube| walls_m.map(|wall_m| collapse(tube, wall_m)));
        Some(Self { wall_m, wall_left_m, burst_Pa, collapse_Pa })
    }
}

impl WearRow {
    /// Returns the row of a section from its worn volume and the radius of the contacting part, m.
    pub(super) fn of(
        index: usize,
        section: &HoleSection,
        md_m: f64,
        worn_m3_per_m: f64,
        joint_m: f64,
    ) -> Self {
        let groove = Groove { bore_m: 0.5 * section.diameter_m, joint_m };
        let groove_m = if worn_m3_per_m > 0.0 { groove.depth_m(worn_m3_per_m) } else { Some(0.0) };
        let pipe = WornPipe::of(section, groove_m);
        Self { md_m, section: index, worn_m3_per_m, groove_m, pipe }
    }
}
