//! A chain of elements in a plane, brought to equilibrium by Newton's method.
//!
//! The reactions are those of the engine; the tangent is their finite difference. It only steers
//! the iteration: the result is the state in which the forces balance.

use nalgebra::{DMatrix, DVector, Vector3};
use wholestring::rod::{
    element::{Pose, Stiffness, react},
    section::Section,
    vector::Vector,
};

/// A section with the stiffness given, N and N·m².
pub fn section(axial: f64, bending: f64, shear: f64) -> Section {
    Section {
        axial_stiffness_N: axial,
        shear_stiffness_N: shear,
        bending_stiffness_N_m2: bending,
        torsional_stiffness_N_m2: 1.0,
        steel_kg_per_m: 1.0,
        steel_m2: 1e-3,
        bore_m2: 0.0,
        polar_inertia_kg_m: 1.0,
        od_m: 0.1,
        pressure_strain_per_Pa: 0.0,
        thermal_strain_per_K: 0.0,
    }
}

/// An element at rest on a chord between its anchors, without twist.
pub fn at_rest(chord: Vector3<f64>, length_m: f64, d: [Vector3<f64>; 2]) -> Pose<f64> {
    Pose {
        anchor_chord: chord.into(),
        anchor_excess: chord.norm_squared() - length_m * length_m,
        displacement: Vector::zero(),
        velocity: Vector::zero(),
        d1: d[0].into(),
        d2: d[1].into(),
        w1: Vector::zero(),
        w2: Vector::zero(),
        spin: 0.0,
        twist: 0.0,
    }
}

/// Degrees of freedom of a node: across, along, and the turn of its director from "along" to
/// "across".
pub const FREE: usize = 3;

/// A straight chain, and where it has gone.
pub struct Plane {
    elements: Vec<Stiffness<f64>>,
    /// Across, along and turn of each node.
    pub moved: DVector<f64>,
    /// Force and moment on each node.
    pub load: DVector<f64>,
    fixed: Vec<bool>,
}

impl Plane {
    /// `parts` elements over `length`.
    pub fn new(section: &Section, length: f64, parts: usize) -> Self {
        let size = FREE * (parts + 1);
        Self {
            elements: vec![Stiffness::new(section, length / parts as f64); parts],
            moved: DVector::zeros(size),
            load: DVector::zeros(size),
            fixed: vec![false; size],
        }
    }

    /// Fixes motions of a node, by their place in 0..[`FREE`].
    pub fn fix(&mut self, node: usize, motions: &[usize]) {
        for motion in motions {
            self.fixed[FREE * node + motion] = true;
        }
    }

    /// Across, along and turn of a node.
    pub fn at(&self, node: usize) -> [f64; FREE] {
        std::array::from_fn(|i| self.moved[FREE * node + i])
    }

    fn reaction(k: &Stiffness<f64>, q: &[f64; 2 * FREE]) -> [f64; 2 * FREE] {
        let d = [q[2], q[5]].map(|turn| Vector3::new(turn.sin(), 0.0, turn.cos()));
        let pose = Pose {
            displacement: Vector(q[3] - q[0], 0.0, q[4] - q[1]),
            ..at_rest(Vector3::new(0.0, 0.0, k.length), k.length, d)
        };
        let r = react(k, &pose, 0.0, 0.0);
        // A turn from z to x is positive about y.
        [-r.force.0, -r.force.2, r.moment1(pose.d1).1, r.force.0, r.force.2, r.moment2(pose.d2).1]
    }

    fn ends(&self, element: usize) -> [f64; 2 * FREE] {
        std::array::from_fn(|i| self.moved[FREE * element + i])
    }

    /// Load less the rod's reaction, zero where the motion is fixed.
    fn imbalance(&self) -> DVector<f64> {
        let mut sum = self.load.clone();
        for (e, k) in self.elements.iter().enumerate() {
            for (i, f) in Self::reaction(k, &self.ends(e)).iter().enumerate() {
                sum[FREE * e + i] += f;
            }
        }
        for (i, fixed) in self.fixed.iter().enumerate() {
            if *fixed {
                sum[i] = 0.0;
            }
        }
        sum
    }

    /// Stiffness matrix, the fixed motions on its diagonal alone.
    fn tangent(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.moved.len(), self.moved.len());
        for (e, k) in self.elements.iter().enumerate() {
            let ends = self.ends(e);
            for j in 0..2 * FREE {
                // The difference of fourth order: stretch makes forces cubic in a move across.
                let h = 1e-5 * if j % FREE == 2 { 1.0 } else { k.length };
                let at = |h: f64| {
                    let mut q = ends;
                    q[j] += h;
                    Self::reaction(k, &q)
                };
                let [p2, p1, m1, m2] = [2.0, 1.0, -1.0, -2.0].map(|part| at(part * h));
                for i in 0..2 * FREE {
                    matrix[(FREE * e + i, FREE * e + j)] -=
                        (8.0 * (p1[i] - m1[i]) - (p2[i] - m2[i])) / (12.0 * h);
                }
            }
        }
        for (i, fixed) in self.fixed.iter().enumerate() {
            if *fixed {
                matrix.row_mut(i).fill(0.0);
                matrix.column_mut(i).fill(0.0);
                matrix[(i, i)] = 1.0;
            }
        }
        matrix
    }

    /// Smallest eigenvalue of the stiffness matrix of the motions that are free.
    pub fn min_stiffness(&self) -> f64 {
        let tangent = self.tangent();
        let free: Vec<usize> = (0..self.fixed.len()).filter(|i| !self.fixed[*i]).collect();
        let part = DMatrix::from_fn(free.len(), free.len(), |i, j| {
            0.5 * (tangent[(free[i], free[j])] + tangent[(free[j], free[i])])
        });
        part.symmetric_eigenvalues().min()
    }

    /// Brings the load on in `steps`, each to equilibrium.
    pub fn balance(&mut self, steps: usize) {
        let load = self.load.clone();
        for step in 1..=steps {
            self.load = &load * (step as f64 / steps as f64);
            let mut last = f64::INFINITY;
            for _ in 0..60 {
                let change =
                    self.tangent().lu().solve(&self.imbalance()).expect("a stiffness matrix");
                self.moved += &change;
                let size = change.amax();
                // Converged where the steps no longer shrink.
                if size == 0.0 || (size < 1e-9 * self.moved.amax() && size >= 0.5 * last) {
                    break;
                }
                last = size;
            }
            assert!(last < 1e-8 * self.moved.amax().max(1e-12), "no equilibrium: {last:e}");
        }
        self.load = load;
    }
}

/// Order of convergence from errors at `n` and `2n` parts.
pub fn order(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).abs().log2()
}
