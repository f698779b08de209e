//! The loads of a solved operation, by row of its profile.

use wholestring::{
    model::Model,
    mud::Hydraulics,
    operation::Operation,
    outcome::{ModelKind, Profile, Solution},
    statics::soft::SoftLoads,
};

use crate::{recent::Recent, strength::BodyLoads, window::Window};

/// Two places nearer than this are one, m.
const SAME_M: f64 = 1e-6;

/// A load at the surface. A static equilibrium has a single value.
#[derive(Debug, Clone, Copy)]
pub struct SurfaceLoad {
    /// Its mean over the window.
    pub mean: f64,
    /// The largest of any sample.
    pub largest: f64,
}

impl SurfaceLoad {
    const NONE: Self = Self::steady(0.0);

    const fn steady(value: f64) -> Self {
        Self { mean: value, largest: value }
    }

    /// Mean and largest magnitude of samples; `None` without a known one.
    fn of_samples(samples: &[f64]) -> Option<Self> {
        let known = || samples.iter().copied().filter(|sample| !sample.is_nan());
        let largest = known().reduce(|a, b| if b.abs() > a.abs() { b } else { a })?;
        Some(Self { mean: known().sum::<f64>() / known().count() as f64, largest })
    }

    const fn magnitude(self) -> Self {
        Self { mean: self.mean.abs(), largest: self.largest.abs() }
    }
}

/// The loads of an operation. For a dynamic run they are the 95th percentile of tension and torque
/// and the largest moment, stress, hook load and surface torque of any sample; a static equilibrium
/// has a single value.
pub struct Loads<'a> {
    pub profile: &'a Profile,
    /// Hook load, N, block excluded.
    pub hook_load_N: SurfaceLoad,
    /// Magnitude of the surface torque, N·m.
    pub surface_torque_N_m: SurfaceLoad,
    /// Discharge pressure of the pump, Pa; `None` without a rheology.
    pub pump_pressure_Pa: Option<SurfaceLoad>,
    /// Pressures and forces of the mud; `None` without a rheology.
    pub hydraulics: Option<Hydraulics>,
    /// Components at each row, from the bit: the one above first, then the one below where two
    /// meet.
    components: Vec<(usize, Option<usize>)>,
    soft: bool,
}

impl<'a> Loads<'a> {
    pub fn of(model: &Model, operation: &Operation, solution: &Solution<'a>) -> Self {
        let load = |name: &str, mean: f64| {
            let statistics = solution.in_time.map_or(&[][..], |in_time| in_time.statistics);
            let statistic = statistics.iter().find(|(quantity, _)| *quantity == name);
            let Some((_, statistic)) = statistic else { return SurfaceLoad::steady(mean) };
            let turned = statistic.max.abs() > statistic.min.abs();
            let largest = if turned { statistic.max } else { statistic.min };
            SurfaceLoad { mean: statistic.mean, largest }
        };
        let scalars = solution.scalars;
        let torque_N_m = load("surface_torque_N_m", scalars.surface_torque_N_m);
        let pump_pressure_Pa = solution.hydraulics.map(|hydraulics| {
            let mean = hydraulics.pump_pressure_Pa;
            let window = solution.in_time.as_ref().and_then(Window::of);
            let largest = window.and_then(|window| window.largest_pump_pressure_Pa());
            SurfaceLoad { mean, largest: largest.map_or(mean, |largest| largest.max(mean)) }
        });
        Self {
            profile: solution.profile,
            hook_load_N: load("hook_load_N", scalars.hook_load_N),
            surface_torque_N_m: SurfaceLoad {
                mean: torque_N_m.mean.abs(),
                largest: torque_N_m.largest.abs(),
            },
            pump_pressure_Pa,
            hydraulics: solution.hydraulics,
            components: components(model, operation, solution.profile),
            soft: solution.model == ModelKind::Soft,
        }
    }

    /// The loads of a live string over the last seconds.
    pub fn of_recent(model: &Model, operation: &Operation, recent: &Recent<'a>) -> Self {
        Self {
            profile: recent.largest,
            hook_load_N: SurfaceLoad::of_samples(recent.hook_load_N).unwrap_or(SurfaceLoad::NONE),
            surface_torque_N_m: SurfaceLoad::of_samples(recent.surface_torque_N_m)
                .map_or(SurfaceLoad::NONE, SurfaceLoad::magnitude),
            pump_pressure_Pa: SurfaceLoad::of_samples(recent.pump_pressure_Pa),
            hydraulics: None,
            components: components(model, operation, recent.largest),
            soft: false,
        }
    }

    /// The loads of a soft string of which nothing else is known.
    pub fn of_soft(model: &Model, operation: &Operation, loads: &'a SoftLoads) -> Self {
        let SoftLoads { hook_load_N, surface_torque_N_m, hydraulics, profile, .. } = loads;
        let pump_Pa = hydraulics.map(|hydraulics| hydraulics.pump_pressure_Pa);
        Self {
            profile,
            hook_load_N: SurfaceLoad::steady(*hook_load_N),
            surface_torque_N_m: SurfaceLoad::steady(surface_torque_N_m.abs()),
            pump_pressure_Pa: pump_Pa.map(SurfaceLoad::steady),
            hydraulics: *hydraulics,
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
        let value = |column: &[f64]| column.get(row).map_or(0.0, |value| value.abs());
        value(&p.torque_N_m).max(value(&p.torque_p05_N_m)).max(value(&p.torque_p95_N_m))
    }

    /// Largest von Mises stress of any sample, Pa; known for a dynamic run.
    pub fn largest_von_mises_Pa(&self, row: usize) -> Option<f64> {
        self.profile.von_mises_stress_max_Pa.get(row).copied()
    }

    /// Loads of the body.
    pub fn body(&self, row: usize) -> BodyLoads {
        let p = self.profile;
        let value = |column: &[f64]| column.get(row).copied().unwrap_or(0.0);
        let at_N_m = value(&p.bending_moment_N_m).max(value(&p.bending_moment_max_N_m));
        let between_N_m =
            value(&p.bending_moment_between_N_m).max(value(&p.bending_moment_between_max_N_m));
        BodyLoads {
            effective_tension_N: self.tension_N(row),
            bending_N_m: at_N_m.max(between_N_m),
            torque_N_m: self.torque_N_m(row),
            inside_Pa: value(&p.inside_pressure_Pa),
            outside_Pa: value(&p.outside_pressure_Pa),
        }
    }

    /// Components that carry a row's force and torque.
    pub fn components(&self, row: usize) -> impl Iterator<Item = usize> {
        let (above, below) = self.components[row];
        [Some(above), below].into_iter().flatten()
    }

    /// The component above a row.
    pub fn component_above(&self, row: usize) -> usize {
        self.components[row].0
    }

    /// Whether a row's bending moment belongs to this component: a soft string bends each component
    /// as the hole does, so that where two meet the moment is that of the one above.
    pub fn bends(&self, row: usize, component: usize) -> bool {
        !self.soft || self.components[row].0 == component
    }
}

/// Components at each row, from the bit: the one above first, then the one below where two meet.
fn components(
    model: &Model,
    operation: &Operation,
    profile: &Profile,
) -> Vec<(usize, Option<usize>)> {
    let string = &model.string;
    let at_row = |md_m: &f64| {
        let from_bit_m = operation.bit_depth_m - md_m;
        let above = string.component_at(from_bit_m + SAME_M).0;
        let below = string.component_at(from_bit_m - SAME_M).0;
        (above, (below != above).then_some(below))
    };
    profile.md_m.iter().map(at_row).collect()
}
