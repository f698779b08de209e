//! One motion of the chain by itself, as of a string that does nothing else.

use super::chain::Chain;

/// Bisections that bring a root to the last digit.
const BISECTIONS: usize = 200;

/// Steps of inverse iteration.
const ITERATIONS: usize = 3;

/// A tridiagonal pencil `K − λ M`.
pub(super) struct Line {
    diagonal: Vec<f64>,
    upper: Vec<f64>,
    mass: Vec<f64>,
}

/// A mode of it.
pub(super) struct LineMode {
    /// Square of its angular frequency, rad²/s².
    pub(super) lambda: f64,
    /// Displacement of each node.
    pub(super) shape: Vec<f64>,
}

impl Line {
    /// Of one motion of the chain's nodes.
    pub(super) fn of(chain: &Chain, motion: usize) -> Self {
        Self {
            diagonal: chain.diagonal.iter().map(|k| k[(motion, motion)]).collect(),
            upper: chain.upper.iter().map(|k| k[(motion, motion)]).collect(),
            mass: chain.mass.iter().map(|m| m[motion]).collect(),
        }
    }

    /// Nodes that move.
    pub(super) fn freedoms(&self) -> usize {
        self.mass.iter().filter(|mass| **mass > 0.0).count()
    }

    /// Modes below a value, by Sturm's count.
    fn below(&self, lambda: f64) -> usize {
        let (mut count, mut pivot) = (0, 1.0);
        for (node, diagonal) in self.diagonal.iter().enumerate() {
            let above = if node > 0 { self.upper[node - 1].powi(2) / pivot } else { 0.0 };
            pivot = diagonal - lambda * self.mass[node] - above;
            if pivot == 0.0 {
                pivot = f64::MIN_POSITIVE;
            }
            count += usize::from(pivot < 0.0);
        }
        count
    }

    /// The mode of a number, counted from zero.
    pub(super) fn mode(&self, number: usize) -> LineMode {
        let highest = |(k, m): (&f64, &f64)| if *m > 0.0 { 4.0 * k.abs() / m } else { 0.0 };
        let mut high = self.diagonal.iter().zip(&self.mass).map(highest).fold(0.0, f64::max);
        let mut low = -high;
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if self.below(middle) > number {
                high = middle;
            } else {
                low = middle;
            }
        }
        let lambda = 0.5 * (low + high);
        let moves = |mass: &f64| if *mass > 0.0 { 1.0 } else { 0.0 };
        // Not orthogonal to any mode: it leans to one side.
        let mut shape: Vec<f64> = self
            .mass
            .iter()
            .enumerate()
            .map(|(node, mass)| moves(mass) * (1.0 + libm::sin(node as f64)))
            .collect();
        for _ in 0..ITERATIONS {
            for (x, m) in shape.iter_mut().zip(&self.mass) {
                *x *= m;
            }
            self.solve(lambda, &mut shape);
            let most = shape.iter().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
            shape.iter_mut().for_each(|x| *x /= most);
        }
        LineMode { lambda, shape }
    }

    fn solve(&self, lambda: f64, rhs: &mut [f64]) {
        let nodes = rhs.len();
        let mut pivots: Vec<f64> = Vec::with_capacity(nodes);
        for node in 0..nodes {
            let own = self.diagonal[node] - lambda * self.mass[node];
            let mut pivot = own;
            if let Some(above) = node.checked_sub(1) {
                let part = self.upper[above] / pivots[above];
                pivot -= part * self.upper[above];
                rhs[node] -= part * rhs[above];
            }
            // At a root the last pivot is zero but for rounding.
            let least = 1e-14 * own.abs().max(self.diagonal[node].abs());
            if pivot.abs() < least {
                pivot = least.copysign(pivot);
            }
            pivots.push(pivot);
        }
        for node in (0..nodes).rev() {
            if node + 1 < nodes {
                rhs[node] -= self.upper[node] * rhs[node + 1];
            }
            rhs[node] /= pivots[node];
        }
    }
}
