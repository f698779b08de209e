//! What the soft string answers with.

use nalgebra::Vector3;

use super::integrate::{Integral, Row};
use crate::{
    model::Model,
    mud::Hydraulics,
    operation::Operation,
    outcome::{HOLE_STEP_M, Scalars, cutoff_in_build_m, hole_depths_m, neutral_point_m},
};

/// Loads along the string, from the surface to the bit, and their scalars.
///
/// All vectors are of the same length; `md_m` grows strictly, from 0 to the depth of the bit. Where a
/// property jumps (a station of a minimum-curvature path, the end of a component or hole section), side
/// force and friction are those of the stretch above.
#[derive(Debug, Clone, PartialEq)]
pub struct SoftProfile {
    /// Measured depth, m.
    pub md_m: Vec<f64>,
    /// Effective tension, N.
    pub tension_N: Vec<f64>,
    /// Torque, N·m.
    pub torque_N_m: Vec<f64>,
    /// Magnitude of the load on the wall per length, N/m, positive where the pipe touches the upper
    /// half of the hole, negative on the lower half.
    pub side_force_N_per_m: Vec<f64>,
    /// Unit vector from the hole's axis to where the pipe touches the wall, the direction of the load;
    /// towards the low side where there is no load.
    pub contact_direction: Vec<Vector3<f64>>,
    /// Wall friction along the hole per length, N/m; positive adds to the hook load.
    pub axial_friction_N_per_m: Vec<f64>,
    /// Friction torque per length, N·m/m.
    pub friction_torque_N_m_per_m: Vec<f64>,
    /// Elongation of the string between the bit and this depth, m, against the unloaded string.
    pub stretch_m: Vec<f64>,
    /// Turn of the string at this depth against the bit, rad, positive when the top leads.
    pub twist_rad: Vec<f64>,
    /// Angle of the load from the low side, rad, from −π to π, positive to the right looking down the hole; none
    /// without a load.
    pub climb_rad: Vec<Option<f64>>,
    /// Distance of the string's axis from the hole's, m: it lies on the wall.
    pub lateral_offset_m: Vec<f64>,
    /// Side force that a tool joint carries, N, that per length times the joints' spacing, positive on the high side;
    /// none where the string has no joints.
    pub side_force_per_joint_N: Vec<Option<f64>>,
    /// Pressure of the mud outside, Pa: its weight and what its flow adds.
    pub outside_pressure_Pa: Vec<f64>,
    /// Pressure of the mud inside, Pa.
    pub inside_pressure_Pa: Vec<f64>,
    /// Force in the metal, N: [`crate::string::Component::true_tension_N`].
    pub true_tension_N: Vec<f64>,
    /// Largest bending moment near the place, N·m: of the hole's curvature, or of a span between tool joints at
    /// the joints or half-way ([`crate::statics::span`]).
    pub bending_moment_N_m: Vec<f64>,
    /// Stress that alternates at the surface of the body as it turns, Pa: that moment over the section modulus.
    pub bending_stress_Pa: Vec<f64>,
    /// Von Mises stress where the body's surface bears most, Pa: [`crate::string::BodySection::von_mises_Pa`].
    pub von_mises_stress_Pa: Vec<f64>,
    /// That stress over the minimum yield strength, where it is known.
    pub yield_use: Vec<Option<f64>>,
    /// Power of friction per metre of string, W/m: force times sliding speed.
    pub wear_power_W_per_m: Vec<f64>,
    /// The same along the hole.
    pub wear: SoftHoleWear,
    /// The operation's scalars.
    pub scalars: Scalars,
    /// What the mud does; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
}

/// Power of friction on the hole, from the surface to the bit, one row per [`HOLE_STEP_M`].
#[derive(Debug, Clone, PartialEq)]
pub struct SoftHoleWear {
    /// Measured depth of the middle of the stretch, m.
    pub md_m: Vec<f64>,
    /// Power per metre of hole, W/m: friction force times sliding speed.
    pub wear_power_W_per_m: Vec<f64>,
}

