//! Settings of the case that the page of a plan and its tables use.

use super::PlanSummary;

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
