//! Response of the assembly to a rotating force.

use nalgebra::{Complex, Matrix2, Matrix3, SMatrix, SVector, Vector3};

use super::{
    assembly::Assembly,
    factors::{MOTIONS, Stiffness},
    mode::{Place, farthest},
};
use crate::complex;

type Block = SMatrix<Complex<f64>, MOTIONS, MOTIONS>;
type Entry = SVector<Complex<f64>, MOTIONS>;

/// Rounds that bring the mud's quadratic drag to the speed that it has, and how near.
const ROUNDS: usize = 20;
const SETTLED: f64 = 1e-3;

/// A force that goes round with the rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Forcing {
    /// The string's eccentric masses: `U Ω²`.
    Imbalance,
    /// A force of this size, N, at a distance from the bit, m, at every speed.
    Force {
        /// Its size, N.
        force_N: f64,
        /// Its distance from the bit, m.
        from_bit_m: f64,
    },
}

/// Response of the assembly at a rotary speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Rotary speed, rad/s.
    pub rotary_rad_per_s: f64,
    /// Farthest that a node goes across the hole from where it rests, m.
    pub amplitude_m: f64,
    /// Place of the widest motion.
    pub widest: Place,
    /// Largest bending stress that this adds, Pa.
    pub bending_stress_Pa: f64,
    /// Place of the greatest bending.
    pub most_bent: Place,
}

/// Damping of the rod between a node and the next: in blocks of both, arranged like the stiffness.
struct RodDamping {
    diagonal: Vec<Stiffness>,
    upper: Vec<Stiffness>,
}

