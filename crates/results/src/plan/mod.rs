//! The JSON file of a plan, `summary.json`, and its tables.

mod along;
mod broomstick;
mod campaign;
mod check;
mod hydraulics;
mod measured;
mod overlay;
mod peaks;
mod roadmap;

pub use along::{PLAN_ALONG, PlanStation};
pub use broomstick::{
    PLAN_BROOMSTICK, PLAN_BUCKLING, PLAN_FRICTION, PLAN_SURFACE_LIMITS, PlanBuckling, PlanFriction,
    PlanPoint, PlanSurfaceLimit, plan_broomstick_table,
};
pub use campaign::{PLAN_FATIGUE, PLAN_WEAR, PlanDamage, PlanFatigue, PlanFatigueHour, PlanWear};
pub use check::{PLAN_LIMITS, PlanCheck, PlanOperation, plan_limits_table};
pub use hydraulics::{PLAN_HYDRAULICS, PlanDensity, PlanHydraulics};
pub use measured::{PLAN_MEASURED, PlanMeasured};
pub use overlay::{PLAN_OVERLAY, PlanOverlay, PlanOverlayDifference, PlanOverlayRow};
pub use peaks::{
    PLAN_PEAKS, PLAN_PEAKS_TIME, PlanGel, PlanHistory, PlanPeak, PlanPeakOf, PlanPeakSample,
    plan_peaks_time_table,
};

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};

use crate::{
    ResultsError, Row, Table, Texts, UncertainSummary,
    json::{read_versioned, write_json},
};

/// Version of the layout of the files of a plan; raised when a key changes or is removed. 2:
/// `checks` in place of `worst_limits`, `governing` in place of `breaks_first`, verdicts in place
/// of standings. All versions are read.
pub const PLAN_VERSION: u32 = 2;

/// `summary.json` of a plan.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanSummary {
    /// [`PLAN_VERSION`] of the program that wrote it.
    pub schema_version: u32,
    /// Name of the case.
    pub case: String,
    /// The case's settings with all defaults filled in, those of the plan too.
    pub settings: Value,
    /// Friction of each hole section at each level.
    pub frictions: Vec<PlanFriction>,
    /// Models, in the order in which they were solved.
    pub models: Vec<ModelKind>,
    /// Operations, in the order of the plan.
    pub operations: Vec<OperationKind>,
    /// Depths of the bit, m, increasing.
    pub bit_depths_m: Vec<f64>,
    /// Points that are not solved because the plan was interrupted.
    pub missing: usize,
    /// Model after model, operation after operation, friction after friction, down the hole.
    pub points: Vec<PlanPoint>,
    /// Friction after friction, operation after operation, down the hole.
    pub buckling: Vec<PlanBuckling>,
    /// For each kind of check and each operation the most severe, and among equals the one with the
    /// least reserve, of all models, frictions and depths.
    #[serde(alias = "worst_limits")]
    pub checks: Vec<PlanCheck>,
    /// For each operation the limit that governs: the one with the least reserve among those that
    /// break something or stop the operation, of all models, frictions and depths.
    #[serde(default, alias = "breaks_first")]
    pub governing: Vec<PlanCheck>,
    /// Allowable hook load and torque at the surface: for the rig and for the topmost component.
    #[serde(default)]
    pub surface_limits: Vec<PlanSurfaceLimit>,
    /// Limits that could not be checked, and the missing numbers.
    pub unchecked: Vec<String>,
    /// The parts of the campaign whose fatigue and casing wear are summed, with their hours.
    #[serde(default)]
    pub counted: Vec<String>,
    /// The parts of the campaign that fatigue and casing wear do not count, with the reasons.
    #[serde(default)]
    pub not_counted: Vec<String>,
    /// The mud, down the hole; empty where it has no rheology.
    #[serde(default)]
    pub hydraulics: Vec<PlanHydraulics>,
    /// Model after model, each component from the bit up whose fatigue is known.
    pub fatigue: Vec<PlanFatigue>,
    /// Model after model, for each casing the most worn stretch, from the surface down.
    pub wear: Vec<PlanWear>,
    /// Effect of uncertain numbers; none where all are exact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertain: Option<UncertainSummary>,
    /// Measured readings, model after model, in the order of their file.
    #[serde(default)]
    pub measured: Vec<PlanMeasured>,
    /// Another program's curves; none where none are compared with the plan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub overlay: Option<PlanOverlay>,
    /// Peaks by the dynamics, event after event, friction after friction, down the hole; empty
    /// where none were requested.
    #[serde(default)]
    pub peaks: Vec<PlanPeak>,
    /// Quantities of its texts, from which they are rendered in other units.
    #[serde(default, skip_serializing_if = "Texts::is_empty")]
    pub texts: Texts,
}

