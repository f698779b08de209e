//! Sums over the window, a block of nodes at a time.

use serde::{Deserialize, Serialize};

use super::{
    lane::{Lane, add, at, keep_larger, put},
    node_sample::{Bearing, Direction, Place, Source},
    reservoir::ReservoirRow,
};
use crate::simd::{
    dispatch::{for_each_instruction_set, with_fastest_instruction_set},
    lanes::DOUBLES,
    number::{Doubles, Real},
    wide::Pair,
};

/// Sums over the window for a block of nodes, and for the elements below them.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[repr(C, align(64))]
pub struct SumBlock {
    /// Tension and torque of the first sample: squares are summed about them, so that a small
    /// spread about a large mean keeps its digits.
    pub about: [Lane; 2],
    pub tension: [Lane; 2],
    pub torque: [Lane; 2],
    pub normal: [Lane; 2],
    pub normal_max: Lane,
    pub touched: Lane,
    pub signed: Lane,
    /// Contact force towards the high side and towards the right of it, looking down the hole.
    pub up: Lane,
    pub right: Lane,
    pub axial: Lane,
    pub friction_torque: Lane,
    pub offset: Lane,
    pub offset_square: Lane,
    pub circling: Lane,
    pub speed_square: Lane,
    pub bending: Lane,
    pub bending_max: Lane,
    pub between: Lane,
    pub between_max: Lane,
    pub stress: Lane,
    pub stress_max: Lane,
    pub twist: Lane,
}

const NONE: Lane = [0.0; DOUBLES];

impl SumBlock {
    pub const EMPTY: Self = Self {
        about: [NONE; 2],
        tension: [NONE; 2],
        torque: [NONE; 2],
        normal: [NONE; 2],
        normal_max: NONE,
        touched: NONE,
        signed: NONE,
        up: NONE,
        right: NONE,
        axial: NONE,
        friction_torque: NONE,
        offset: NONE,
        offset_square: NONE,
        circling: NONE,
        speed_square: NONE,
        bending: NONE,
        bending_max: NONE,
        between: NONE,
        between_max: NONE,
        stress: NONE,
        stress_max: NONE,
        twist: NONE,
    };

    #[inline(always)]
    fn lie<N: Doubles>(&mut self, lane: usize, place: &Place<N>) {
        add(&mut self.offset, lane, place.offset);
        add(&mut self.offset_square, lane, place.offset * place.offset);
        add(&mut self.circling, lane, place.circling);
        add(&mut self.speed_square, lane, place.speed_square);
    }

    #[inline(always)]
    fn touch<N: Doubles>(&mut self, lane: usize, contact: &Contact<N>) {
        let Contact { normal, friction: [axial, torque], direction: Direction { up, right } } =
            *contact;
        square_up(&mut self.normal, lane, normal);
        keep_larger(&mut self.normal_max, lane, normal);
        add(&mut self.touched, lane, normal.if_positive(N::splat(1.0), N::zero()));
        add(&mut self.signed, lane, (-up).if_positive(-normal, normal));
        add(&mut self.up, lane, normal * up);
        add(&mut self.right, lane, normal * right);
        add(&mut self.axial, lane, axial);
        add(&mut self.friction_torque, lane, torque);
    }

    #[inline(always)]
    fn bear<N: Doubles>(&mut self, lane: usize, bearing: &Bearing<N>, first: bool) {
        let [about_tension, about_torque] = &mut self.about;
        if first {
            put(about_tension, lane, bearing.tension);
            put(about_torque, lane, bearing.torque);
        }
        let (tension, torque) = (at::<N, f64>(about_tension, lane), at(about_torque, lane));
        square_up(&mut self.tension, lane, bearing.tension - tension);
        square_up(&mut self.torque, lane, bearing.torque - torque);
        add(&mut self.bending, lane, bearing.bending);
        keep_larger(&mut self.bending_max, lane, bearing.bending);
        add(&mut self.between, lane, bearing.between);
        keep_larger(&mut self.between_max, lane, bearing.between);
        add(&mut self.stress, lane, bearing.stress);
        keep_larger(&mut self.stress_max, lane, bearing.stress);
        add(&mut self.twist, lane, bearing.twist);
    }
}

/// Adds numbers and their squares.
#[inline(always)]
fn square_up<N: Doubles>([first, second]: &mut [Lane; 2], lane: usize, value: N) {
    add(first, lane, value);
    add(second, lane, value * value);
}

