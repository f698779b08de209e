//! Loads of the string, without the other results.

use super::{
    hole::Node,
    integrate::{Integral, Keep},
    load::{Load, Totals},
    segment::Segment,
};
use crate::{mud::Hydraulics, outcome::Profile};

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