impl PlanSummary {
    /// A row for each point.
    pub fn broomstick_table(&self) -> Table {
        plan_broomstick_table(&self.points, self.block_weight_N())
    }

    /// A row for each weight to buckle.
    pub fn buckling_table(&self) -> Table {
        PlanBuckling::table(&self.buckling)
    }

    /// A row for each hole section at each level of friction.
    pub fn friction_table(&self) -> Table {
        PlanFriction::table(&self.frictions)
    }

    /// A row for each depth of the bit; none where the mud has no rheology or nothing flows.
    pub fn hydraulics_table(&self) -> Table {
        PlanHydraulics::table(&self.hydraulics)
    }

    /// A row for each limit at the surface, at both ends of the depths.
    pub fn surface_limits_table(&self) -> Table {
        broomstick::table(&self.surface_limits, self.bit_depths_m.last().copied().unwrap_or(0.0))
    }

    /// A row for each measured weight and torque, for each model.
    pub fn measured_table(&self) -> Table {
        PlanMeasured::table(&self.measured)
    }

    /// Number of a model's readings between low and high friction, and number of those that depend
    /// on friction.
    pub fn measured_between(&self, model: ModelKind) -> (usize, usize) {
        measured::between(&self.measured, model)
    }

    /// Writes the summary as indented JSON.
    pub fn write(&self, path: &Path) -> Result<(), ResultsError> {
        write_json(self, path)
    }

    /// Reads back a summary, and refuses one of another [`PLAN_VERSION`].
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        read_versioned(path, 1..=PLAN_VERSION)
    }

    /// The points of a model, an operation and a friction, down the hole.
    pub fn curve(
        &self,
        model: ModelKind,
        operation: OperationKind,
        friction: FrictionLevel,
    ) -> impl Iterator<Item = &PlanPoint> {
        self.points.iter().filter(move |point| {
            point.model == model && point.operation == operation && point.friction == friction
        })
    }
}

// Settings of the case that the page of a plan and its tables use.

impl PlanSummary {
    /// Weight of the block, N; none where the case does not give it.
    pub fn block_weight_N(&self) -> Option<f64> {
        self.settings["rig"]["block_weight_N"].as_f64()
    }

    /// Limit of pumps and standpipe, Pa; none where the case does not give it.
    pub fn pump_pressure_limit_Pa(&self) -> Option<f64> {
        self.settings["rig"]["pump_pressure_limit_Pa"].as_f64()
    }

    /// Density of the mud at rest, kg/m³.
    pub fn mud_density_kg_per_m3(&self) -> Option<f64> {
        self.settings["mud"]["density_kg_per_m3"].as_f64()
    }

    /// Weight on bit of the operations that drill, N; none where the plan has no such operation.
    pub fn weight_on_bit_N(&self) -> Option<f64> {
        let drills = self.operations.iter().any(|operation| operation.on_bottom());
        self.settings["operation"]["wob_N"].as_f64().filter(|_| drills)
    }

    /// Diameters of the hole sections, m, from the surface down; none where the settings give no
    /// number.
    pub fn hole_diameters_m(&self) -> impl Iterator<Item = Option<f64>> {
        let sections = self.settings["well"]["hole"].as_array().into_iter().flatten();
        sections.map(|section| section["diameter_m"].as_f64())
    }
}
