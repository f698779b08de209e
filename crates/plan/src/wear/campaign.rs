//! Wear of casing over a campaign.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};
use wholestring::{
    outcome::HOLE_STEP_M,
    well::{Hole, HoleKind, HoleSection},
};

use super::{
    WearRow,
    casing::{CasingError, WearFactors, is_cased},
    worn_by_work_m3_per_m, worn_m3_per_m,
};
use crate::Stage;

/// Casing wear of a hole from the operations of a campaign, in stretches of [`HOLE_STEP_M`].
#[derive(Debug, Clone, PartialEq)]
pub struct CasingWear {
    casings: Vec<Casing>,
}

#[derive(Debug, Clone, PartialEq)]
struct Casing {
    /// Section of the hole, counted from the surface.
    index: usize,
    section: HoleSection,
    factor_per_Pa: f64,
    stretches: Vec<Stretch>,
}

/// Worn volumes of the casings of a hole, as numbers that can be stored and added.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Worn(Vec<Vec<Stretch>>);

impl Worn {
    /// Adds the wear of other operations on the same casings.
    pub fn merge(&mut self, other: &Self) {
        for (own, other) in self.0.iter_mut().zip(&other.0) {
            for (own, other) in own.iter_mut().zip(other) {
                own.worn_m3_per_m += other.worn_m3_per_m;
                own.by_radius += other.by_radius;
            }
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
struct Stretch {
    worn_m3_per_m: f64,
    /// Volume times the radius of the contacting part, m³/m · m.
    by_radius: f64,
}

impl Casing {
    /// Returns the ends of a stretch, m.
    fn ends_m(&self, index: usize) -> [f64; 2] {
        let from_m = self.section.from_md_m + index as f64 * HOLE_STEP_M;
        [from_m, (from_m + HOLE_STEP_M).min(self.section.to_md_m)]
    }

    /// Spreads a volume per metre over a stretch of depth, worn by a radius, m.
    fn wear(&mut self, [from_m, to_m]: [f64; 2], worn_m3_per_m: f64, radius_m: f64) {
        let place = |md_m: f64| ((md_m - self.section.from_md_m) / HOLE_STEP_M).max(0.0) as usize;
        if to_m <= self.section.from_md_m || from_m >= self.section.to_md_m {
            return;
        }
        let last = (place(to_m) + 1).min(self.stretches.len());
        for index in place(from_m)..last {
            let [begin_m, end_m] = self.ends_m(index);
            let shared = (to_m.min(end_m) - from_m.max(begin_m)).max(0.0) / (end_m - begin_m);
            let stretch = &mut self.stretches[index];
            stretch.worn_m3_per_m += shared * worn_m3_per_m;
            stretch.by_radius += shared * worn_m3_per_m * radius_m;
        }
    }
}

impl CasingWear {
    /// Returns the cased sections of a hole, without wear.
    ///
    /// # Errors
    /// A wear factor of a section without casing, or one that is not more than zero; a casing without wall.
    pub fn new(hole: &Hole, factors: &WearFactors) -> Result<Self, CasingError> {
        let sections = hole.sections();
        for &(section, _) in &factors.of_section_per_Pa {
            if sections.get(section).is_none_or(|found| found.kind != HoleKind::Casing) {
                return Err(CasingError::NotCased { section });
            }
        }
        let mut casings = Vec::new();
        for (index, section) in sections.iter().enumerate() {
            if is_cased(index, section, factors)? {
                let length_m = section.to_md_m - section.from_md_m;
                let count = (length_m / HOLE_STEP_M).ceil().max(1.0) as usize;
                casings.push(Casing {
                    index,
                    section: *section,
                    factor_per_Pa: factors.of_per_Pa(index),
                    stretches: vec![Stretch::default(); count],
                });
            }
        }
        Ok(Self { casings })
    }

    /// Adds an operation with its duration: the side force of each place on the casing there,
    /// sliding by `√((π D n)² + l²)` of its revolutions `n` and its travel `l`.
    pub fn add(&mut self, stage: &Stage<'_>) {
        let profile = stage.solution.profile;
        let (revolutions, travel_m) = (stage.revolutions(), stage.travel_m());
        for row in 1..profile.md_m.len() {
            let ends_m = [profile.md_m[row - 1], profile.md_m[row]];
            let force = |row: usize| profile.side_force_N_per_m[row].abs();
            let side_force_N_per_m = 0.5 * (force(row - 1) + force(row));
            let radius_m = rubs_m(stage, ends_m);
            let sliding_m = libm::hypot(2.0 * PI * radius_m * revolutions, travel_m);
            for casing in &mut self.casings {
                let factor = casing.factor_per_Pa;
                let worn = worn_m3_per_m(factor, side_force_N_per_m, sliding_m);
                casing.wear(ends_m, worn, radius_m);
            }
        }
    }

    /// Adds the same from the friction power on the hole in the solution, for dynamics the mean
    /// over its window: `V = F W/μ` with the kinetic friction of the casing, times its factor
    /// around the hole where the string turns.
    pub fn add_by_work(&mut self, stage: &Stage<'_>) {
        let wear = stage.solution.wear;
        let turns = stage.operation.rotation_rad_per_s() > 0.0;
        for (md_m, power_W_per_m) in wear.md_m.iter().zip(&wear.wear_power_W_per_m) {
            let ends_m = [md_m - 0.5 * HOLE_STEP_M, md_m + 0.5 * HOLE_STEP_M];
            let radius_m = rubs_m(stage, ends_m);
            for casing in &mut self.casings {
                let friction = casing.section.friction;
                let around = if turns { friction.around } else { 1.0 };
                let worn = worn_by_work_m3_per_m(
                    casing.factor_per_Pa,
                    power_W_per_m * stage.duration_s,
                    friction.kinetic * around,
                );
                casing.wear(ends_m, worn, radius_m);
            }
        }
    }

    /// Returns the worn volumes.
    pub fn worn(&self) -> Worn {
        Worn(self.casings.iter().map(|casing| casing.stretches.clone()).collect())
    }

    /// Returns the same casings with these worn volumes.
    #[must_use]
    pub fn with(mut self, worn: &Worn) -> Self {
        for (casing, worn) in self.casings.iter_mut().zip(&worn.0) {
            for (stretch, worn) in casing.stretches.iter_mut().zip(worn) {
                *stretch = *worn;
            }
        }
        self
    }

    /// Returns the remaining casings, from the surface down. Where several diameters have caused
    /// wear, the groove has the mean of their radii weighted by the volume of each.
    pub fn rows(&self) -> Vec<WearRow> {
        let row = |casing: &Casing, index: usize| {
            let [begin_m, end_m] = casing.ends_m(index);
            let Stretch { worn_m3_per_m, by_radius } = casing.stretches[index];
            let joint_m = by_radius / worn_m3_per_m;
            let middle_m = 0.5 * (begin_m + end_m);
            WearRow::of(casing.index, &casing.section, middle_m, worn_m3_per_m, joint_m)
        };
        let rows = |casing: &Casing| -> Vec<WearRow> {
            (0..casing.stretches.len()).map(|index| row(casing, index)).collect()
        };
        self.casings.iter().flat_map(rows).collect()
    }
}

/// Returns the radius of the contacting part on a stretch of depth, m.
fn rubs_m(stage: &Stage<'_>, [from_m, to_m]: [f64; 2]) -> f64 {
    let from_bit_m = stage.operation.bit_depth_m - 0.5 * (from_m + to_m);
    stage.model.string.component_at(from_bit_m).1.contact_radius_m()
}
