//! Mud between a pipe and its hole: steady helical flow, and its effect on the pipe.
//!
//! With `G` the pressure's gradient by friction, `r` the radius, `z` along the hole and `γ̇` the rate
//! of shear,
//!
#![doc = include_str!("../../equations/helical-flow.html")]
//!
//! (Coleman, Markovitz and Noll 1966). `G`, `B` and `C` follow from the pipe's velocity, its spin
//! and the flow rate; `2π B` per length loads the effective tension, `2π C` is the torque. Theory:
//! `docs/src/theory/mud.md`.

use std::{
    f64::consts::PI,
    ops::{Add, Mul},
    sync::LazyLock,
};

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use super::{Mud, Rheology, turbulence};

/// Greatest radius of a pipe, as a fraction of that of its hole: wider components have blades or
/// junk slots that let the mud pass.
const FULLEST: f64 = 0.9;

/// Speed of shear below which a mud is taken to be sheared so all the same, m/s. A yield point
/// would otherwise hold the pipe with an infinite coefficient.
const SLOWEST_M_PER_S: f64 = 0.01;

/// Points of the quadrature in each of the two or three layers that the gap is cut into.
const POINTS: usize = 12;

/// Most iterations of Newton's method; five are usual.
const ITERATIONS: usize = 60;

/// A pipe in a hole that it shares the axis with.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Annulus {
    pipe_m: f64,
    hole_m: f64,
}

/// Motion of pipe and mud.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Motion {
    /// Velocity of the pipe along the hole, m/s, positive towards the bit.
    pub axial_m_per_s: f64,
    /// Spin of the pipe, rad/s.
    pub spin_rad_per_s: f64,
    /// Flow rate of the pump, m³/s: down the bore, up the annulus.
    pub flow_m3_per_s: f64,
}

/// Effect of the mud in the annulus on a metre of pipe. Along the hole it pulls with `pull − drag
/// v`, positive towards the bit, about the axis with `−spin_drag Ω`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct AnnulusDrag {
    /// Part of the pull along the hole that does not depend on the pipe's velocity, N/m.
    pub pull_N_per_m: f64,
    /// Decrease of the pull per velocity of the pipe, Pa·s; positive.
    pub drag_Pa_s: f64,
    /// Torque per spin, N·s; positive.
    pub spin_drag_N_s: f64,
    /// Pressure gradient of friction per metre of depth, Pa/m.
    pub gradient_Pa_per_m: f64,
    /// Its increase per velocity of the pipe towards the bit, Pa·s/m²: surge.
    pub surge_Pa_s_per_m2: f64,
}

impl Add for AnnulusDrag {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            pull_N_per_m: self.pull_N_per_m + other.pull_N_per_m,
            drag_Pa_s: self.drag_Pa_s + other.drag_Pa_s,
            spin_drag_N_s: self.spin_drag_N_s + other.spin_drag_N_s,
            gradient_Pa_per_m: self.gradient_Pa_per_m + other.gradient_Pa_per_m,
            surge_Pa_s_per_m2: self.surge_Pa_s_per_m2 + other.surge_Pa_s_per_m2,
        }
    }
}

impl Mul<f64> for AnnulusDrag {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self {
            pull_N_per_m: self.pull_N_per_m * factor,
            drag_Pa_s: self.drag_Pa_s * factor,
            spin_drag_N_s: self.spin_drag_N_s * factor,
            gradient_Pa_per_m: self.gradient_Pa_per_m * factor,
            surge_Pa_s_per_m2: self.surge_Pa_s_per_m2 * factor,
        }
    }
}

impl AnnulusDrag {
    /// Force along the hole at a velocity of the pipe, N/m, positive towards the bit.
    pub fn axial_N_per_m(&self, velocity_m_per_s: f64) -> f64 {
        self.pull_N_per_m - self.drag_Pa_s * velocity_m_per_s
    }

    /// Torque about the axis at a spin, N·m/m, against the spin.
    pub fn torque_N(&self, spin_rad_per_s: f64) -> f64 {
        -self.spin_drag_N_s * spin_rad_per_s
    }
}

impl Annulus {
    /// The gap between a pipe and a hole of these diameters, m. A pipe that fills more than nine
    /// tenths of its hole counts as one that fills nine tenths.
    pub fn new(pipe_od_m: f64, hole_diameter_m: f64) -> Self {
        let hole_m = 0.5 * hole_diameter_m;
        Self { pipe_m: (0.5 * pipe_od_m).min(FULLEST * hole_m), hole_m }
    }

