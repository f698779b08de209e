//! Everything about every step, and the wear of the hole.

use nalgebra::Vector3;

use super::{
    bearing::Bearing,
    hole::Node,
    integrate::Keep,
    load::{Load, Totals},
    segment::Segment,
};
use crate::{
    operation::Operation,
    outcome::{hole_steps, spread},
};

/// State and load at one depth.
pub(super) struct Row {
    pub(super) md_m: f64,
    pub(super) totals: Totals,
    /// Increase of the tension per metre upwards, N/m.
    pub(super) tension_rate_N_per_m: f64,
    pub(super) load: Load,
    pub(super) high_side: Vector3<f64>,
    pub(super) bearing: Bearing,
    /// Of the sinusoid and the helix; none where there is no clearance.
    pub(super) buckling_loads_N: Option<[f64; 2]>,
}

/// Rows from the bit up, at least two, and the power of friction on the hole.
pub(super) struct Rows {
    pub(super) rows: Vec<Row>,
    /// On each stretch of [`HOLE_STEP_M`](crate::outcome::HOLE_STEP_M), W.
    pub(super) hole_W: Vec<f64>,
    axial_m_per_s: f64,
    rotation_rad_per_s: f64,
}

impl Rows {
    /// Room for so many of an operation.
    pub(super) fn new(operation: &Operation, count: usize) -> Self {
        Self {
            rows: Vec::with_capacity(count),
            hole_W: vec![0.0; hole_steps(operation.bit_depth_m)],
            axial_m_per_s: operation.axial_velocity_m_per_s(),
            rotation_rad_per_s: operation.rotation_rad_per_s(),
        }
    }
}

impl Keep for Rows {
    fn node(&mut self, segment: &Segment<'_>, node: &Node, totals: &Totals, load: &Load) {
        let Node { md_m, point, high_side, buckling_loads } = node;
        let pressures_Pa = segment.pressures_Pa(node);
        self.rows.push(Row {
            md_m: *md_m,
            totals: *totals,
            tension_rate_N_per_m: segment.rate_under(point, totals, load).tension_N,
            load: *load,
            high_side: *high_side,
            bearing: segment.carrier.bears(point, high_side, load, totals, pressures_Pa),
            buckling_loads_N: buckling_loads.compared_with_N(-totals.tension_N),
        });
    }

    fn step(
        &mut self,
        segment: &Segment<'_>,
        step_m: f64,
        (lower_md_m, before): (f64, &Totals),
        (upper_md_m, totals): (f64, &Totals),
    ) {
        let mud_N_m = segment.circulating.torque_N_m_per_m * step_m;
        let rubbed_N_m = totals.torque_N_m - before.torque_N_m - mud_N_m;
        // Force times sliding speed, about and along; the work on the mud is not wall friction.
        let rubbed_W = self.rotation_rad_per_s * rubbed_N_m
            - self.axial_m_per_s * (totals.axial_friction_N - before.axial_friction_N);
        spread(&mut self.hole_W, upper_md_m, lower_md_m, rubbed_W);
    }
}
