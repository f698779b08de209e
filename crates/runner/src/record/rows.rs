//! What a model computed, as rows of the tables.

use std::time::Duration;

use wholestring::{
    dynamics::{ContactClass, DynamicOutcome, NodeProfile, ScheduleStep, TimeSeries, TunedLift},
    operation::Operation,
    outcome::ModelKind,
    rock::bit_face::BottomHole,
    statics::soft::SoftProfile,
};
use wholestring_results::{Numerics, OperationSummary, Spectrum, Statistic, Status};

use super::Record;

/// What a dynamic run cost.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effort {
    /// Time on the clock.
    pub(crate) took: Duration,
    /// Runs from the start to the end, those that a lift was sought with included.
    pub(crate) runs: usize,
}

impl Record {
    pub(crate) fn add_soft(&mut self, operation: &Operation, profile: &SoftProfile) {
        let solved = OperationSummary {
            hydraulics: profile.hydraulics,
            ..self.solved(ModelKind::Soft, operation, profile.scalars)
        };
        self.summary.operations.push(solved);
        // A soft string lies on the wall all the time, wherever anything presses it there.
        let contact: Vec<f64> = profile
            .side_force_N_per_m
            .iter()
            .map(|force| f64::from(u8::from(*force != 0.0)))
            .collect();
        self.nodes.append(
            &[
                ("model", &["soft"]),
                ("operation", &[operation.kind.name()]),
                ("contact_class", &classes(&contact)),
                ("contact_side", &sides(&profile.side_force_N_per_m)),
            ],
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
                ("climb_rad", &numbers(&profile.climb_rad)),
                ("lateral_offset_m", &profile.lateral_offset_m),
                (
                    "side_force_per_joint_N",
                    &numbers(&profile.side_force_per_joint_N),
                ),
                ("true_tension_N", &profile.true_tension_N),
                ("outside_pressure_Pa", &profile.outside_pressure_Pa),
                ("inside_pressure_Pa", &profile.inside_pressure_Pa),
                ("bending_moment_N_m", &profile.bending_moment_N_m),
                ("bending_stress_Pa", &profile.bending_stress_Pa),
                ("von_mises_stress_Pa", &profile.von_mises_stress_Pa),
                ("yield_use", &numbers(&profile.yield_use)),
                ("wear_power_W_per_m", &profile.wear_power_W_per_m),
            ],
        );
        self.wear.append(
            &[
                ("model", &["soft"]),
                ("operation", &[operation.kind.name()]),
            ],
            &[
                ("md_m", &profile.wear.md_m),
                ("wear_power_W_per_m", &profile.wear.wear_power_W_per_m),
            ],
        );
    }

    /// Adds what a dynamic run computed, to its end or until `status` says, the bottom that it left on solid rock, and the lift that
    /// was found for it, if there is one.
    pub(crate) fn add_dynamic(
        &mut self,
        operation: &Operation,
        outcome: &DynamicOutcome,
        bottom: Option<&BottomHole>,
        lift: Option<TunedLift>,
        status: Status,
        effort: Effort,
    ) {
        let DynamicOutcome {
            scalars,
            statistics,
            hydraulics,
            numerics,
            indicators,
            bit_table,
            nodes,
            wear,
            contact,
            series,
        } = outcome;
        let statistics = statistics.iter().map(|(name, of)| {
            let statistic = Statistic {
                mean: of.mean,
                std: of.std,
                min: of.min,
                max: of.max,
                p05: of.p05,
                p95: of.p95,
                std_error: of.std_error,
                drift: of.drift,
                drifts: of.drifts,
            };
            ((*name).to_owned(), statistic)
        });
        let last_s = series.time_s.last().copied().unwrap_or(0.0);
        let simulated_s = last_s * effort.runs as f64;
        let wall_time_s = effort.took.as_secs_f64();
        let solved = OperationSummary {
            status,
            lift,
            hydraulics: *hydraulics,
            statistics: Some(statistics.collect()),
            indicators: Some(*indicators),
            bit_table: *bit_table,
            numerics: Some(Numerics {
                elements: numerics.elements,
                time_step_s: numerics.time_step_s,
                steps: numerics.steps,
                added_axial_mass_fraction: numerics.added_axial_mass_fraction,
                max_penetration_m: numerics.max_penetration_m,
                energy_residual: numerics.energy_residual,
                energy: numerics.energy,
                instructions: numerics.instructions.into(),
                settle_s: Some(numerics.settle_s),
                settled: numerics.settled,
                mean_bit_depth_m: Some(numerics.mean_bit_depth_m),
                bit_travel_m: Some(numerics.bit_travel_m),
                wall_time_s,
                real_time_factor: simulated_s / wall_time_s,
            }),
            ..self.solved(ModelKind::Dynamic, operation, *scalars)
        };
        self.summary.operations.push(solved);
        self.add_profile(operation, nodes);
        self.wear.append(
            &[
                ("model", &["dynamic"]),
                ("operation", &[operation.kind.name()]),
            ],
            &[
                ("md_m", &wear.md_m),
                ("wear_work_J_per_m", &wear.wear_work_J_per_m),
                ("wear_power_W_per_m", &wear.wear_power_W_per_m),
            ],
        );
        self.contact.append(
            &[("operation", &[operation.kind.name()])],
            &[
                ("time_s", &contact.time_s),
                ("md_m", &contact.md_m),
                ("side_force_N_per_m", &contact.side_force_N_per_m),
                ("contact_force_N_per_m", &contact.contact_force_N_per_m),
            ],
        );
        if let Some(bottom) = bottom {
            let [radius_m, angle_rad, depth_m] = bottom_rows(bottom);
            self.bottom_hole.append(
                &[("operation", &[operation.kind.name()])],
                &[
                    ("radius_m", &radius_m),
                    ("angle_rad", &angle_rad),
                    ("depth_m", &depth_m),
                ],
            );
        }
        self.add_series(operation, series);
        self.add_spectra(operation, outcome);
    }

    fn add_profile(&mut self, operation: &Operation, nodes: &NodeProfile) {
        self.nodes.append(
            &[
                ("model", &["dynamic"]),
                ("operation", &[operation.kind.name()]),
                ("contact_class", &classes(&nodes.contact_fraction)),
                ("contact_side", &sides(&nodes.side_force_N_per_m)),
            ],
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
                ("climb_rad", &numbers(&nodes.climb_rad)),
                ("lateral_offset_m", &nodes.lateral_offset_m),
                ("axial_friction_N_per_m", &nodes.axial_friction_N_per_m),
                (
                    "friction_torque_N_m_per_m",
                    &nodes.friction_torque_N_m_per_m,
                ),
                (
                    "side_force_per_joint_N",
                    &numbers(&nodes.side_force_per_joint_N),
                ),
                ("tension_p05_N", &nodes.tension_percentiles_N.p05),
                ("tension_p50_N", &nodes.tension_percentiles_N.p50),
                ("tension_p95_N", &nodes.tension_percentiles_N.p95),
                ("torque_p05_N_m", &nodes.torque_percentiles_N_m.p05),
                ("torque_p50_N_m", &nodes.torque_percentiles_N_m.p50),
                ("torque_p95_N_m", &nodes.torque_percentiles_N_m.p95),
                (
                    "side_force_p05_N_per_m",
                    &nodes.side_force_percentiles_N_per_m.p05,
                ),
                (
                    "side_force_p50_N_per_m",
                    &nodes.side_force_percentiles_N_per_m.p50,
                ),
                (
                    "side_force_p95_N_per_m",
                    &nodes.side_force_percentiles_N_per_m.p95,
                ),
                (
                    "contact_force_p05_N",
                    &nodes.contact_force_percentiles_N.p05,
                ),
                (
                    "contact_force_p50_N",
                    &nodes.contact_force_percentiles_N.p50,
                ),
                (
                    "contact_force_p95_N",
                    &nodes.contact_force_percentiles_N.p95,
                ),
                ("true_tension_N", &nodes.true_tension_N),
                ("outside_pressure_Pa", &nodes.outside_pressure_Pa),
                ("inside_pressure_Pa", &nodes.inside_pressure_Pa),
                ("bending_moment_N_m", &nodes.bending_moment_N_m),
                ("bending_moment_max_N_m", &nodes.bending_moment_max_N_m),
                (
                    "bending_moment_p05_N_m",
                    &nodes.bending_moment_percentiles_N_m.p05,
                ),
                (
                    "bending_moment_p50_N_m",
                    &nodes.bending_moment_percentiles_N_m.p50,
                ),
                (
                    "bending_moment_p95_N_m",
                    &nodes.bending_moment_percentiles_N_m.p95,
                ),
                ("bending_stress_Pa", &nodes.bending_stress_Pa),
                ("von_mises_stress_Pa", &nodes.von_mises_stress_Pa),
                ("von_mises_stress_max_Pa", &nodes.von_mises_stress_max_Pa),
                ("yield_use", &numbers(&nodes.yield_use)),
                ("whirl_rate_rad_per_s", &nodes.whirl_rate_rad_per_s),
                ("whirl_coherence", &nodes.whirl_coherence),
                (
                    "lateral_speed_rms_m_per_s",
                    &nodes.lateral_speed_rms_m_per_s,
                ),
                ("wear_work_J_per_m", &nodes.wear_work_J_per_m),
                ("wear_power_W_per_m", &nodes.wear_power_W_per_m),
                ("twist_rad", &nodes.twist_rad),
                ("stretch_m", &nodes.stretch_m),
            ],
        );
    }

    fn add_series(&mut self, operation: &Operation, series: &TimeSeries) {
        let notes = notes(&self.schedule, &series.schedule_line);
        self.time.append(
            &[("operation", &[operation.kind.name()]), ("note", &notes)],
            &[
                ("time_s", &series.time_s),
                ("bit_depth_m", &series.bit_depth_m),
                ("weight_on_bit_N", &series.weight_on_bit_N),
                ("bit_torque_N_m", &series.bit_torque_N_m),
                ("bit_force_high_N", &series.bit_force_high_N),
                ("bit_force_right_N", &series.bit_force_right_N),
                ("bit_moment_N_m", &series.bit_moment_N_m),
                ("depth_of_cut_m", &series.depth_of_cut_m),
                (
                    "rate_of_penetration_m_per_s",
                    &series.rate_of_penetration_m_per_s,
                ),
                (
                    "motor_speed_rad_per_s",
                    &numbers(&series.motor_speed_rad_per_s),
                ),
                ("motor_pressure_Pa", &numbers(&series.motor_pressure_Pa)),
                ("hook_load_N", &series.hook_load_N),
                ("surface_torque_N_m", &series.surface_torque_N_m),
                ("friction_torque_N_m", &series.friction_torque_N_m),
                ("axial_friction_N", &series.axial_friction_N),
                ("side_force_total_N", &series.side_force_total_N),
                ("twist_rad", &series.twist_rad),
                ("stretch_m", &series.stretch_m),
                ("neutral_point_m", &numbers(&series.neutral_point_m)),
                ("cutoff_depth_m", &numbers(&series.cutoff_depth_m)),
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
                    &numbers(&series.block_velocity_set_m_per_s),
                ),
                ("weight_on_bit_set_N", &numbers(&series.weight_on_bit_set_N)),
                ("flow_rate_m3_per_s", &series.flow_rate_m3_per_s),
                ("pump_pressure_Pa", &numbers(&series.pump_pressure_Pa)),
            ],
        );
    }

    /// Adds the spectra that the case asks for; a window that was interrupted before a segment of it was full is
    /// one segment.
    fn add_spectra(&mut self, operation: &Operation, outcome: &DynamicOutcome) {
        let series = &outcome.series;
        let settle_s = outcome.numerics.settle_s;
        let from = series.time_s.partition_point(|time| *time < settle_s);
        let [first, .., last] = series.time_s[from..] else {
            return;
        };
        let interval_s = (last - first) / (series.time_s.len() - from - 1) as f64;
        // Rounding to whole steps may leave the window a sample short.
        let segment = (self.records.spectrum_segment_s / interval_s).round() as usize;
        let scalars = self.records.spectra.iter();
        let scalars = scalars.map(|s| (s.name(), s.unit(), None, s.of(series)));
        let probed = series.probes.iter();
        let probed = probed.map(|p| {
            let md_m = outcome.nodes.md_m[p.node];
            (p.signal.name(), p.signal.unit(), Some(md_m), &p.samples[..])
        });
        for (name, unit, md_m, samples) in scalars.chain(probed) {
            let samples = &samples[from..];
            let segment = segment.min(samples.len());
            if let Some(spectrum) = Spectrum::welch(samples, interval_s, segment) {
                self.spectra.append(
                    &[
                        ("operation", &[operation.kind.name()]),
                        ("signal", &[name]),
                        ("unit", &[unit]),
                    ],
                    &[
                        ("md_m", &numbers(&vec![md_m; spectrum.density.len()])),
                        ("frequency_Hz", &spectrum.frequency_Hz),
                        ("density", &spectrum.density),
                    ],
                );
            }
        }
    }
}

