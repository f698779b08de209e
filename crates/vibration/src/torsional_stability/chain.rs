//! A chain of lumped inertia between springs, answering at complex frequencies.

use nalgebra::Complex;

/// Frequencies that are answered at once, side by side.
const LANES: usize = 8;

/// Nodes after which a determinant is brought near one again.
const RENORMALISED: usize = 32;

/// Nodes with inertia, drag and springs between, from the top to the bit: torsion or axial motion.
///
/// A motion `e^{st}` costs node `i` the torque `s² J_i + s c_i`, spring `i` below it the torque
/// `k_i (1 + βs)` per difference of its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct LumpedChain {
    /// `J_i`: kg·m², or kg.
    pub inertia: Vec<f64>,
    /// `k_i`: N·m/rad, or N/m; one fewer.
    pub stiffness: Vec<f64>,
    /// `c_i`: N·m·s, or N·s/m; negative where friction falls with speed.
    pub drag: Vec<f64>,
    /// Time constant `β` of the stiffness-proportional damping, s.
    pub stiffness_damping_s: f64,
}

/// Boundary condition of the top node: its drive or its support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TopEnd {
    /// It does not give way.
    Held,
    /// A yielding top: its impedance in addition to the top node's own inertia, and the part of the
    /// spring's force to which the top responds in addition.
    Gives { own: Complex<f64>, answered: Complex<f64> },
}

/// Response of the chain at the bit at one complex frequency.
#[derive(Debug, Clone, Copy)]
pub(super) struct Response {
    /// Force at the bit per displacement of it, the bit's own inertia included.
    pub(super) end: Complex<f64>,
    /// Determinant of all nodes above the bit, over the springs; times `e^ln_scale`.
    pub(super) determinant: Complex<f64>,
    pub(super) ln_scale: f64,
    /// Force that reaches the bit, held, of one on the top node.
    pub(super) transfer: Complex<f64>,
}

impl LumpedChain {
    /// The same with more drag at its nodes.
    pub(super) fn with_drag(&self, more: &[f64]) -> Self {
        let drag = self.drag.iter().zip(more).map(|(own, more)| own + more).collect();
        Self { drag, ..self.clone() }
    }

    /// The same with fewer nodes: neighbours are joined as long as a wave takes no longer than
    /// `longest_s` from one node to the next. Springs act in series, and the properties of a
    /// removed node are distributed to its neighbours.
    pub(super) fn merged(&self, longest_s: f64) -> Self {
        let last = self.inertia.len() - 1;
        let mut indices = vec![0];
        let mut travel_s = 0.0;
        for index in 0..last {
            let across_s = self.across_s(index);
            if index > 0 && travel_s + across_s > longest_s {
                indices.push(index);
                travel_s = 0.0;
            }
            travel_s += across_s;
        }
        indices.push(last);
        let mut merged = Self {
            inertia: vec![0.0; indices.len()],
            stiffness: Vec::with_capacity(indices.len() - 1),
            drag: vec![0.0; indices.len()],
            stiffness_damping_s: self.stiffness_damping_s,
        };
        for (above, pair) in indices.windows(2).enumerate() {
            let softness =
                |to: usize| -> f64 { self.stiffness[pair[0]..to].iter().map(|k| 1.0 / k).sum() };
            let whole = softness(pair[1]);
            merged.stiffness.push(1.0 / whole);
            // A node between two kept ones moves with both in proportion to its position between
            // them.
            for index in pair[0]..pair[1] {
                let below = softness(index) / whole;
                for (to, part) in [(above, 1.0 - below), (above + 1, below)] {
                    merged.inertia[to] += part * self.inertia[index];
                    merged.drag[to] += part * self.drag[index];
                }
            }
        }
        merged.inertia[indices.len() - 1] += self.inertia[last];
        merged.drag[indices.len() - 1] += self.drag[last];
        merged
    }

    /// Time in which a wave runs along a spring, s.
    fn across_s(&self, index: usize) -> f64 {
        (0.5 * (self.inertia[index] + self.inertia[index + 1]) / self.stiffness[index]).sqrt()
    }

    /// Time in which a wave runs from one end to the other, s.
    pub(super) fn travel_s(&self) -> f64 {
        (0..self.stiffness.len()).map(|index| self.across_s(index)).sum()
    }

    /// Response at each frequency with the boundary condition `top` there, and on request the
    /// transfer of a force on the top node to the bit.
    pub(super) fn responses<const TRANSFERS: bool>(
        &self,
        frequencies: &[Complex<f64>],
        top: impl Fn(Complex<f64>) -> TopEnd,
    ) -> Vec<Response> {
        let mut found = Vec::with_capacity(frequencies.len() + LANES);
        for some in frequencies.chunks(LANES) {
            let ends: Vec<TopEnd> = some.iter().map(|s| top(*s)).collect();
            found.extend_from_slice(&self.respond::<TRANSFERS>(some, &ends)[..some.len()]);
        }
        found
    }

