//! Results that an integration keeps: loads, every step with the wear of the hole, or margins of
//! buckling.

use nalgebra::Vector3;

use super::{
    bearing::Bearing,
    hole::Node,
    integrate::{Integral, Keep},
    load::{Load, Totals},
    segment::Segment,
};
use crate::{
    mud::Hydraulics,
    operation::Operation,
    outcome::{Profile, hole_steps, spread},
};

/// Loads of the string and the rig: less than a [`SoftProfile`](super::SoftProfile), in less than
/// half of its time, and the same to the last digit.
#[derive(Debug, Clone, PartialEq)]
pub struct SoftLoads {
    /// Hook load, N.
    pub hook_load_N: f64,
    /// Torque at the surface, N·m.
    pub surface_torque_N_m: f64,
    /// Friction along the hole, N, positive where it adds to the hook load.
    pub axial_friction_N: f64,
    /// Effect of the mud; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
    /// Along the string: depth, tension, torque, bending moments, pressures and buckling loads. The
    /// other columns are empty.
    pub profile: Profile,
}

impl SoftLoads {
    pub(super) fn new(loads: Loads, integral: &Integral) -> Self {
        let Loads(mut profile) = loads;
        let Profile {
            md_m,
            tension_N,
            torque_N_m,
            bending_moment_N_m,
            bending_moment_between_N_m,
            outside_pressure_Pa,
            inside_pressure_Pa,
            sinusoidal_load_N,
            helical_load_N,
            ..
        } = &mut profile;
        // From the surface down.
        for column in [
            md_m,
            tension_N,
            torque_N_m,
            bending_moment_N_m,
            bending_moment_between_N_m,
            outside_pressure_Pa,
            inside_pressure_Pa,
        ] {
            column.reverse();
        }
        sinusoidal_load_N.reverse();
        helical_load_N.reverse();
        let Totals { tension_N, torque_N_m, axial_friction_N, .. } = integral.totals;
        Self {
            hook_load_N: tension_N,
            surface_torque_N_m: torque_N_m,
            axial_friction_N,
            hydraulics: integral.hydraulics,
            profile,
        }
    }
}

/// The columns of [`SoftLoads`], from the bit up.
pub(super) struct Loads(Profile);

impl Loads {
    /// Room for so many rows.
    pub(super) fn new(count: usize) -> Self {
        let numbers = || Vec::with_capacity(count);
        Self(Profile {
            md_m: numbers(),
            tension_N: numbers(),
            torque_N_m: numbers(),
            bending_moment_N_m: numbers(),
            bending_moment_between_N_m: numbers(),
            outside_pressure_Pa: numbers(),
            inside_pressure_Pa: numbers(),
            sinusoidal_load_N: Vec::with_capacity(count),
            helical_load_N: Vec::with_capacity(count),
            ..Profile::default()
        })
    }
}

impl Keep for Loads {
    fn node(&mut self, segment: &Segment<'_>, node: &Node, totals: &Totals, load: &Load) {
        let Self(profile) = self;
        let [at_joint_N_m, between_N_m] = segment.carrier.moments_N_m(&node.point, load, totals);
        let [outside_Pa, inside_Pa] = segment.pressures_Pa(node);
        profile.md_m.push(node.md_m);
        profile.tension_N.push(totals.tension_N);
        profile.torque_N_m.push(totals.torque_N_m);
        profile.bending_moment_N_m.push(at_joint_N_m);
        profile.bending_moment_between_N_m.push(between_N_m);
        profile.outside_pressure_Pa.push(outside_Pa);
        profile.inside_pressure_Pa.push(inside_Pa);
        profile.push_buckling_loads(node.buckling_loads.compared_with_N(-totals.tension_N));
    }
}

// Everything about every step, and the wear of the hole.

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

// Additional compression of a string up to buckling.

/// The least margins so far, N, before a sinusoid and before a helix.
pub(super) struct BucklingMargins(pub(super) [f64; 2]);

impl BucklingMargins {
    /// Nothing can buckle yet.
    pub(super) const NONE: Self = Self([f64::INFINITY; 2]);
}

impl Keep for BucklingMargins {
    fn node(&mut self, _: &Segment<'_>, node: &Node, totals: &Totals, _: &Load) {
        let Some(loads_N) = node.buckling_loads.compared_with_N(-totals.tension_N) else {
            return;
        };
        for (least_N, load_N) in self.0.iter_mut().zip(loads_N) {
            *least_N = least_N.min(load_N + totals.tension_N);
        }
    }
}
