//! What is kept of a run while it goes on: sums per node, samples of the scalars.

use super::{
    chain::{Chain, ElementBlock, NodeBlock, Rows, StateBlock},
    outcome::TimeSeries,
};
use crate::rod::lanes::LANES;

type Lane = [f64; LANES];

/// Sums over the window for eight nodes, and for the eight elements below them.
#[derive(Debug, Clone, Copy)]
struct SumBlock {
    /// Tension and torque of the first sample: squares are summed about them, so that a small spread
    /// about a large mean keeps its digits.
    about: [Lane; 2],
    tension: [Lane; 2],
    torque: [Lane; 2],
    normal: [Lane; 2],
    normal_max: Lane,
    touched: Lane,
    signed: Lane,
    /// Contact force towards the high side and towards the right of it, looking down the hole.
    up: Lane,
    right: Lane,
    axial: Lane,
    rub: Lane,
    offset: Lane,
}

const EMPTY: SumBlock = SumBlock {
    about: [[0.0; LANES]; 2],
    tension: [[0.0; LANES]; 2],
    torque: [[0.0; LANES]; 2],
    normal: [[0.0; LANES]; 2],
    normal_max: [0.0; LANES],
    touched: [0.0; LANES],
    signed: [0.0; LANES],
    up: [0.0; LANES],
    right: [0.0; LANES],
    axial: [0.0; LANES],
    rub: [0.0; LANES],
    offset: [0.0; LANES],
};

/// Sums over nodes of one sample.
#[derive(Debug, Clone, Copy, Default)]
pub struct Totals {
    /// Contact force, N.
    pub normal_N: f64,
    /// Axial friction on the wall along the hole, N.
    pub axial_N: f64,
    /// Friction torque, N·m.
    pub torque_N_m: f64,
    /// Deepest penetration, m.
    pub penetration_m: f64,
}

/// Mean and standard deviation of one node.
#[derive(Debug, Clone, Copy)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub std: f64,
}

/// The streaming record.
#[derive(Debug, Clone)]
pub struct Record {
    sums: Vec<SumBlock>,
    samples: u64,
    /// Scalars against time, from time zero.
    pub series: TimeSeries,
    /// Row of the series at which the window begins.
    pub window_row: usize,
    /// Deepest penetration of any sample, m.
    pub max_penetration_m: f64,
}

impl Record {
    /// An empty record of a chain.
    pub fn new(chain: &Chain) -> Self {
        Self {
            sums: vec![EMPTY; chain.node_blocks.len()],
            samples: 0,
            series: TimeSeries::default(),
            window_row: 0,
            max_penetration_m: 0.0,
        }
    }

    /// Begins the window: what was summed before it, in case it never began, goes.
    pub fn open_window(&mut self) {
        self.sums.fill(EMPTY);
        self.samples = 0;
        self.window_row = self.series.time_s.len();
    }

    /// Takes a sample of every node: contact quantities as averages over the `steps` since the last
    /// one, whose sums it clears. `high` holds each node's high side.
    pub fn sample(&mut self, chain: &mut Chain, high: &[[f64; 3]], steps: u64) -> Totals {
        let mut totals = Totals::default();
        let per_step = 1.0 / steps as f64;
        let first = self.samples == 0;
        let rows = self.sums.len();
        for (row, nodes) in chain.node_blocks.iter_mut().enumerate() {
            let elements = &chain.element_blocks[row];
            let high = high.get(row..).unwrap_or_default().iter().step_by(rows);
            let place = Placement::of(nodes, &chain.states[row], high);
            for lane in 0..LANES {
                let normal = nodes.sum_normal.0[lane] * per_step;
                totals.normal_N += normal;
                totals.axial_N += nodes.sum_axial.0[lane] * per_step;
                totals.torque_N_m += nodes.sum_torque.0[lane] * per_step;
                let deep = if nodes.stiffness.0[lane] > 0.0 {
                    place.penetration[lane]
                } else {
                    0.0
                };
                totals.penetration_m = totals.penetration_m.max(deep);
            }
            add(
                &mut self.sums[row],
                nodes,
                elements,
                &place,
                per_step,
                first,
            );
            nodes.clear_sums();
        }
        self.samples += 1;
        self.max_penetration_m = self.max_penetration_m.max(totals.penetration_m);
        totals
    }

    /// The sums of a node, and its lane in them.
    fn at(&self, index: usize) -> (&SumBlock, usize) {
        let rows = self.sums.len();
        (&self.sums[index % rows], index / rows)
    }

    fn mean_of(&self, index: usize, pick: impl Fn(&SumBlock) -> &Lane) -> f64 {
        let (sums, lane) = self.at(index);
        pick(sums)[lane] / self.samples.max(1) as f64
    }

    fn spread_of(
        &self,
        index: usize,
        about: f64,
        pick: impl Fn(&SumBlock) -> &[Lane; 2],
    ) -> Spread {
        let (sums, lane) = self.at(index);
        let [first, second] = pick(sums);
        let n = self.samples.max(1) as f64;
        let (m1, m2) = (first[lane] / n, second[lane] / n);
        Spread {
            mean: about + m1,
            std: (m2 - m1 * m1).max(0.0).sqrt(),
        }
    }