    /// Elimination from the top down: `p_i = m_i + k_i`, and the part above the next node
    /// contributes `k_i m_i/p_i` to it.
    fn respond<const TRANSFERS: bool>(
        &self,
        some: &[Complex<f64>],
        ends: &[TopEnd],
    ) -> [Response; LANES] {
        let mut sweep = Sweep::new(some, ends, self);
        let last = self.inertia.len() - 1;
        for index in 1..last {
            let spring = self.stiffness[index];
            sweep.pass::<TRANSFERS>(self.inertia[index], self.drag[index], spring);
            if index % RENORMALISED == 0 {
                sweep.normalise();
            }
        }
        sweep.end(self.inertia[last], self.drag[last])
    }
}

/// Numbers of the frequencies that are answered at once.
type Row = [f64; LANES];

/// Elimination on its way down the chain: real and imaginary parts.
struct Sweep {
    s: [Row; 2],
    square: [Row; 2],
    /// `1 + βs`.
    damped: [Row; 2],
    /// Contribution of everything above to the next node.
    above: [Row; 2],
    determinant: [Row; 2],
    transfer: [Row; 2],
    ln_scale: Row,
}

impl Sweep {
    /// Past the top node. The last frequency fills the lanes that are left.
    fn new(some: &[Complex<f64>], ends: &[TopEnd], chain: &LumpedChain) -> Self {
        let mut sweep = Self {
            s: [[0.0; LANES]; 2],
            square: [[0.0; LANES]; 2],
            damped: [[0.0; LANES]; 2],
            above: [[0.0; LANES]; 2],
            determinant: [[0.0; LANES]; 2],
            transfer: [[0.0; LANES]; 2],
            ln_scale: [0.0; LANES],
        };
        let one = Complex::new(1.0, 0.0);
        for lane in 0..LANES {
            let at = lane.min(some.len() - 1);
            let s = some[at];
            let damped = s * chain.stiffness_damping_s + 1.0;
            let spring = damped * chain.stiffness[0];
            let (above, determinant, transfer) = match ends[at] {
                TopEnd::Held => (spring, one, one),
                TopEnd::Gives { own, answered } => {
                    let m = s * s * chain.inertia[0] + s * chain.drag[0] + own;
                    let p = m + spring + spring * answered;
                    (spring * m / p, p / chain.stiffness[0], spring / p)
                }
            };
            for (row, value) in [
                (&mut sweep.s, s),
                (&mut sweep.square, s * s),
                (&mut sweep.damped, damped),
                (&mut sweep.above, above),
                (&mut sweep.determinant, determinant),
                (&mut sweep.transfer, transfer),
            ] {
                row[0][lane] = value.re;
                row[1][lane] = value.im;
            }
        }
        sweep
    }

    /// Past a node and the spring below it.
    #[inline(always)]
    fn pass<const TRANSFERS: bool>(&mut self, inertia: f64, drag: f64, stiffness: f64) {
        let softness = 1.0 / stiffness;
        for l in 0..LANES {
            let spring = [stiffness * self.damped[0][l], stiffness * self.damped[1][l]];
            let m = [
                inertia * self.square[0][l] + drag * self.s[0][l] + self.above[0][l],
                inertia * self.square[1][l] + drag * self.s[1][l] + self.above[1][l],
            ];
            let p = [m[0] + spring[0], m[1] + spring[1]];
            let inverse = 1.0 / (p[0] * p[0] + p[1] * p[1]);
            // k/p.
            let part = [
                (spring[0] * p[0] + spring[1] * p[1]) * inverse,
                (spring[1] * p[0] - spring[0] * p[1]) * inverse,
            ];
            self.above[0][l] = part[0] * m[0] - part[1] * m[1];
            self.above[1][l] = part[0] * m[1] + part[1] * m[0];
            if TRANSFERS {
                let t = [self.transfer[0][l], self.transfer[1][l]];
                self.transfer[0][l] = t[0] * part[0] - t[1] * part[1];
                self.transfer[1][l] = t[0] * part[1] + t[1] * part[0];
            }
            let d = [self.determinant[0][l] * softness, self.determinant[1][l] * softness];
            self.determinant[0][l] = d[0] * p[0] - d[1] * p[1];
            self.determinant[1][l] = d[0] * p[1] + d[1] * p[0];
        }
    }

    /// Brings the determinants near one.
    fn normalise(&mut self) {
        for lane in 0..LANES {
            let [re, im] = [self.determinant[0][lane], self.determinant[1][lane]];
            let size = re.abs().max(im.abs()).max(f64::MIN_POSITIVE);
            self.determinant[0][lane] /= size;
            self.determinant[1][lane] /= size;
            self.ln_scale[lane] += libm::log(size);
        }
    }

    /// At the bit.
    fn end(&self, inertia: f64, drag: f64) -> [Response; LANES] {
        let value = |row: &[Row; 2], lane: usize| Complex::new(row[0][lane], row[1][lane]);
        std::array::from_fn(|lane| Response {
            end: value(&self.square, lane) * inertia
                + value(&self.s, lane) * drag
                + value(&self.above, lane),
            determinant: value(&self.determinant, lane),
            ln_scale: self.ln_scale[lane],
            transfer: value(&self.transfer, lane),
        })
    }
}
