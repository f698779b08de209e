//! The loads of a solved operation, by row of its profile.

use wholestring::{
    model::Model,
    operation::Operation,
    outcome::{ModelKind, Profile, Solution},
    statics::soft::SoftLoads,
};

use crate::strength::BodyLoads;

/// Two places nearer than this are one, m.
const SAME_M: f64 = 1e-6;

/// The loads of an operation. Of dynamics they are the 95th percentile of tension and torque and the
/// largest moment, stress, hook load and surface torque of any sample; of a string at rest there is one
/// value.
pub struct Loads<'a> {
    pub profile: &'a Profile,
    /// Hook load, N, and magnitude of the surface torque, N·m, block excluded.
    pub hook_load_N: f64,
    pub surface_torque_N_m: f64,
    /// Friction along the hole, N.
    pub axial_friction_N: f64,
    pub pump_pressure_Pa: Option<f64>,
    /// Components at each row, from the bit: the one above first, the one below where two meet there.
    components: Vec<(usize, Option<usize>)>,
    soft: bool,
}

impl<'a> Loads<'a> {
    pub fn of(model: &Model, operation: &Operation, solution: &Solution<'a>) -> Self {
        let largest = |name: &str, at_rest: f64| {
            let statistics = solution.in_time.map_or(&[][..], |of| of.statistics);
            let of = statistics.iter().find(|(of, _)| *of == name);
            of.map_or(at_rest, |(_, of)| if of.max.abs() > of.min.abs() { of.max } else { of.min })
        };
        let scalars = solution.scalars;
        Self {
            profile: solution.profile,
            hook_load_N: largest("hook_load_N", scalars.hook_load_N),
            surface_torque_N_m: largest("surface_torque_N_m", scalars.surface_torque_N_m).abs(),
            axial_friction_N: scalars.axial_friction_N,
            pump_pressure_Pa: solution.hydraulics.map(|of| of.pump_pressure_Pa),
            components: components(model, operation, solution.profile),
            soft: solution.model == ModelKind::Soft,
        }
    }

    /// Of a soft string of which nothing else is known.
    pub fn of_soft(model: &Model, operation: &Operation, loads: &'a SoftLoads) -> Self {
        let SoftLoads { hook_load_N, surface_torque_N_m, axial_friction_N, hydraulics, profile } =
            loads;
        Self {
            profile,
            hook_load_N: *hook_load_N,
            surface_torque_N_m: surface_torque_N_m.abs(),
            axial_friction_N: *axial_friction_N,
            pump_pressure_Pa: hydraulics.map(|of| of.pump_pressure_Pa),
            components: components(model, operation, profile),
            soft: true,
        }
    }

    pub fn rows(&self) -> usize {
        self.profile.md_m.len()
    }

    /// Tension, N.
    pub fn tension_N(&self, row: usize) -> f64 {
        let p = self.profile;
        *p.tension_p95_N.get(row).unwrap_or(&p.tension_N[row])
    }

    /// Magnitude of the torque, N·m.
    pub fn torque_N_m(&self, row: usize) -> f64 {
        let p = self.profile;
        let of = |column: &[f64]| column.get(row).map_or(0.0, |of| of.abs());
        of(&p.torque_N_m).max(of(&p.torque_p05_N_m)).max(of(&p.torque_p95_N_m))
    }

    /// Largest von Mises stress of any sample, Pa; known of dynamics.
    pub fn largest_von_mises_Pa(&self, row: usize) -> Option<f64> {
        self.profile.von_mises_stress_max_Pa.get(row).copied()
    }

    /// What the body carries.
    pub fn body(&self, row: usize) -> BodyLoads {
        let p = self.profile;
        let of = |column: &[f64]| column.get(row).copied().unwrap_or(0.0);
        let at_N_m = of(&p.bending_moment_N_m).max(of(&p.bending_moment_max_N_m));
        let between_N_m =
            of(&p.bending_moment_between_N_m).max(of(&p.bending_moment_between_max_N_m));
        BodyLoads {
            effective_tension_N: self.tension_N(row),
            bending_N_m: at_N_m.max(between_N_m),
            torque_N_m: self.torque_N_m(row),
            inside_Pa: of(&p.inside_pressure_Pa),
            outside_Pa: of(&p.outside_pressure_Pa),
        }
    }

    /// Components that carry a row's force and torque.
    pub fn components(&self, row: usize) -> impl Iterator<Item = usize> {
        let (above, below) = self.components[row];
        [Some(above), below].into_iter().flatten()
    }

    /// Whether a row's bending moment is that of this component: a soft string bends each as the hole does,
    /// so that where two meet the moment is that of the one above.
    pub fn bends(&self, row: usize, component: usize) -> bool {
        !self.soft || self.components[row].0 == component
    }
}

/// Components at each row, from the bit: the one above first, the one below where two meet there.
fn components(
    model: &Model,
    operation: &Operation,
    profile: &Profile,
) -> Vec<(usize, Option<usize>)> {
    let string = &model.string;
    let of_row = |md_m: &f64| {
        let from_bit_m = operation.bit_depth_m - md_m;
        let above = string.component_at(from_bit_m + SAME_M).0;
        let below = string.component_at(from_bit_m - SAME_M).0;
        (above, (below != above).then_some(below))
    };
    profile.md_m.iter().map(of_row).collect()
}