    /// Diameters of the pipe, as far as it counts, and of the hole, m.
    pub(super) fn diameters_m(&self) -> [f64; 2] {
        [2.0 * self.pipe_m, 2.0 * self.hole_m]
    }

    /// Mean speed of mud that passes at a flow rate, m/s.
    pub fn mean_m_per_s(&self, flow_m3_per_s: f64) -> f64 {
        flow_m3_per_s / (PI * (self.hole_m * self.hole_m - self.pipe_m * self.pipe_m))
    }

    /// Computes the effect of `mud` on the pipe; none if it has no rheology.
    ///
    /// The forces are right at `motion`; how they change with the velocity along the hole is their
    /// slope there (in turbulent flow, the laminar slope times the same factor).
    pub fn drag(&self, mud: &Mud, motion: &Motion) -> AnnulusDrag {
        let Some(rheology) = mud.rheology else {
            return AnnulusDrag::default();
        };
        let laminar = match rheology {
            Rheology::Newtonian { viscosity_Pa_s } => self.newtonian(viscosity_Pa_s, motion),
            _ => self.laminar(&rheology, &self.sheared(motion)),
        };
        let (along, around) = self.mixing(mud, &rheology, motion, &laminar);
        AnnulusDrag {
            pull_N_per_m: along * laminar.pull_N_per_m,
            drag_Pa_s: along * laminar.drag_Pa_s,
            spin_drag_N_s: around * laminar.spin_drag_N_s,
            gradient_Pa_per_m: along * laminar.gradient_Pa_per_m,
            surge_Pa_s_per_m2: along * laminar.surge_Pa_s_per_m2,
        }
    }

    /// Laminar flow of a Newtonian mud, in closed form.
    fn newtonian(&self, viscosity_Pa_s: f64, motion: &Motion) -> AnnulusDrag {
        let (a2, r2) = (self.pipe_m * self.pipe_m, self.hole_m * self.hole_m);
        let (sum, gap) = (r2 + a2, r2 - a2);
        let log = 0.5 * libm::log(r2 / a2);
        let narrow = sum * log - gap;
        let pull_N_per_m = -4.0 * viscosity_Pa_s * motion.flow_m3_per_s / narrow;
        let drag_Pa_s = 2.0 * PI * viscosity_Pa_s * sum / narrow;
        let b = (pull_N_per_m - drag_Pa_s * motion.axial_m_per_s) / (2.0 * PI);
        AnnulusDrag {
            pull_N_per_m,
            drag_Pa_s,
            spin_drag_N_s: 4.0 * PI * viscosity_Pa_s * a2 * r2 / gap,
            gradient_Pa_per_m: -4.0 * (viscosity_Pa_s * motion.axial_m_per_s + b * log) / gap,
            surge_Pa_s_per_m2: -4.0 * (viscosity_Pa_s - drag_Pa_s * log / (2.0 * PI)) / gap,
        }
    }

    /// The motion, or one that shears the mud a little about the axis where nothing else does.
    fn sheared(&self, motion: &Motion) -> Motion {
        let through = self.through_m_per_s(motion);
        let lacking = (SLOWEST_M_PER_S.powi(2) - through * through - motion.axial_m_per_s.powi(2))
            .max(0.0)
            .sqrt()
            / self.pipe_m;
        Motion {
            spin_rad_per_s: motion
                .spin_rad_per_s
                .abs()
                .max(lacking)
                .copysign(motion.spin_rad_per_s),
            ..*motion
        }
    }

    /// Mean speed of the mud up the hole against the mean of its two walls, m/s.
    fn through_m_per_s(&self, motion: &Motion) -> f64 {
        let (a2, r2) = (self.pipe_m * self.pipe_m, self.hole_m * self.hole_m);
        self.mean_m_per_s(motion.flow_m3_per_s) + motion.axial_m_per_s * 0.5 * (r2 + a2) / (r2 - a2)
    }

    /// Power that the motion puts into the mud per metre, W/m.
    fn power_W_per_m(drag: &AnnulusDrag, motion: &Motion) -> f64 {
        drag.gradient_Pa_per_m * motion.flow_m3_per_s
            - drag.axial_N_per_m(motion.axial_m_per_s) * motion.axial_m_per_s
            + drag.spin_drag_N_s * motion.spin_rad_per_s.powi(2)
    }

