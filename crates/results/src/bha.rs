//! `summary.json` of a static BHA analysis.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::{
    operation::OperationKind,
    statics::assembly::{AssemblyErrors, Contact, Largest, Sag},
};
use wholestring_judge::{Check, CheckKind, Unchecked};

use crate::{
    BhaPoint, BhaVaried, ResultsError,
    json::{read_versioned, write_json},
};

/// Version of the layout of the files of a static BHA analysis; raised when a key changes or is
/// removed. 2: `checks` and `unchecked`. All versions are read.
pub const BHA_VERSION: u32 = 2;

/// Weights, as a part of one, and tool faces, rad, that differ by less are the same.
const SAME: f64 = 1e-6;

/// `summary.json` of a static BHA analysis. Each pair is the part towards the high side and that to
/// the right of it as one looks down the hole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BhaSummary {
    /// [`BHA_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Name of the case.
    pub case: String,
    /// The case's settings with all defaults filled in.
    pub settings: Value,
    /// The operation: `drill`, `slide`, ...
    pub operation: OperationKind,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Tool face of the lowest bend, rad; none without one.
    pub toolface_rad: Option<f64>,
    /// Inclination of the hole at the bit, rad.
    pub inclination_rad: f64,
    /// Azimuth of the hole at the bit, rad.
    pub azimuth_rad: f64,
    /// The checks of the assembly, the most severe first.
    #[serde(default)]
    pub checks: Vec<Check>,
    /// Limits that could not be checked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unchecked: Vec<Unchecked>,
    /// The static equilibrium.
    pub state: BhaState,
    /// Components as far as they were solved, from the bit up.
    pub parts: Vec<BhaPart>,
    /// Build rate of the holes in which the inclination was varied, rad/m.
    pub build_rate_rad_per_m: f64,
    /// Mean side force of the bit over the tool faces, N; none where they were not varied over a
    /// revolution.
    pub mean_side_force_N: Option<[f64; 2]>,
    /// Inclinations at which the side force towards the high side is zero, rad.
    pub holding_inclinations_rad: Vec<f64>,
    /// Weights at which it is zero, N.
    pub holding_weights_N: Vec<f64>,
    /// The assembly at other tool faces, weights and inclinations.
    pub sweep: Vec<BhaPoint>,
    /// Number of these points that were not solved because the work was interrupted.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub missing: usize,
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}

/// A static BHA analysis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BhaState {
    /// Side force of the bit on the rock, N.
    pub side_force_N: [f64; 2],
    /// Tilt of the bit against the hole's axis, rad.
    pub tilt_rad: [f64; 2],
    /// Upper end of the assembly from the bit, m: where ordinary pipe begins.
    pub length_m: f64,
    /// Length of the solved part of the string, from the bit, m.
    pub solved_m: f64,
    /// Largest bending moment of the assembly, N·m.
    pub largest_bending_moment_N_m: Largest,
    /// Largest bending stress of the assembly, Pa.
    pub largest_bending_stress_Pa: Largest,
    /// Largest von Mises stress of the assembly, Pa.
    pub largest_von_mises_stress_Pa: Largest,
    /// Contacts, from the bit up; the bit first.
    pub contacts: Vec<Contact>,
    /// Sag at the survey sensors; measured + correction = hole.
    pub sag: Vec<Sag>,
    /// Changes of the result with elements half as long.
    pub errors: Option<AssemblyErrors>,
    /// Elements.
    pub elements: usize,
    /// Largest force out of balance, as a part of the string's weight.
    pub residual: f64,
    /// Whether every small motion costs energy.
    pub stable: bool,
}

/// A component.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BhaPart {
    /// Its name.
    pub name: String,
    /// Its lower end, from the bit, m.
    pub from_bit_m: f64,
    /// Its upper end, from the bit, m.
    pub to_bit_m: f64,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Diameter over its blades, m, and their length, m.
    pub blades_m: Option<[f64; 2]>,
    /// Diameter of its tool joints, m.
    pub joint_od_m: Option<f64>,
    /// Distance of its bend from the bit, m.
    pub bend_m: Option<f64>,
}

impl BhaSummary {
    /// Writes the summary as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Reads back a summary, and refuses one of another [`BHA_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, 1..=BHA_VERSION)
    }

    /// Checks that need attention, the most severe first.
    pub fn open_checks(&self) -> impl Iterator<Item = &Check> {
        self.checks.iter().filter(|check| !check.is_ok())
    }

    /// Largest difference of the side force, N, between the state and the point of a variation at
    /// the same tool face and weight: points have no shorter elements at the ends of contacts.
    /// `None` without such a point.
    pub fn points_differ_N(&self) -> Option<f64> {
        let is_own = |point: &&BhaPoint| {
            let turned_rad = match (point.toolface_rad, self.toolface_rad) {
                (Some(toolface_rad), Some(own_rad)) => (toolface_rad - own_rad).abs(),
                _ => 0.0,
            };
            let off_N = (point.weight_on_bit_N - self.weight_on_bit_N).abs();
            point.varied != BhaVaried::Inclination
                && turned_rad < SAME
                && off_N <= SAME * self.weight_on_bit_N.abs()
        };
        let own = self.sweep.iter().filter(is_own).filter_map(|point| point.found);
        let [high_N, right_N] = self.state.side_force_N;
        let differ = own.map(|found| {
            let [other_high_N, other_right_N] = found.side_force_N;
            libm::hypot(high_N - other_high_N, right_N - other_right_N)
        });
        differ.reduce(f64::max)
    }

    fn unstable(&self) -> Option<&Check> {
        self.checks.iter().find(|check| check.kind == CheckKind::UnstableEquilibrium)
    }

    /// Warnings besides the checks, a sentence for each.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        // A file of a version without checks.
        if !self.state.stable && self.unstable().is_none() {
            warnings.push("the state is not stable: a small push changes it".into());
        }
        let failed = self.sweep.iter().filter(|point| point.found.is_none()).count();
        if failed > 0 {
            let all = self.sweep.len();
            warnings.push(format!("{failed} of {all} points of the sweeps have no equilibrium"));
        }
        if self.missing > 0 {
            let (missing, all) = (self.missing, self.sweep.len() + self.missing);
            warnings.push(format!(
                "interrupted: {missing} of {all} points of the sweeps were not solved"
            ));
        }
        warnings
    }
}