    /// Tension of an element, N.
    pub fn tension(&self, index: usize) -> Spread {
        let (sums, lane) = self.at(index);
        let about = sums.about[0][lane];
        self.spread_of(index, about, |s| &s.tension)
    }
    /// Torque of an element, N·m, in the sign of the chain.
    pub fn torque(&self, index: usize) -> Spread {
        let (sums, lane) = self.at(index);
        let about = sums.about[1][lane];
        self.spread_of(index, about, |s| &s.torque)
    }
    /// Contact force of a node, N.
    pub fn normal(&self, index: usize) -> Spread {
        self.spread_of(index, 0.0, |s| &s.normal)
    }
    /// Largest contact force of a node, N.
    pub fn normal_max(&self, index: usize) -> f64 {
        let (sums, lane) = self.at(index);
        sums.normal_max[lane]
    }
    /// Part of the samples in which a node touched.
    pub fn touched(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.touched)
    }
    /// Mean contact force of a node, N, positive on the high side.
    pub fn signed(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.signed)
    }
    /// Angle of a node's mean contact force from the low side, rad, positive to the right of it looking
    /// down the hole; none if it never touched.
    pub fn climb_rad(&self, index: usize) -> Option<f64> {
        let (up, right) = (
            self.mean_of(index, |s| &s.up),
            self.mean_of(index, |s| &s.right),
        );
        (up != 0.0 || right != 0.0).then(|| right.atan2(-up))
    }
    /// Mean axial friction of a node on the wall, N, along the hole.
    pub fn axial(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.axial)
    }
    /// Mean friction torque of a node, N·m.
    pub fn rub(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.rub)
    }
    /// Mean distance of a node from the hole's axis, m.
    pub fn offset(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.offset)
    }
}

/// Where eight nodes lie in their hole.
struct Placement {
    offset: Lane,
    penetration: Lane,
    /// Cosines of the direction in which it lies with the high side and with the right side.
    up: Lane,
    right: Lane,
}

impl Placement {
    fn of<'a>(
        nodes: &NodeBlock<f64>,
        state: &StateBlock<f64>,
        high: impl Iterator<Item = &'a [f64; 3]>,
    ) -> Self {
        let none = [0.0; LANES];
        let mut place = Self {
            offset: none,
            penetration: none,
            up: none,
            right: none,
        };
        for (lane, high) in high.enumerate() {
            let get = |rows: &Rows<f64>| [0, 1, 2].map(|axis| rows[axis].0[lane]);
            let u = get(&state.u);
            let (t, k) = (get(&nodes.tangent), get(&nodes.curvature));
            let z = u[0] * t[0] + u[1] * t[1] + u[2] * t[2];
            let across: [f64; 3] =
                std::array::from_fn(|axis| u[axis] - z * t[axis] - 0.5 * z * z * k[axis]);
            let square: f64 = across.iter().map(|x| x * x).sum();
            place.offset[lane] = square.sqrt();
            place.penetration[lane] = place.offset[lane] - nodes.clearance.0[lane];
            let h = *high;
            let right = [
                t[1] * h[2] - t[2] * h[1],
                t[2] * h[0] - t[0] * h[2],
                t[0] * h[1] - t[1] * h[0],
            ];
            let per_offset = 1.0 / place.offset[lane].max(f64::MIN_POSITIVE);
            let part = |side: [f64; 3]| -> f64 {
                across.iter().zip(side).map(|(x, s)| x * s).sum::<f64>() * per_offset
            };
            place.up[lane] = part(h);
            place.right[lane] = part(right);
        }
        place
    }
}

fn add(
    sums: &mut SumBlock,
    nodes: &NodeBlock<f64>,
    elements: &ElementBlock<f64>,
    place: &Placement,
    per_step: f64,
    first: bool,
) {
    if first {
        sums.about = [elements.tension.0, elements.torque.0];
    }
    for lane in 0..LANES {
        let tension = elements.tension.0[lane] - sums.about[0][lane];
        let torque = elements.torque.0[lane] - sums.about[1][lane];
        let normal = nodes.sum_normal.0[lane] * per_step;
        sums.tension[0][lane] += tension;
        sums.tension[1][lane] += tension * tension;
        sums.torque[0][lane] += torque;
        sums.torque[1][lane] += torque * torque;
        sums.normal[0][lane] += normal;
        sums.normal[1][lane] += normal * normal;
        sums.normal_max[lane] = sums.normal_max[lane].max(normal);
        sums.touched[lane] += f64::from(u8::from(normal > 0.0));
        sums.signed[lane] += if place.up[lane] < 0.0 {
            -normal
        } else {
            normal
        };
        sums.up[lane] += normal * place.up[lane];
        sums.right[lane] += normal * place.right[lane];
        sums.axial[lane] += nodes.sum_axial.0[lane] * per_step;
        sums.rub[lane] += nodes.sum_torque.0[lane] * per_step;
        sums.offset[lane] += place.offset[lane];
    }
}