    /// Factors by which vortices raise the forces along the hole and the torque. Both Reynolds
    /// numbers are taken at the viscosity of a Newtonian mud that would dissipate the same power:
    /// for flow along the hole alone that is Metzner and Reed's. The turbulence of the flow raises
    /// the torque with the pressure (Reynolds' analogy) where rotation does not raise it more; the
    /// pressure of Taylor's vortices is left out.
    fn mixing(
        &self,
        mud: &Mud,
        rheology: &Rheology,
        motion: &Motion,
        laminar: &AnnulusDrag,
    ) -> (f64, f64) {
        let thin = Self::power_W_per_m(&self.newtonian(1.0, motion), motion);
        let viscosity = Self::power_W_per_m(laminar, motion) / thin;
        // Nothing moves, or only below the resolution of the numbers.
        if !(viscosity.is_finite() && viscosity > 0.0) {
            return (1.0, 1.0);
        }
        let gap = self.hole_m - self.pipe_m;
        let per_speed = mud.density_kg_per_m3 * gap / viscosity;
        let reynolds = 2.0 * per_speed * self.through_m_per_s(motion).abs();
        let along = turbulence::through_flow(reynolds, rheology.flow_index(), 24.0);
        let reynolds = per_speed * self.pipe_m * motion.spin_rad_per_s.abs();
        let around = turbulence::rotation(reynolds, self.pipe_m / self.hole_m);
        (along, along.max(around))
    }

    /// Laminar flow of any mud.
    fn laminar(&self, rheology: &Rheology, motion: &Motion) -> AnnulusDrag {
        let hole = self.hole_m;
        let target = Vector3::new(
            motion.flow_m3_per_s / (2.0 * PI * hole.powi(3)),
            -motion.axial_m_per_s / hole,
            -motion.spin_rad_per_s,
        );
        // The unknowns are g = G R, b = B/R and c = C/R²: stresses.
        let mut x = self.guess(rheology, motion);
        let mut at = self.strain(rheology, &x);
        for _ in 0..ITERATIONS {
            let missing = target - at.rates;
            let Some(step) = at.slopes.cholesky().map(|l| l.solve(&missing)) else {
                break;
            };
            // On a convex function the slope along the step must not come out steeper than it went
            // in.
            let (mut part, downhill) = (1.0, missing.dot(&step));
            let mut next = self.strain(rheology, &(x + step));
            while (next.rates - target).dot(&step) > 0.5 * downhill && part > 1e-3 {
                part *= 0.5;
                next = self.strain(rheology, &(x + part * step));
            }
            x += part * step;
            at = next;
            if (part * step).norm() <= 1e-10 * x.norm() {
                break;
            }
        }
        let inverse = at.slopes.try_inverse().unwrap_or_else(Matrix3::zeros);
        let axial = 2.0 * PI * hole * x.y;
        let drag_Pa_s = 2.0 * PI * inverse.m22;
        let spin = motion.spin_rad_per_s;
        AnnulusDrag {
            pull_N_per_m: axial + drag_Pa_s * motion.axial_m_per_s,
            drag_Pa_s,
            // Torque over spin; its limit where there is hardly any.
            spin_drag_N_s: 2.0
                * PI
                * hole
                * hole
                * if spin.abs() > 1e-6 { -x.z / spin } else { inverse.m33 },
            gradient_Pa_per_m: x.x / hole,
            surge_Pa_s_per_m2: -inverse.m12 / (hole * hole),
        }
    }

    /// The Newtonian solution at about the right viscosity.
    fn guess(&self, rheology: &Rheology, motion: &Motion) -> Vector3<f64> {
        let gap = self.hole_m - self.pipe_m;
        let around = self.pipe_m * motion.spin_rad_per_s;
        let along = 3.0 * self.through_m_per_s(motion);
        let rate = (libm::hypot(around, along) + motion.axial_m_per_s.abs()) / gap;
        let viscosity = rheology.stress_Pa(rate) / rate;
        let drag = self.newtonian(viscosity, motion);
        let per_round = 1.0 / (2.0 * PI * self.hole_m);
        Vector3::new(
            drag.gradient_Pa_per_m * self.hole_m,
            drag.axial_N_per_m(motion.axial_m_per_s) * per_round,
            drag.torque_N(motion.spin_rad_per_s) * per_round / self.hole_m,
        )
    }

