//! Maintenance and queries of the whole chain between steps.
//!
//! Loops over every lane of every row, compiled for each instruction set. A question looks at every
//! number: a loop that ends early is none that looks at eight at once.

use std::ops::Range;

use super::{Chain, NodeBlock, Row, Rows, StateBlock};
use crate::simd::{
    dispatch::{for_each_instruction_set, with_fastest_instruction_set},
    lanes::SINGLES,
    number::{Doubles, Number, Real},
    vector::Vector,
    wide::Pair,
};

impl<R: Real> Chain<R> {
    /// Whether a node has slid further along the hole than `reach_m` from its anchor.
    pub fn slid(&self, reach_m: f64) -> bool {
        with_fastest_instruction_set!(slid(self, R::from_f64(reach_m)))
    }

    /// Computes the fraction of the nodes' velocities that the mud's lateral drag removes in a step
    /// of their region, at their present motion; the step of the uppermost is `dt`. It is a
    /// hundredth in any mud, and remains dissipative at any speed.
    pub fn find_drag(&mut self, dt: f64) {
        with_fastest_instruction_set!(find_drag(self, dt))
    }

    /// Axial velocity, m/s, and spin, rad/s, of each node, from the top down.
    pub fn motions(&self) -> Motions {
        let mut all = Motions::none(0);
        for region in 0..self.regions() {
            let rows = self.rows_of(region);
            let mut motions = Motions::none(R::LANES * rows.len());
            with_fastest_instruction_set!(motions(self, rows, &mut motions));
            let nodes = self.places_in_region(region);
            all.axial_m_per_s.extend_from_slice(&motions.axial_m_per_s[nodes.clone()]);
            all.spin_rad_per_s.extend_from_slice(&motions.spin_rad_per_s[nodes]);
        }
        all
    }

    /// The upper pieces in whose elements the effective tension was more than `min_N` at the last
    /// step.
    pub fn lanes_above_N(&self, min_N: f64) -> usize {
        let above = with_fastest_instruction_set!(above_N(self, R::from_f64(min_N)));
        above[..R::LANES].iter().take_while(|above| **above).count()
    }

    /// Whether every part of every velocity is below one limit, m/s, and every spin below another,
    /// rad/s, and all of them are numbers.
    pub fn slower_than(&self, limit_m_per_s: f64, limit_rad_per_s: f64) -> bool {
        with_fastest_instruction_set!(slower(self, limit_m_per_s, limit_rad_per_s))
    }

    /// Removes the rounding errors of the directors' lengths and of the angular velocities along
    /// them. The step preserves both except for the damping of bending, so once in a hundred steps
    /// is sufficient.
    pub fn renormalise(&mut self) {
        with_fastest_instruction_set!(renormalise(self))
    }

    /// Adds the work that friction has done at each node since the last sample to that node's, from
    /// the top down, J; all of it, J.
    pub fn take_up_wear(&self, each_J: &mut [f64]) -> f64 {
        let rubbed = with_fastest_instruction_set!(rubbed(self));
        let mut all = 0.0;
        for region in 0..self.regions() {
            let (rows, places) = (self.rows_of(region), self.places_in_region(region));
            let each_J = &mut each_J[self.nodes_of(region)];
            let up_to = |end: usize| rubbed.partition_point(|row| *row < end);
            let rubbed = &rubbed[up_to(rows.start)..up_to(rows.end)];
            for lane in 0..R::LANES {
                let first = lane * rows.len();
                // A sum for each lane: none waits for another's.
                let mut of_lane_J = 0.0;
                for row in rubbed {
                    // No node of the region's before the first of its places, and after the last.
                    let node = (first + row - rows.start).wrapping_sub(places.start);
                    if let Some(of_node_J) = each_J.get_mut(node) {
                        let work = self.node_blocks[*row].sum_wear.0[lane].to_f64();
                        *of_node_J += work;
                        of_lane_J += work;
                    }
                }
                all += of_lane_J;
            }
        }
        all
    }

    /// Clears the sums between samples.
    pub fn clear_sums(&mut self) {
        with_fastest_instruction_set!(clear_sums(self))
    }
}