/// Contact of nodes, at least one of which touches the wall.
#[derive(Debug, Clone, Copy)]
struct Contact<N> {
    normal: N,
    friction: [N; 2],
    direction: Direction<N>,
}

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
    /// Largest magnitude of the tension, N.
    pub tension_N: f64,
    /// Twist of all elements, rad, in the sign of the chain.
    pub twist_rad: f64,
    /// Elongation of the string by its tension, m.
    pub longer_m: f64,
}

/// The same, lane by lane.
#[derive(Debug, Clone, Copy)]
pub struct TotalBlock {
    normal: Lane,
    axial: Lane,
    torque: Lane,
    penetration: Lane,
    tension: Lane,
    twist: Lane,
    longer: Lane,
}

impl TotalBlock {
    pub const EMPTY: Self = Self {
        normal: NONE,
        axial: NONE,
        torque: NONE,
        penetration: NONE,
        tension: NONE,
        twist: NONE,
        longer: NONE,
    };

    /// Of all lanes.
    pub fn sum(&self) -> Totals {
        Totals {
            normal_N: self.normal.iter().sum(),
            axial_N: self.axial.iter().sum(),
            torque_N_m: self.torque.iter().sum(),
            penetration_m: self.penetration.iter().copied().fold(0.0, f64::max),
            tension_N: self.tension.iter().copied().fold(0.0, f64::max),
            twist_rad: self.twist.iter().sum(),
            longer_m: self.longer.iter().sum(),
        }
    }
}

/// A sample of the whole string on its way into the sums.
pub struct Pass<'a, R: Real> {
    pub sums: &'a mut [SumBlock],
    pub source: Source<'a, R>,
    /// Whether it is the first sample of the window.
    pub first: bool,
    /// Storage of its values, if they are kept.
    pub reservoir: Option<ReservoirRow<'a>>,
    /// Sums over the blocks.
    pub totals: &'a mut TotalBlock,
}

impl<R: Real> Pass<'_, R> {
    /// Adds the sample, with the widest instructions that the processor has: the arithmetic is the
    /// same, operation by operation, and so are its bits.
    pub fn add(self) {
        with_fastest_instruction_set!(add(self));
    }

    #[inline(always)]
    fn add_in<N: Doubles>(mut self) {
        let chain = self.source.ends.chain;
        let parts = R::LANES / DOUBLES;
        for region in 0..chain.regions() {
            let mut above = self.source.above::<N>(region);
            for row in chain.rows_of(region) {
                for part in 0..parts {
                    for lane in (0..DOUBLES).step_by(N::WIDTH) {
                        let lower =
                            self.add_nodes(row * parts + part, lane, above.at::<N>(part, lane));
                        above.put(part, lane, lower);
                    }
                }
            }
        }
    }

    /// Adds nodes, and the elements below them; `above` and the returned value are the moments of
    /// elements at their lower ends.
    #[inline(always)]
    fn add_nodes<N: Doubles>(&mut self, block: usize, lane: usize, above: [N; 3]) -> [N; 3] {
        let sums = &mut self.sums[block];
        let normal: N = self.source.normal(block, lane);
        let place = self.source.place(block, lane);
        sums.lie(lane, &place);
        keep_larger(&mut self.totals.penetration, lane, place.penetration);
        // While the place is at hand: there are not registers enough to keep it for later.
        let mut side = N::zero();
        // Nodes without contact add nothing.
        if normal.any_positive() {
            let friction @ [axial, torque] = self.source.friction(block, lane);
            let direction = self.source.direction(&place, block, lane);
            sums.touch(lane, &Contact { normal, friction, direction });
            add(&mut self.totals.normal, lane, normal);
            add(&mut self.totals.axial, lane, axial);
            add(&mut self.totals.torque, lane, torque);
            // Signed by the side of the node, like the sums; +0 for a node without contact.
            side = (-direction.up).if_positive(N::zero() - normal, normal);
        }
        let (bearing, lower) = self.source.bearing::<N>(block, lane, above);
        sums.bear(lane, &bearing, self.first);
        let Bearing { tension, twist, longer, .. } = bearing;
        keep_larger(&mut self.totals.tension, lane, tension.max(-tension));
        add(&mut self.totals.twist, lane, twist);
        add(&mut self.totals.longer, lane, longer);
        if let Some(reservoir) = &mut self.reservoir {
            reservoir.put(block, lane, [tension, bearing.torque, side, bearing.bending]);
        }
        lower
    }
}

macro_rules! compiled_for {
    ($set:ident, $number:ident $(, $features:literal)?) => {
        mod $set {
            use super::*;

            $(#[target_feature(enable = $features)])?
            pub(super) fn add<R: Real>(pass: Pass<'_, R>) {
                pass.add_in::<Pair<crate::simd::dispatch::$number<f64>>>();
            }
        }
    };
}
for_each_instruction_set!(compiled_for);