    /// Strain rates of the gap under the stresses.
    fn strain(&self, rheology: &Rheology, x: &Vector3<f64>) -> Strain {
        let inner = self.pipe_m / self.hole_m;
        let layers = Layers::new(x, inner, rheology.knee_Pa());
        let mut strain = Strain { rates: Vector3::zeros(), slopes: Matrix3::zeros() };
        for edges in layers.edges.windows(2) {
            let (middle, half) = (0.5 * (edges[1] + edges[0]), 0.5 * (edges[1] - edges[0]));
            if half <= 0.0 {
                continue;
            }
            for (place, weight) in GAUSS.iter() {
                strain.add(rheology, x, middle + half * place, half * weight);
            }
        }
        let s = &mut strain.slopes;
        (s.m21, s.m31, s.m32) = (s.m12, s.m13, s.m23);
        strain
    }
}

/// Radii, over the hole's, between which the integrands are smooth: the pipe, the edges of the plug
/// or the place of the least stress, the hole.
struct Layers {
    edges: [f64; 4],
}

impl Layers {
    fn new(x: &Vector3<f64>, inner: f64, knee_Pa: f64) -> Self {
        // With ρ the square of the radius the square of the stress is g²ρ/4 + gb + b²/ρ + c²/ρ²:
        // convex.
        let (g2, b2, c2) = (0.25 * x.x * x.x, x.y * x.y, x.z * x.z);
        let square = |rho: f64| g2 * rho + x.x * x.y + b2 / rho + c2 / (rho * rho);
        let slope = |rho: f64| g2 - (b2 + 2.0 * c2 / rho) / (rho * rho);
        let (first, last) = (inner * inner, 1.0);
        let least = if slope(first) >= 0.0 {
            first
        } else if slope(last) <= 0.0 {
            last
        } else {
            let (mut low, mut high) = (first, last);
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                if slope(middle) < 0.0 {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            0.5 * (low + high)
        };
        let knee = knee_Pa * knee_Pa;
        // From outside the plug Newton's method converges to its edge without passing it.
        let edge = |from: f64| {
            let mut rho = from;
            for _ in 0..30 {
                let excess = square(rho) - knee;
                if excess <= 1e-13 * knee {
                    break;
                }
                rho -= excess / slope(rho);
            }
            rho
        };
        let edges = if square(least) < knee {
            [first, edge(first), edge(last), last]
        } else {
            [first, least, least, last]
        };
        Self { edges: edges.map(f64::sqrt) }
    }
}

/// The three integrals over the gap and how they change with the stresses.
struct Strain {
    rates: Vector3<f64>,
    slopes: Matrix3<f64>,
}

impl Strain {
    /// Adds a layer of a thickness at a radius, both over the hole's.
    fn add(&mut self, rheology: &Rheology, x: &Vector3<f64>, radius: f64, thickness: f64) {
        let (of_g, of_b, of_c) = (0.5 * radius, 1.0 / radius, 1.0 / (radius * radius));
        let (along, around) = (x.x * of_g + x.y * of_b, x.z * of_c);
        let stress = libm::hypot(along, around).max(1e-12);
        let flow = rheology.flow(stress);
        let area = thickness * radius;
        let rate = area * flow.fluidity;
        self.rates += Vector3::new(rate * along * of_g, rate * along * of_b, rate * around * of_c);
        let (cos, sin) = (along / stress, around / stress);
        let more = area * (flow.slope - flow.fluidity);
        let (zz, zt, tt) = (rate + more * cos * cos, more * cos * sin, rate + more * sin * sin);
        let s = &mut self.slopes;
        s.m11 += zz * of_g * of_g;
        s.m12 += zz * of_g * of_b;
        s.m22 += zz * of_b * of_b;
        s.m13 += zt * of_g * of_c;
        s.m23 += zt * of_b * of_c;
        s.m33 += tt * of_c * of_c;
    }
}

/// Places and weights of Gauss and Legendre's rule on −1 to 1.
static GAUSS: LazyLock<[(f64, f64); POINTS]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let mut x = libm::cos(PI * (i as f64 + 0.75) / (POINTS as f64 + 0.5));
        let mut slope = 0.0;
        for _ in 0..20 {
            let (mut before, mut now) = (1.0, x);
            for k in 2..=POINTS {
                let k = k as f64;
                (before, now) = (now, ((2.0 * k - 1.0) * x * now - (k - 1.0) * before) / k);
            }
            slope = POINTS as f64 * (x * now - before) / (x * x - 1.0);
            x -= now / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
});

#[cfg(test)]
mod tests;
