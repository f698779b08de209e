//! What a run has solved so far, and its way to the disk.

use std::time::Duration;

use wholestring::{
    dynamics::{DynamicOutcome, ScheduleStep},
    operation::Operation,
    outcome::{ModelKind, Scalars},
    statics::soft::SoftProfile,
    well::Hole,
};
use wholestring_case::Case;
use wholestring_results::{
    Friction, NODES, Numerics, OperationSummary, ResultsFolder, SCHEMA_VERSION, Statistic, Status,
    Summary, TIME, Table,
};
use wholestring_units::{Dimension, UnitSet};

use crate::{failure::Failure, picture};

/// Everything that a run leaves.
pub(crate) struct Record {
    pub(crate) summary: Summary,
    nodes: Table,
    time: Table,
    /// Lines of the case's schedule.
    schedule: Vec<ScheduleStep>,
    hole: Hole,
    subtitle: String,
    units: UnitSet,
}

impl Record {
    pub(crate) fn new(case: &Case, units: UnitSet) -> Self {
        Self {
            summary: Summary {
                schema_version: SCHEMA_VERSION,
                case: case.name.clone(),
                settings: case.settings.clone(),
                operations: Vec::new(),
            },
            nodes: Table::with_columns(NODES),
            time: Table::with_columns(TIME),
            schedule: case.dynamics.schedule.steps.clone(),
            hole: case.model.well.hole.clone(),
            subtitle: subtitle(case, units),
            units,
        }
    }

    pub(crate) fn add_soft(&mut self, operation: &Operation, profile: &SoftProfile) {
        let solved = self.solved(ModelKind::Soft, operation, profile.scalars);
        self.summary.operations.push(solved);
        // A soft string lies on the wall all the time, wherever anything presses it there.
        let contact: Vec<f64> = profile
            .side_force_N_per_m
            .iter()
            .map(|force| f64::from(u8::from(*force != 0.0)))
            .collect();
        self.nodes.append(
            &[("model", "soft"), ("operation", operation.kind.name())],
            &[
                ("md_m", &profile.md_m),
                ("tension_N", &profile.tension_N),
                ("torque_N_m", &profile.torque_N_m),
                ("side_force_N_per_m", &profile.side_force_N_per_m),
                ("contact_fraction", &contact),
                ("axial_friction_N_per_m", &profile.axial_friction_N_per_m),
                (
                    "friction_torque_N_m_per_m",
                    &profile.friction_torque_N_m_per_m,
                ),
                ("twist_rad", &profile.twist_rad),
                ("stretch_m", &profile.stretch_m),
            ],
        );
    }

    /// Adds what a dynamic run computed in `took`, to its end or until `status` says.
    pub(crate) fn add_dynamic(
        &mut self,
        operation: &Operation,
        outcome: &DynamicOutcome,
        status: Status,
        took: Duration,
    ) {
        let DynamicOutcome {
            scalars,
            statistics,
            numerics,
            nodes,
            series,
            ..
        } = outcome;
        let statistics = statistics.iter().map(|(name, of)| {
            let statistic = Statistic {
                mean: of.mean,
                std: of.std,
                min: of.min,
                max: of.max,
                p05: of.p05,
                p95: of.p95,
            };
            ((*name).to_owned(), statistic)
        });
        let simulated_s = series.time_s.last().copied().unwrap_or(0.0);
        let wall_time_s = took.as_secs_f64();
        let solved = OperationSummary {
            status,
            statistics: Some(statistics.collect()),
            numerics: Some(Numerics {
                elements: numerics.elements,
                time_step_s: numerics.time_step_s,
                steps: numerics.steps,
                added_axial_mass_fraction: numerics.added_axial_mass_fraction,
                max_penetration_m: numerics.max_penetration_m,
                energy_residual: numerics.energy_residual,
                instructions: numerics.instructions.into(),
                wall_time_s,
                real_time_factor: simulated_s / wall_time_s,
            }),
            ..self.solved(ModelKind::Dynamic, operation, *scalars)
        };
        self.summary.operations.push(solved);
        let operation = operation.kind.name();
        let climb_rad = or_null(&nodes.climb_rad);
        self.nodes.append(
            &[("model", "dynamic"), ("operation", operation)],
            &[
                ("md_m", &nodes.md_m),
                ("tension_N", &nodes.tension_N),
                ("torque_N_m", &nodes.torque_N_m),
                ("side_force_N_per_m", &nodes.side_force_N_per_m),
                ("contact_fraction", &nodes.contact_fraction),
                ("tension_std_N", &nodes.tension_std_N),
                ("torque_std_N_m", &nodes.torque_std_N_m),
                ("contact_force_N", &nodes.contact_force_N),
                ("contact_force_std_N", &nodes.contact_force_std_N),
                ("contact_force_max_N", &nodes.contact_force_max_N),
                ("climb_rad", &climb_rad),
                ("lateral_offset_m", &nodes.lateral_offset_m),
                ("axial_friction_N_per_m", &nodes.axial_friction_N_per_m),
                (
                    "friction_torque_N_m_per_m",
                    &nodes.friction_torque_N_m_per_m,
                ),
            ],
        );
        let first_row = self.time.rows();
        self.time.append(
            &[("operation", operation), ("note", "")],
            &[
                ("time_s", &series.time_s),
                ("bit_depth_m", &series.bit_depth_m),
                ("weight_on_bit_N", &series.weight_on_bit_N),
                ("bit_torque_N_m", &series.bit_torque_N_m),
                ("depth_of_cut_m", &series.depth_of_cut_m),
                ("hook_load_N", &series.hook_load_N),
                ("surface_torque_N_m", &series.surface_torque_N_m),
                ("friction_torque_N_m", &series.friction_torque_N_m),
                ("axial_friction_N", &series.axial_friction_N),
                ("side_force_total_N", &series.side_force_total_N),
                ("twist_rad", &series.twist_rad),
                ("stretch_m", &series.stretch_m),
                ("block_velocity_m_per_s", &series.block_velocity_m_per_s),
                (
                    "bit_rotary_speed_rad_per_s",
                    &series.bit_rotary_speed_rad_per_s,
                ),
                ("rotary_speed_rad_per_s", &series.rotary_speed_rad_per_s),
                (
                    "rotary_speed_set_rad_per_s",
                    &series.rotary_speed_set_rad_per_s,
                ),
                (
                    "block_velocity_set_m_per_s",
                    &or_null(&series.block_velocity_set_m_per_s),
                ),
                ("weight_on_bit_set_N", &or_null(&series.weight_on_bit_set_N)),
            ],
        );
        self.note(first_row, &series.schedule_line);
    }

