//! Sums over the window, a block of nodes at a time.

use serde::{Deserialize, Serialize};

use super::{block_sample::BlockSample, lane::Lane, reservoir::ReservoirRow, strength::Strength};
use crate::{
    dynamics::{
        body::Body,
        kernel::chain::{Chain, Rows},
    },
    simd::{lanes::DOUBLES, number::Real},
};

/// Sums over the window for a block of nodes, and for the elements below them.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
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
        stress: NONE,
        stress_max: NONE,
        twist: NONE,
    };

    #[inline(always)]
    fn add(&mut self, sample: &BlockSample, first: bool) {
        if first {
            self.about = [sample.tension, sample.torque];
        }
        for lane in 0..DOUBLES {
            let tension = sample.tension[lane] - self.about[0][lane];
            let torque = sample.torque[lane] - self.about[1][lane];
            let normal = sample.normal[lane];
            self.tension[0][lane] += tension;
            self.tension[1][lane] += tension * tension;
            self.torque[0][lane] += torque;
            self.torque[1][lane] += torque * torque;
            self.normal[0][lane] += normal;
            self.normal[1][lane] += normal * normal;
            self.normal_max[lane] = larger(self.normal_max[lane], normal);
            self.touched[lane] += if normal > 0.0 { 1.0 } else { 0.0 };
            self.signed[lane] += if sample.up[lane] < 0.0 { -normal } else { normal };
            self.up[lane] += normal * sample.up[lane];
            self.right[lane] += normal * sample.right[lane];
            self.axial[lane] += sample.axial[lane];
            self.friction_torque[lane] += sample.friction_torque[lane];
            self.offset[lane] += sample.offset[lane];
            self.offset_square[lane] += sample.offset[lane] * sample.offset[lane];
            self.circling[lane] += sample.circling[lane];
            self.speed_square[lane] += sample.speed_square[lane];
            self.bending[lane] += sample.bending[lane];
            self.bending_max[lane] = larger(self.bending_max[lane], sample.bending[lane]);
            self.stress[lane] += sample.stress[lane];
            self.stress_max[lane] = larger(self.stress_max[lane], sample.stress[lane]);
            self.twist[lane] += sample.twist[lane];
        }
    }
}

/// One instruction, where `f64::max` handles not-a-number too.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
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
    /// What the tension lengthens the string, m.
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

    #[inline(always)]
    fn add(&mut self, sample: &BlockSample) {
        for lane in 0..DOUBLES {
            self.normal[lane] += sample.normal[lane];
            self.axial[lane] += sample.axial[lane];
            self.torque[lane] += sample.friction_torque[lane];
            self.twist[lane] += sample.twist[lane];
            self.longer[lane] += sample.longer[lane];
            self.penetration[lane] = larger(self.penetration[lane], sample.penetration[lane]);
            self.tension[lane] = larger(self.tension[lane], sample.tension[lane].abs());
        }
    }

    /// Of all lanes.
    pub fn sum(&self) -> Totals {
        Totals {
            normal_N: self.normal.iter().sum(),
            axial_N: self.axial.iter().sum(),
            torque_N_m: self.torque.iter().sum(),
            penetration_m: self.penetration.iter().copied().fold(0.0, larger),
            tension_N: self.tension.iter().copied().fold(0.0, larger),
            twist_rad: self.twist.iter().sum(),
            longer_m: self.longer.iter().sum(),
        }
    }
}

/// A sample of the whole string on its way into the sums.
pub struct Pass<'a, R: Real> {
    pub sums: &'a mut [SumBlock],
    pub chain: &'a Chain<R>,
    pub high: &'a [Rows<f64>],
    pub body: &'a Body,
    pub strength: &'a Strength,
    pub per_step: f64,
    /// Whether it is the first sample of the window.
    pub first: bool,
    /// Where its values are kept, if they are.
    pub reservoir: Option<ReservoirRow<'a>>,
    /// Sums over the blocks.
    pub totals: &'a mut TotalBlock,
}

impl<R: Real> Pass<'_, R> {
    /// Adds the sample, with the widest instructions that the processor has: the arithmetic is the
    /// same, operation by operation, and so are its bits.
    pub fn add(self) {
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq") {
                // SAFETY: the processor has what the function is compiled for.
                return unsafe { avx512(self) };
            }
            if is_x86_feature_detected!("avx2") {
                // SAFETY: as above.
                return unsafe { avx2(self) };
            }
        }
        self.add_all()
    }

    #[inline(always)]
    fn add_all(mut self) {
        for (block, sums) in self.sums.iter_mut().enumerate() {
            let sample = BlockSample::at(
                self.chain,
                self.high,
                self.body,
                self.strength,
                block,
                self.per_step,
            );
            self.totals.add(&sample);
            sums.add(&sample, self.first);
            if let Some(reservoir) = &mut self.reservoir {
                reservoir.put(block, &sample);
            }
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx2")]
fn avx512<R: Real>(pass: Pass<'_, R>) {
    pass.add_all()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<R: Real>(pass: Pass<'_, R>) {
    pass.add_all()
}