/// Motion of the nodes along the hole and about its axis, from the top down.
#[derive(Debug, Clone)]
pub struct Motions {
    /// Velocity along the hole, m/s.
    pub axial_m_per_s: Vec<f64>,
    /// Spin, rad/s.
    pub spin_rad_per_s: Vec<f64>,
}

impl Motions {
    fn none(nodes: usize) -> Self {
        Self { axial_m_per_s: vec![0.0; nodes], spin_rad_per_s: vec![0.0; nodes] }
    }
}

macro_rules! compiled_for {
    ($set:ident, $number:ident $(, $features:literal)?) => {
        mod $set {
            use super::*;
            type Lanes = Pair<crate::simd::dispatch::$number<f64>>;

            $(#[target_feature(enable = $features)])?
            pub(super) fn slid<R: Real>(chain: &Chain<R>, reach: R) -> bool {
                super::slid(chain, reach)
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn find_drag<R: Real>(chain: &mut Chain<R>, dt: f64) {
                super::find_drag(chain, dt);
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn motions<R: Real>(
                chain: &Chain<R>,
                rows: Range<usize>,
                motions: &mut Motions,
            ) {
                super::motions::<R, Lanes>(chain, rows, motions);
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn above_N<R: Real>(chain: &Chain<R>, least: R) -> [bool; SINGLES] {
                super::above_N(chain, least)
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn rubbed<R: Real>(chain: &Chain<R>) -> Vec<usize> {
                super::rubbed(chain)
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn slower<R: Real>(chain: &Chain<R>, speed: f64, spin: f64) -> bool {
                super::slower(chain, speed, spin)
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn renormalise<R: Real>(chain: &mut Chain<R>) {
                super::renormalise::<R, Lanes>(chain);
            }

            $(#[target_feature(enable = $features)])?
            pub(super) fn clear_sums<R: Real>(chain: &mut Chain<R>) {
                chain.node_blocks.iter_mut().for_each(NodeBlock::clear_sums);
            }
        }
    };
}
for_each_instruction_set!(compiled_for);

/// Scalar product of the vectors at a lane.
#[inline(always)]
fn dot<R: Real>(a: &Rows<R>, b: &Rows<R>, lane: usize) -> R {
    a[0].0[lane] * b[0].0[lane] + a[1].0[lane] * b[1].0[lane] + a[2].0[lane] * b[2].0[lane]
}

#[inline(always)]
fn slid<R: Real>(chain: &Chain<R>, reach: R) -> bool {
    let mut slid = false;
    for (state, node) in chain.states.iter().zip(&chain.node_blocks) {
        for lane in 0..R::LANES {
            let along = dot(&state.u, &node.tangent, lane);
            slid |= along > reach || along < -reach;
        }
    }
    slid
}

#[inline(always)]
fn find_drag<R: Real>(chain: &mut Chain<R>, dt: f64) {
    let half = R::from_f64(0.5);
    let Chain { places, node_blocks, states, .. } = chain;
    for (row, (node, state)) in node_blocks.iter_mut().zip(&*states).enumerate() {
        let dt = R::from_f64(dt / f64::from(places.parts_at(row)));
        for lane in 0..R::LANES {
            let along = dot(&node.tangent, &state.v, lane);
            let square = dot(&state.v, &state.v, lane) - along * along;
            let speed = Number::max(square, R::default()).sqrt();
            // c + ½ ρ C_d D |v|, both parts times the length.
            let drag = node.drag_linear.0[lane] + node.drag_quadratic.0[lane] * speed;
            let slowed = dt * node.inv_mass_lateral.0[lane] * drag;
            // At most half: explicit drag must not turn the velocity round.
            node.slowed.0[lane] = Number::min(slowed, half);
        }
    }
}

#[inline(always)]
fn motions<R: Real, N: Doubles>(chain: &Chain<R>, range: Range<usize>, motions: &mut Motions) {
    let rows = range.len();
    let Motions { axial_m_per_s, spin_rad_per_s } = motions;
    let (nodes, states) = (&chain.node_blocks[range.clone()], &chain.states[range]);
    for (row, (node, state)) in nodes.iter().zip(states).enumerate() {
        for lane in (0..R::LANES).step_by(N::WIDTH) {
            let along = doubles::<R, N>(&node.tangent, lane).dot(doubles(&state.v, lane));
            spread(axial_m_per_s, lane * rows + row, rows, along);
            spread(spin_rad_per_s, lane * rows + row, rows, part::<R, N>(&state.spin, lane));
        }
    }
}

/// Puts the numbers of lanes where each piece of the chain has its node.
#[inline(always)]
fn spread<N: Doubles>(into: &mut [f64], first: usize, rows: usize, numbers: N) {
    let mut lanes = [0.0; SINGLES];
    assert!(N::WIDTH <= SINGLES);
    // SAFETY: there is room for so many numbers.
    unsafe { numbers.store(lanes.as_mut_ptr()) };
    for (at, number) in into[first..].iter_mut().step_by(rows).zip(&lanes[..N::WIDTH]) {
        *at = *number;
    }
}

#[inline(always)]
fn above_N<R: Real>(chain: &Chain<R>, least: R) -> [bool; SINGLES] {
    let mut above = [true; SINGLES];
    for block in &chain.element_blocks[chain.rows_of(0)] {
        for (above, tension) in above.iter_mut().zip(block.tension.0.as_ref()) {
            *above &= *tension > least;
        }
    }
    above
}

/// Rows in which friction has worked. Most rows are between the joints and touch nothing, so they
/// add nothing.
#[inline(always)]
fn rubbed<R: Real>(chain: &Chain<R>) -> Vec<usize> {
    let mut rubbed = Vec::with_capacity(chain.node_blocks.len());
    for (row, node) in chain.node_blocks.iter().enumerate() {
        let mut any = false;
        for lane in 0..R::LANES {
            any |= node.sum_wear.0[lane] != R::default();
        }
        if any {
            rubbed.push(row);
        }
    }
    rubbed
}

#[inline(always)]
fn slower<R: Real>(chain: &Chain<R>, speed_m_per_s: f64, spin_rad_per_s: f64) -> bool {
    let mut slower = true;
    for StateBlock { v: [x, y, z], spin, .. } in &chain.states {
        for lane in 0..R::LANES {
            // Not a number is not below.
            slower &= x.0[lane].to_f64().abs() < speed_m_per_s;
            slower &= y.0[lane].to_f64().abs() < speed_m_per_s;
            slower &= z.0[lane].to_f64().abs() < speed_m_per_s;
            slower &= spin.0[lane].to_f64().abs() < spin_rad_per_s;
        }
    }
    slower
}

#[inline(always)]
fn renormalise<R: Real, N: Doubles>(chain: &mut Chain<R>) {
    let rows = chain.node_blocks.len();
    // Nodes that fill the last lane do not turn, and theirs are unit directors.
    for state in &mut chain.states[..rows] {
        for lane in (0..R::LANES).step_by(N::WIDTH) {
            let d = doubles::<R, N>(&state.d, lane);
            let unit = d.scaled(N::splat(1.0) / d.dot(d).sqrt());
            let w = doubles::<R, N>(&state.w, lane);
            keep(&mut state.d, lane, unit);
            keep(&mut state.w, lane, w.minus(unit, w.dot(unit)));
        }
    }
}

/// A vector at each lane from `lane` on.
#[inline(always)]
fn doubles<R: Real, N: Doubles>([x, y, z]: &Rows<R>, lane: usize) -> Vector<N> {
    Vector(part(x, lane), part(y, lane), part(z, lane))
}

#[inline(always)]
fn part<R: Real, N: Doubles>(row: &Row<R>, lane: usize) -> N {
    assert!(lane + N::WIDTH <= R::LANES);
    // SAFETY: the row holds so many numbers.
    unsafe { R::doubles(row.0.as_ref().as_ptr().add(lane)) }
}

#[inline(always)]
fn keep<R: Real, N: Doubles>([x, y, z]: &mut Rows<R>, lane: usize, vector: Vector<N>) {
    keep_part(x, lane, vector.0);
    keep_part(y, lane, vector.1);
    keep_part(z, lane, vector.2);
}

#[inline(always)]
fn keep_part<R: Real, N: Doubles>(row: &mut Row<R>, lane: usize, numbers: N) {
    assert!(lane + N::WIDTH <= R::LANES);
    // SAFETY: the row has room for so many numbers.
    unsafe { R::keep_doubles(numbers, row.0.as_mut().as_mut_ptr().add(lane)) };
}