    /// Writes the notes of the schedule to the rows of an operation, by the line that began last at each.
    fn note(&mut self, first_row: usize, lines: &[usize]) {
        let mut begun = 0;
        for (row, &line) in lines.iter().enumerate() {
            let news = self.schedule.get(begun..line).unwrap_or_default();
            if let Some(note) = news.iter().rev().find_map(|step| step.note.as_deref()) {
                self.time.say_from("note", first_row + row, note);
            }
            begun = line;
        }
    }

    /// The summary of an operation that was solved to its end.
    fn solved(
        &self,
        model: ModelKind,
        operation: &Operation,
        scalars: Scalars,
    ) -> OperationSummary {
        OperationSummary {
            model,
            operation: operation.kind.name().into(),
            status: Status::Complete,
            friction: Friction::of(&friction(&self.hole)),
            bit_depth_m: operation.bit_depth_m,
            scalars,
            statistics: None,
            numerics: None,
        }
    }

    /// Writes everything; what an earlier run left goes.
    pub(crate) fn write(&self, folder: &ResultsFolder, csv: bool) -> Result<(), Failure> {
        folder.write_table("nodes", &self.nodes, csv)?;
        folder.write_table("time", &self.time, csv)?;
        let picture = picture::draw(
            &self.summary.case,
            &self.subtitle,
            &self.nodes,
            &self.hole,
            self.units,
        );
        folder.write_text("profile.svg", &picture)?;
        // Last, so that a summary tells of tables that are there.
        folder.write_summary(&self.summary)?;
        Ok(())
    }
}

/// What does not apply as a number that the table writes as `null`.
fn or_null(values: &[Option<f64>]) -> Vec<f64> {
    values.iter().map(|v| v.unwrap_or(f64::NAN)).collect()
}

fn friction(hole: &Hole) -> Vec<f64> {
    hole.sections()
        .iter()
        .map(|section| section.friction.kinetic)
        .collect()
}

/// `bit at 4305 m, friction 0.3, mud 1200 kg/m3`
pub(crate) fn subtitle(case: &Case, units: UnitSet) -> String {
    let depth = case
        .operations
        .first()
        .map_or(0.0, |operation| operation.bit_depth_m);
    let friction = match Friction::of(&friction(&case.model.well.hole)) {
        Friction::Uniform(value) => value.to_string(),
        Friction::BySection(values) => values
            .iter()
            .map(f64::to_string)
            .collect::<Vec<_>>()
            .join(", "),
    };
    format!(
        "bit at {}, friction {friction}, mud {}",
        Dimension::Length.format(depth, units),
        Dimension::Density.format(case.model.mud.density_kg_per_m3, units),
    )
}