impl SoftProfile {
    pub(super) fn new(model: &Model, operation: &Operation, integral: Integral) -> Self {
        let Integral {
            mut rows,
            totals,
            hole_W,
            hydraulics,
        } = integral;
        rows.reverse();
        let column = |of: fn(&Row) -> f64| rows.iter().map(of).collect::<Vec<f64>>();
        let md_m = column(|row| row.md_m);
        let maybe = |of: fn(&Row) -> Option<f64>| rows.iter().map(of).collect::<Vec<_>>();
        let tension_N = column(|row| row.totals.tension_N);
        let side_force_N_per_m = column(|row| {
            let side = row.load.q_N_per_m.dot(&row.high_side);
            row.load.side_force_N_per_m.copysign(side)
        });
        let bit_torque_N_m = operation.bit_torque_now_N_m();
        let scalars = Scalars {
            hook_load_N: totals.tension_N,
            surface_torque_N_m: totals.torque_N_m,
            friction_torque_N_m: totals.torque_N_m
                - bit_torque_N_m
                - hydraulics.map_or(0.0, |mud| mud.mud_torque_N_m),
            axial_friction_N: totals.axial_friction_N,
            side_force_total_N: totals.side_force_N,
            weight_on_bit_N: operation.weight_on_bit_now_N(),
            bit_torque_N_m,
            twist_rad: totals.twist_rad,
            stretch_m: totals.stretch_m,
            neutral_point_m: neutral_point_m(&md_m, &tension_N),
            cutoff_depth_m: cutoff_in_build_m(
                &model.well.path,
                operation.bit_depth_m,
                &md_m,
                &side_force_N_per_m,
            ),
        };
        Self {
            torque_N_m: column(|row| row.totals.torque_N_m),
            contact_direction: rows
                .iter()
                .map(|row| {
                    let load = row.load.q_N_per_m.try_normalize(0.0);
                    load.unwrap_or(-row.high_side)
                })
                .collect(),
            axial_friction_N_per_m: column(|row| row.load.axial_friction_N_per_m),
            friction_torque_N_m_per_m: column(|row| row.load.friction_torque_N_m_per_m),
            stretch_m: column(|row| row.totals.stretch_m),
            twist_rad: column(|row| row.totals.twist_rad),
            climb_rad: maybe(|row| row.bearing.climb_rad),
            lateral_offset_m: column(|row| row.bearing.lateral_offset_m),
            side_force_per_joint_N: maybe(|row| row.bearing.side_force_per_joint_N),
            outside_pressure_Pa: column(|row| row.bearing.outside_pressure_Pa),
            inside_pressure_Pa: column(|row| row.bearing.inside_pressure_Pa),
            true_tension_N: column(|row| row.bearing.true_tension_N),
            bending_moment_N_m: column(|row| row.bearing.bending_moment_N_m),
            bending_stress_Pa: column(|row| row.bearing.bending_stress_Pa),
            von_mises_stress_Pa: column(|row| row.bearing.von_mises_stress_Pa),
            yield_use: maybe(|row| row.bearing.yield_use),
            wear_power_W_per_m: column(|row| row.bearing.wear_power_W_per_m),
            wear: SoftHoleWear {
                md_m: hole_depths_m(hole_W.len()),
                wear_power_W_per_m: hole_W.iter().map(|power| power / HOLE_STEP_M).collect(),
            },
            md_m,
            tension_N,
            side_force_N_per_m,
            scalars,
            hydraulics,
        }
    }

    /// Effective tension at a measured depth, N, linear between the rows; the end's value beyond them.
    pub fn tension_at_N(&self, md_m: f64) -> f64 {
        interpolate(&self.md_m, &self.tension_N, md_m)
    }

    /// Signed side force at a measured depth, N/m, linear between the rows; the end's value beyond them.
    pub fn side_force_at_N_per_m(&self, md_m: f64) -> f64 {
        interpolate(&self.md_m, &self.side_force_N_per_m, md_m)
    }

    /// Direction of contact at a measured depth: that of the nearest row.
    pub fn contact_direction_at(&self, md_m: f64) -> Vector3<f64> {
        let below = self.md_m.partition_point(|&md| md < md_m);
        let below = below.min(self.md_m.len() - 1);
        let above = below.saturating_sub(1);
        let nearer_above = md_m - self.md_m[above] < self.md_m[below] - md_m;
        self.contact_direction[if nearer_above { above } else { below }]
    }
}

fn interpolate(md: &[f64], values: &[f64], at_m: f64) -> f64 {
    let below = md.partition_point(|&md| md < at_m);
    if below == 0 {
        return values[0];
    }
    if below == md.len() {
        return values[below - 1];
    }
    let part = (at_m - md[below - 1]) / (md[below] - md[below - 1]);
    values[below - 1] + part * (values[below] - values[below - 1])
}
