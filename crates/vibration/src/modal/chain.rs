//! Small vibrations of the string as a chain of nodes: stiffness and mass.

use nalgebra::{Complex, SVector};

use super::factors::{Block, Factors, MOTIONS, Stiffness};

/// A number for each motion of a node.
pub(super) type Entry = SVector<f64, MOTIONS>;

/// A chain of nodes: `M x'' + Ω G x' + K x = 0`, all blocks but those of `K` between neighbours on
/// the diagonal.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    /// `K` of each node.
    pub(super) diagonal: Vec<Stiffness>,
    /// `K` between a node and the next.
    pub(super) upper: Vec<Stiffness>,
    /// `M`, kg and kg·m²; zero of a motion that is held.
    pub(super) mass: Vec<Entry>,
    /// Moment of inertia about the axis, kg·m²: used in `G`; zero where a node may not tilt.
    pub(super) polar_kg_m2: Vec<f64>,
}

impl Chain {
    /// So many nodes that nothing holds.
    pub(super) fn free(nodes: usize) -> Self {
        Self {
            diagonal: vec![Stiffness::zeros(); nodes],
            upper: vec![Stiffness::zeros(); nodes - 1],
            mass: vec![Entry::zeros(); nodes],
            polar_kg_m2: vec![0.0; nodes],
        }
    }

    pub(super) fn nodes(&self) -> usize {
        self.mass.len()
    }

    /// Keeps a node from some motions.
    pub(super) fn hold(&mut self, node: usize, motions: &[usize]) {
        for &motion in motions {
            self.diagonal[node].row_mut(motion).fill(0.0);
            self.diagonal[node].column_mut(motion).fill(0.0);
            self.diagonal[node][(motion, motion)] = 1.0;
            if let Some(below) = self.upper.get_mut(node) {
                below.row_mut(motion).fill(0.0);
            }
            if node > 0 {
                self.upper[node - 1].column_mut(motion).fill(0.0);
            }
            self.mass[node][motion] = 0.0;
            if motion == 3 || motion == 4 {
                self.polar_kg_m2[node] = 0.0;
            }
        }
    }

    /// The chain from a node down, that node held.
    pub(super) fn below(&self, node: usize) -> Self {
        let mut part = Self {
            diagonal: self.diagonal[node..].to_vec(),
            upper: self.upper[node..].to_vec(),
            mass: self.mass[node..].to_vec(),
            polar_kg_m2: self.polar_kg_m2[node..].to_vec(),
        };
        part.hold(0, &[0, 1, 2, 3, 4, 5]);
        part
    }

    /// Motions that are not held.
    pub(super) fn freedoms(&self) -> usize {
        self.mass.iter().flatten().filter(|mass| **mass > 0.0).count()
    }

    /// `K − λ M`, factorised. Its negative pivots are as many as there are natural frequencies
    /// below `√λ` in a chain that does not rotate.
    pub(super) fn shifted(&self, lambda: f64) -> Factors<f64> {
        let block = |(stiffness, mass): (&Stiffness, &Entry)| {
            Block::from_fn(|row, column| {
                let own = if row == column { lambda * mass[row] } else { 0.0 };
                stiffness[(row, column)] - own
            })
        };
        Factors::new(self.diagonal.iter().zip(&self.mass).map(block), &self.upper)
    }

    /// `K − ω² M + i ω Ω G`, factorised. Its negative pivots are as many as there are natural
    /// frequencies below `ω`.
    pub(super) fn turning(&self, omega: f64, rotary_rad_per_s: f64) -> Factors<Complex<f64>> {
        let square = omega * omega;
        let blocks = (0..self.nodes()).map(|node| {
            let mut block = Block::from_fn(|row, column| {
                let own = if row == column { square * self.mass[node][row] } else { 0.0 };
                Complex::new(self.diagonal[node][(row, column)] - own, 0.0)
            });
            let precession = omega * rotary_rad_per_s * self.polar_kg_m2[node];
            block.0[3][4].im += precession;
            block.0[4][3].im -= precession;
            block
        });
        Factors::new(blocks, &self.upper)
    }

    /// Natural frequencies below one, rad/s, at a rotary speed.
    pub(super) fn count_below(&self, omega: f64, rotary_rad_per_s: f64) -> usize {
        if rotary_rad_per_s == 0.0 {
            return self.shifted(omega * omega).negative;
        }
        self.turning(omega, rotary_rad_per_s).negative
    }

    /// `M^½`, motion by motion.
    pub(super) fn root_mass(&self) -> Vec<f64> {
        self.mass.iter().flatten().map(|mass| mass.sqrt()).collect()
    }
}
