//! The characteristic function of steady rotation: zero at the roots of the whole string.

use nalgebra::Complex;

use super::{
    bit::LinearBit, bit::LinearRock, chain::LumpedChain, drive::LinearDrive, hoist::LinearHoist,
};
use crate::complex;

/// A value of the characteristic function: `mantissa · e^ln_scale`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Value {
    pub(super) mantissa: Complex<f64>,
    pub(super) ln_scale: f64,
}

impl Value {
    /// This over another.
    pub(super) fn over(&self, other: &Self) -> Complex<f64> {
        self.mantissa / other.mantissa * libm::exp(self.ln_scale - other.ln_scale)
    }

    /// Logarithm of its magnitude.
    pub(super) fn ln_norm(&self) -> f64 {
        libm::log(complex::norm(self.mantissa)) + self.ln_scale
    }
}

/// A string that turns and drills steadily, as small motions find it.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyRotation {
    /// In torsion.
    pub torsion: LumpedChain,
    /// Along the hole.
    pub axial: LumpedChain,
    /// Drive of its top.
    pub drive: LinearDrive,
    /// Support of its top.
    pub hoist: LinearHoist,
    /// Its bit.
    pub bit: LinearBit,
}

impl SteadyRotation {
    /// The characteristic function: the determinant of chains, top, hoist and bit. It has no poles
    /// but on the negative real axis and at zero.
    pub(super) fn values(&self, frequencies: &[Complex<f64>]) -> Vec<Value> {
        let torsion = self.torsion.responses::<false>(frequencies, |s| self.drive.top(s));
        if self.bit.rock == LinearRock::Bears {
            let zero = Complex::new(0.0, 0.0);
            let values = torsion.iter().zip(frequencies).map(|(t, s)| Value {
                mantissa: t.determinant * self.bit.close(*s, t.end, zero, zero),
                ln_scale: t.ln_scale,
            });
            return values.collect();
        }
        let axial = self.axial.responses::<true>(frequencies, |s| self.hoist.top(s));
        let both = torsion.iter().zip(&axial).zip(frequencies);
        both.map(|((t, a), s)| {
            let answered = -a.transfer * self.hoist.answer(*s);
            // Stiffnesses of N/m and N·m meet here: brought to a size that no product of them
            // exceeds.
            let closed = self.bit.close(*s, t.end, a.end, answered) * 1e-12;
            Value {
                mantissa: t.determinant * a.determinant * closed,
                ln_scale: t.ln_scale + a.ln_scale,
            }
        })
        .collect()
    }

    /// The same on chains of fewer nodes: with a travel time of up to `longest_s` from one to the
    /// next.
    pub(super) fn merged(&self, longest_s: f64) -> Self {
        let torsion = self.torsion.merged(longest_s);
        Self {
            drive: self.drive.with_half(torsion.inertia[0]),
            torsion,
            axial: self.axial.merged(longest_s),
            ..*self
        }
    }

    /// Time in which waves of both kinds run from one end of the string to the other, s: how fast
    /// the function turns.
    pub(super) fn travel_s(&self) -> f64 {
        let delay_s = match self.bit.rock {
            LinearRock::Delay { delay_s, .. } => delay_s,
            _ => 0.0,
        };
        let axial_s = if self.bit.rock == LinearRock::Bears { 0.0 } else { self.axial.travel_s() };
        self.torsion.travel_s() + axial_s + delay_s
    }
}
