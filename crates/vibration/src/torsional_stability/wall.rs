//! Effect of wall and mud on small vibrations of a string that turns and advances steadily.

use super::pressing::Pressing;
use wholestring::{
    dynamics::{DynamicsSettings, FrictionLaw},
    model::Model,
    mud::{Annulus, Motion},
    operation::Operation,
    rod::mesh::Mesh,
    well::Friction,
};

/// Part of the spin over which the slope of the mud's torque is taken.
const STEP: f64 = 1e-3;

/// Drag at the nodes against small motions: about the axis, N·m·s, and along the hole, N·s/m.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Drag {
    pub(super) about_N_m_s: Vec<f64>,
    pub(super) along_N_s_per_m: Vec<f64>,
}

/// Sliding of a node.
#[derive(Clone, Copy)]
struct Sliding {
    around_m_per_s: f64,
    along_m_per_s: f64,
}

impl Drag {
    /// Of a string that is pressed on the wall so, turning and advancing at these speeds.
    pub(super) fn new(
        model: &Model,
        mesh: &Mesh,
        settings: &DynamicsSettings,
        operation: &Operation,
        pressing: &Pressing,
        rate_m_per_s: f64,
    ) -> Self {
        let nodes = mesh.nodes.len();
        let mut drag = Self { about_N_m_s: vec![0.0; nodes], along_N_s_per_m: vec![0.0; nodes] };
        let spin = operation.rotation_rad_per_s();
        for (index, node) in mesh.nodes.iter().enumerate() {
            let normal_N = pressing.contact_force_N[index];
            if normal_N > 0.0 {
                let radius_m = node.contact_radius_m;
                let sliding =
                    Sliding { around_m_per_s: radius_m * spin, along_m_per_s: rate_m_per_s };
                let hole = model.well.hole.at(operation.bit_depth_m - node.from_bit_m);
                let [about, along] = slopes(settings, hole.friction, sliding);
                drag.about_N_m_s[index] += normal_N * radius_m * radius_m * about;
                drag.along_N_s_per_m[index] += normal_N * along;
            }
        }
        drag.add_mud(model, mesh, operation, rate_m_per_s);
        drag
    }

    /// The mud's torque and drag; the ends' go to their neighbours, as in the dynamics.
    fn add_mud(&mut self, model: &Model, mesh: &Mesh, operation: &Operation, axial_m_per_s: f64) {
        if !model.has_rheology() {
            return;
        }
        let spin = operation.rotation_rad_per_s();
        let last = mesh.nodes.len() - 1;
        for (index, element) in mesh.elements.iter().enumerate() {
            let from_bit_m = mesh.nodes[index].from_bit_m - 0.5 * element.length_m;
            let md_m = operation.bit_depth_m - from_bit_m;
            let hole = model.well.hole.at(md_m);
            let fluid = model.fluids.annulus_at(&model.mud, md_m);
            let annulus = Annulus::new(element.section.od_m, hole.diameter_m);
            let at = |spin_rad_per_s: f64| {
                let flow_m3_per_s = operation.flow_now_m3_per_s();
                let motion = Motion { axial_m_per_s, spin_rad_per_s, flow_m3_per_s };
                annulus.drag(&fluid, &motion)
            };
            let (slow, fast) = (spin * (1.0 - STEP), spin * (1.0 + STEP));
            let about = (at(slow).torque_N(slow) - at(fast).torque_N(fast)) / (fast - slow);
            let along = at(spin).drag_Pa_s;
            for end in [index, index + 1] {
                let node = end.clamp(1.min(last), last.saturating_sub(1).max(1));
                self.about_N_m_s[node] += 0.5 * element.length_m * about;
                self.along_N_s_per_m[node] += 0.5 * element.length_m * along;
            }
        }
    }
}

/// Increase of friction per sliding speed around the hole and along it, per contact force, s/m.
///
/// Of `f = μ(|u|) u/|u|`: `∂f_t/∂u_t = μ′ u_t²/|u|² + μ u_a²/|u|³`, and along the hole with `t` and
/// `a` exchanged; where each direction has the full friction by its own sign, `μ′ |u_i|/|u|`.
fn slopes(settings: &DynamicsSettings, friction: Friction, sliding: Sliding) -> [f64; 2] {
    let Sliding { around_m_per_s: t, along_m_per_s: a } = sliding;
    let speed = libm::hypot(t, a);
    if speed <= 0.0 {
        return [0.0, 0.0];
    }
    let rise = friction.at_rest - friction.kinetic;
    let settled = settings.stribeck_speed_m_per_s;
    let decayed = 1.0 + (speed / settled).powi(2);
    let mu = friction.kinetic + rise / decayed;
    let falls = -2.0 * rise * speed / (settled * decayed).powi(2);
    let slope = |own: f64, other: f64| match settings.friction_law {
        FrictionLaw::Vector => falls * (own / speed).powi(2) + mu * (other / speed).powi(2) / speed,
        FrictionLaw::Independent => falls * own.abs() / speed,
    };
    [friction.around * slope(t, a), slope(a, t)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slopes are those of the friction itself, by central differences: rounding and the cube
    /// of the difference are left.
    #[test]
    fn slopes_are_those_of_the_friction() {
        let friction = Friction { kinetic: 0.2, at_rest: 0.35, around: 0.8 };
        let settings = DynamicsSettings::default();
        let force = |t: f64, a: f64| {
            let speed = t.hypot(a);
            let rise = friction.at_rest - friction.kinetic;
            let mu =
                friction.kinetic + rise / (1.0 + (speed / settings.stribeck_speed_m_per_s).powi(2));
            [friction.around * mu * t / speed, mu * a / speed]
        };
        for (t, a) in [(0.6, 0.003), (0.05, 0.04), (0.01, 0.2)] {
            let sliding = Sliding { around_m_per_s: t, along_m_per_s: a };
            let [about, along] = slopes(&settings, friction, sliding);
            let h = 1e-6;
            let by_t = (force(t + h, a)[0] - force(t - h, a)[0]) / (2.0 * h);
            let by_a = (force(t, a + h)[1] - force(t, a - h)[1]) / (2.0 * h);
            assert!((about - by_t).abs() < 1e-6 * (1.0 + by_t.abs()), "{about} {by_t}");
            assert!((along - by_a).abs() < 1e-6 * (1.0 + by_a.abs()), "{along} {by_a}");
        }
    }
}