impl Assembly<'_> {
    /// The response to a force that rotates with the string, with the damping of rod, wall and mud,
    /// at rotary speeds, rad/s, each above zero.
    ///
    /// The mud's quadratic drag is that of the speed which each node has; the wall stays where it
    /// is touched, and as stiff: answers of a clearance or more are those of a string that would
    /// hit the wall.
    pub fn respond(&self, forcing: Forcing, rotary_rad_per_s: &[f64]) -> Vec<Answer> {
        let damping = self.rod_damping();
        let mut speeds_m_per_s = vec![0.0; self.chain.nodes()];
        let answer = |speed: &f64| self.answer(forcing, *speed, &damping, &mut speeds_m_per_s);
        rotary_rad_per_s.iter().map(answer).collect()
    }

    /// Middle of the longest unsupported span of the assembly, m from the bit.
    pub fn middle_of_longest_span_m(&self) -> f64 {
        let rest = &self.motions.rest;
        let last = self.motions.nodes() - 1;
        let held = (self.top_node()..=last).filter(|node| {
            *node == last || *node == self.top_node() || self.motions.touches(*node)
        });
        let held: Vec<f64> = held.map(|node| rest.mesh.nodes[node].from_bit_m).collect();
        let longest = held.windows(2).max_by(|a, b| (a[0] - a[1]).total_cmp(&(b[0] - b[1])));
        longest.map_or(0.0, |ends| 0.5 * (ends[0] + ends[1]))
    }

    fn answer(
        &self,
        forcing: Forcing,
        rotary_rad_per_s: f64,
        damping: &RodDamping,
        speeds_m_per_s: &mut [f64],
    ) -> Answer {
        let force = self.force(forcing, rotary_rad_per_s);
        let mut motion = Vec::new();
        for _ in 0..ROUNDS {
            motion = self.solve(&force, rotary_rad_per_s, damping, speeds_m_per_s);
            let (mut change, mut most) = (0.0_f64, 0.0_f64);
            for (node, speed) in speeds_m_per_s.iter_mut().enumerate() {
                let [x, y] = [motion[node * MOTIONS], motion[node * MOTIONS + 1]];
                // Of a circle it is the speed, of a line its mean square root.
                let now = rotary_rad_per_s * (0.5 * (x.norm_sqr() + y.norm_sqr())).sqrt();
                change = change.max((now - *speed).abs());
                most = most.max(now);
                // Halfway, so that drag and speed do not swing about each other.
                *speed = 0.5 * (*speed + now);
            }
            if change <= SETTLED * most {
                break;
            }
        }
        let across = |node: usize| farthest(motion[node * MOTIONS], motion[node * MOTIONS + 1]);
        let own = self.top_node() - self.first..self.chain.nodes();
        let widest = own.max_by(|a, b| across(*a).total_cmp(&across(*b))).unwrap_or(0);
        let from = (self.top_node() - self.first) * MOTIONS;
        let (element, bending_stress_Pa) = self.motions.most_bent(self.top_node(), &motion[from..]);
        let node = self.first + widest;
        let element_at = node.min(self.motions.rest.elements.len() - 1);
        Answer {
            rotary_rad_per_s,
            amplitude_m: across(widest),
            widest: Place {
                md_m: self.motions.md_m(node),
                from_bit_m: self.motions.rest.mesh.nodes[node].from_bit_m,
                component: self.motions.bodies[element_at].0.clone(),
            },
            bending_stress_Pa,
            most_bent: self.motions.place(element),
        }
    }

    /// Of `Re(F exp(iΩt))` the force on each node.
    fn force(&self, forcing: Forcing, rotary_rad_per_s: f64) -> Vec<Entry> {
        let mut force = vec![Entry::zeros(); self.chain.nodes()];
        // Towards the angle, and a quarter turn further a quarter turn later.
        let round = |size: f64, angle_rad: f64| {
            let x = complex::polar(size, angle_rad);
            [x, x * Complex::new(0.0, -1.0)]
        };
        let mut put = |node: usize, complex: [Complex<f64>; 2]| {
            for (k, part) in complex.into_iter().enumerate() {
                if self.chain.mass[node][k] > 0.0 {
                    force[node][k] += part;
                }
            }
        };
        match forcing {
            Forcing::Imbalance => {
                let levers = &self.motions.levers_kg_m[self.first..];
                for (node, [high, right]) in levers.iter().enumerate() {
                    let angle_rad = self.motions.rest.high_side_rad + libm::atan2(*right, *high);
                    put(
                        node,
                        round(libm::hypot(*high, *right) * rotary_rad_per_s.powi(2), angle_rad),
                    );
                }
            }
            Forcing::Force { force_N, from_bit_m } => {
                let node = self.motions.rest.mesh.nearest_node(from_bit_m).max(self.first);
                put(node - self.first, round(force_N, self.motions.rest.high_side_rad));
            }
        }
        force
    }

    /// `K + iΩC − Ω²M + iΩ·ΩG` solved for a force, block by block.
    fn solve(
        &self,
        force: &[Entry],
        rotary_rad_per_s: f64,
        damping: &RodDamping,
        speeds_m_per_s: &[f64],
    ) -> Vec<Complex<f64>> {
        let omega = rotary_rad_per_s;
        let chain = &self.chain;
        let nodes = chain.nodes();
        let complex = |stiff: &Stiffness, damp: &Stiffness| {
            stiff.zip_map(damp, |k, c| Complex::new(k, omega * c))
        };
        let mut coupling: Vec<Block> = Vec::with_capacity(nodes);
        let mut solved: Vec<Entry> = Vec::with_capacity(nodes);
        for node in 0..nodes {
            let mut block = complex(&chain.diagonal[node], &damping.diagonal[node]);
            for k in 0..MOTIONS {
                let mass = chain.mass[node][k];
                let by_mass = self.motions.dynamics.damping.mass_per_s * mass;
                block[(k, k)] += Complex::new(-omega * omega * mass, omega * by_mass);
            }
            let precession = omega * omega * chain.polar_kg_m2[node];
            block[(3, 4)].im += precession;
            block[(4, 3)].im -= precession;
            if chain.mass[node][0] > 0.0 {
                let of_wall = self.across_N_s_per_m(node, speeds_m_per_s[node]);
                for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    block[(row, column)].im += omega * of_wall[(row, column)];
                }
            }
            let mut rhs = force[node];
            if node > 0 {
                // The pencil of the block to the left is this one's to the right, transposed.
                let left = complex(&chain.upper[node - 1], &damping.upper[node - 1]).transpose();
                block -= left * coupling[node - 1];
                rhs -= left * solved[node - 1];
            }
            let factors = block.lu();
            if node + 1 < nodes {
                let right = complex(&chain.upper[node], &damping.upper[node]);
                coupling.push(factors.solve(&right).unwrap_or_else(Block::zeros));
            }
            solved.push(factors.solve(&rhs).unwrap_or_else(Entry::zeros));
        }
        for node in (0..nodes - 1).rev() {
            let below = solved[node + 1];
            solved[node] -= coupling[node] * below;
        }
        solved.iter().flat_map(|entry| entry.iter().copied()).collect()
    }

    /// Lateral damping of a node by mud and wall, N·s/m.
    fn across_N_s_per_m(&self, node: usize, speed_m_per_s: f64) -> Matrix2<f64> {
        let at = &self.motions.rest.nodes[self.first + node];
        let [linear, quadratic] = self.motions.drag[self.first + node];
        let radius_m = at.offset_m.norm().max(f64::MIN_POSITIVE);
        let radial = at.offset_m / radius_m;
        let wall = at.normal_N * self.motions.dynamics.contact_law.dissipation_s_per_m();
        Matrix2::identity() * (linear + quadratic * speed_m_per_s)
            + radial * radial.transpose() * wall
    }

    /// Proportional to stiffness: on the chord's length, the twist and the bend, as the dynamics
    /// have it.
    fn rod_damping(&self) -> RodDamping {
        let beta = self.motions.dynamics.damping.stiffness_s;
        let nodes = self.chain.nodes();
        let mut damping = RodDamping {
            diagonal: vec![Stiffness::zeros(); nodes],
            upper: vec![Stiffness::zeros(); nodes - 1],
        };
        for index in 0..nodes - 1 {
            let element = &self.motions.rest.elements[self.first + index];
            let (k, pose) = (&element.stiffness, &element.pose);
            let along = Vector3::from(pose.anchor_chord).normalize();
            let about = (Vector3::from(pose.d1) + Vector3::from(pose.d2)).normalize();
            let [along, about] = [along, about].map(|unit| unit * unit.transpose());
            let stretch = along * (beta * k.axial);
            let turn =
                (Matrix3::identity() - about) * (beta * k.bending) + about * (beta * k.twist);
            let ends = [index, index + 1];
            let frames = ends.map(|node| {
                let at = &self.motions.rest.nodes[self.first + node];
                [at.axes, at.frame].map(|axes| Matrix3::from_columns(&axes))
            });
            let block = |row: usize, column: usize| {
                let sign = if row == column { 1.0 } else { -1.0 };
                let part = |frame: usize, by: &Matrix3<f64>| {
                    frames[row][frame].tr_mul(&(by * frames[column][frame])) * sign
                };
                let mut block = Stiffness::zeros();
                block.fixed_view_mut::<3, 3>(0, 0).copy_from(&part(0, &stretch));
                block.fixed_view_mut::<3, 3>(3, 3).copy_from(&part(1, &turn));
                block
            };
            damping.diagonal[index] += block(0, 0);
            damping.diagonal[index + 1] += block(1, 1);
            damping.upper[index] = block(0, 1);
        }
        // Fixed motions are zero.
        for node in 0..nodes {
            for k in (0..MOTIONS).filter(|k| self.chain.mass[node][*k] == 0.0) {
                damping.diagonal[node].row_mut(k).fill(0.0);
                damping.diagonal[node].column_mut(k).fill(0.0);
                if let Some(right) = damping.upper.get_mut(node) {
                    right.row_mut(k).fill(0.0);
                }
                if node > 0 {
                    damping.upper[node - 1].column_mut(k).fill(0.0);
                }
            }
        }
        damping
    }
}
