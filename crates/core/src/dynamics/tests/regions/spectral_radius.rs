//! The linear map of a coupled step in one dimension, by itself: no outside eigenvalue.

use nalgebra::{ComplexField, DMatrix};

/// A chain that moves in one dimension, along or about its axis: held at the top, ordinary elements
/// above the border, a buffer of them below, and short ones, all at the limits of their steps.
struct Line {
    stiffness: Vec<f64>,
    /// Inertia of each node but the top.
    inertia: Vec<f64>,
    border: usize,
    parts: usize,
}

const UPPER: usize = 18;
const PIECES: usize = 4;

impl Line {
    /// `impedance` is that of the short elements over that of the ordinary ones, whose stiffness
    /// and inertia are one, and so the limit of their step.
    fn new(buffer: usize, parts: usize, impedance: f64) -> Self {
        let mut elements = vec![(1.0, 1.0); UPPER + 1 + buffer];
        let m = parts as f64;
        elements.extend(vec![(impedance * m, impedance / m); PIECES * parts]);
        let mut inertia = vec![0.0; elements.len()];
        for (i, (_, mass)) in elements.iter().enumerate() {
            inertia[i] += 0.5 * mass;
            if i > 0 {
                inertia[i - 1] += 0.5 * mass;
            }
        }
        let stiffness = elements.iter().map(|(k, _)| *k).collect();
        Self { stiffness, inertia, border: UPPER, parts }
    }

    /// The inertia that the coupling lacks, as the plan adds it.
    fn corrected(mut self, dt: f64) -> Self {
        let m = self.parts as f64;
        self.inertia[self.border] +=
            self.stiffness[self.border] * dt * dt / 12.0 * (1.0 - 1.0 / (m * m));
        self
    }

    /// Kicks the nodes `from..to`, counted without the top, at these places, and moves them.
    fn step(&self, x: &mut [f64], v: &mut [f64], from: usize, to: usize, above: f64, dt: f64) {
        // Element `i` is above node `i`, node `i − 1` at its upper end.
        let n = self.inertia.len();
        let at = |x: &[f64], i: usize| match i {
            0 => 0.0,
            i if i == from => above,
            i => x[i - 1],
        };
        let pulls: Vec<f64> =
            (from..=to.min(n - 1)).map(|i| self.stiffness[i] * (x[i] - at(x, i))).collect();
        for i in from..to {
            let below = pulls.get(i + 1 - from).copied().unwrap_or(0.0);
            v[i] += dt * (below - pulls[i - from]) / self.inertia[i];
        }
        for i in from..to {
            x[i] += dt * v[i];
        }
    }

    /// One step of both regions.
    fn coupled(&self, x: &mut [f64], v: &mut [f64], dt: f64) {
        // Nodes `0..border` here are those of the upper region without its top.
        let (border, n) = (self.border, self.inertia.len());
        let start = x[border - 1];
        self.step(x, v, 0, border, 0.0, dt);
        let own = dt / self.parts as f64;
        for part in 0..self.parts {
            let ghost = start + part as f64 * own * v[border - 1];
            self.step(x, v, border, n, ghost, own);
        }
    }

    /// Spectral radius of the coupled step.
    fn radius(&self, dt: f64) -> f64 {
        let n = self.inertia.len();
        let mut map = DMatrix::<f64>::zeros(2 * n, 2 * n);
        for column in 0..2 * n {
            let (mut x, mut v) = (vec![0.0; n], vec![0.0; n]);
            if column < n {
                x[column] = 1.0;
            } else {
                v[column - n] = 1.0;
            }
            self.coupled(&mut x, &mut v, dt);
            for row in 0..n {
                map[(row, column)] = x[row];
                map[(n + row, column)] = v[row];
            }
        }
        map.complex_eigenvalues().iter().map(|e| e.modulus()).fold(0.0, f64::max)
    }
}

/// Steps that are tried, over the limit.
const PARTS_OF_LIMIT: [f64; 6] = [0.9, 0.92, 0.94, 0.95, 0.97, 0.99];

/// With the buffer that the plan gives it the coupling gains nothing, for any number of steps, up
/// to the limit, for any string below: the spectral radius is one within 1e-9, of which rounding
/// takes 1e-12. Without the buffer bands of steps gain 1e-3 a step, for every number of steps.
#[test]
fn a_buffer_of_three_elements_keeps_the_coupling_stable() {
    for parts in 2..=8 {
        let gain = |buffer: usize, impedance: f64| {
            let excess =
                |dt: f64| Line::new(buffer, parts, impedance).corrected(dt).radius(dt) - 1.0;
            PARTS_OF_LIMIT.map(excess).into_iter().fold(0.0, f64::max)
        };
        for impedance in [1.0, 4.6, 20.0] {
            let gain = gain(3, impedance);
            assert!(gain < 1e-9, "{gain:e} of {parts} steps on {impedance}");
        }
        let bare = gain(0, 1.0).max(gain(0, 4.6));
        assert!(bare > 1e-4, "{bare:e} of {parts} steps without a buffer");
    }
}