/// Radius, angle and depth of every cell of a bottom, ring after ring.
pub(crate) fn bottom_rows(bottom: &BottomHole) -> [Vec<f64>; 3] {
    let cells = (0..bottom.rings())
        .flat_map(|ring| (0..bottom.sectors()).map(move |sector| (ring, sector)));
    let column = |of: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
        cells
            .clone()
            .map(|(ring, sector)| of(ring, sector))
            .collect()
    };
    [
        column(&|ring, _| bottom.radius_m(ring)),
        column(&|_, sector| bottom.angle_rad(sector)),
        column(&|ring, sector| bottom.z_m(ring, sector).unwrap_or(f64::NAN)),
    ]
}

/// The table writes what is not finite as `null`.
fn numbers(values: &[Option<f64>]) -> Vec<f64> {
    let number = |value: &Option<f64>| value.unwrap_or(f64::NAN);
    values.iter().map(number).collect()
}

/// The note of the line of a schedule that began last, at each row.
fn notes<'a>(schedule: &'a [ScheduleStep], lines: &[usize]) -> Vec<&'a str> {
    let note = |line: &usize| {
        let begun = schedule.get(..*line).unwrap_or_default();
        let notes = begun.iter().rev().map(|step| step.note.as_deref());
        notes.flatten().next().unwrap_or_default()
    };
    lines.iter().map(note).collect()
}

fn classes(contact_fraction: &[f64]) -> Vec<&'static str> {
    let class = |fraction: &f64| ContactClass::of(*fraction).name();
    contact_fraction.iter().map(class).collect()
}

fn sides(side_force: &[f64]) -> Vec<&'static str> {
    let side = |force: &f64| match *force {
        force if force > 0.0 => "high",
        force if force < 0.0 => "low",
        _ => "none",
    };
    side_force.iter().map(side).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cells_of_a_bottom_follow_each_other_ring_after_ring() {
        let mut bottom = BottomHole::new([0.02, 0.10], 4, 6);
        bottom.set_m(1, 2, -0.03);
        let [radius_m, angle_rad, depth_m] = bottom_rows(&bottom);
        assert_eq!([radius_m.len(), angle_rad.len(), depth_m.len()], [24; 3]);
        assert_eq!(radius_m[6], bottom.radius_m(1));
        assert_eq!(angle_rad[8], bottom.angle_rad(2));
        let known: Vec<usize> = (0..24).filter(|cell| depth_m[*cell].is_finite()).collect();
        assert_eq!((known, depth_m[8]), (vec![8], -0.03));
    }
}
