//! Bending of an element between its nodes under tension and its own weight: a beam-column, whose
//! ends the chain turns and moves.
//!
//! With `w` from the chord, `EI w'''' − T w'' = q`. The even part is a parabola, whose curvature
//! `β` is the relative rotation of the ends over the length `L`, plus, with `Q = T β + q` and
//! slopes of zero at the ends, that of a span between tool joints
//! ([`statics::span`](crate::statics::span)): with `z = (L/4) √(T/EI)` and `J(x) = (√x coth √x −
//! 1)/x`,
//!
//! ```text
//! EI w'' = EI β + (Q L²/16) (J(z²) ± m/(z coth z))       + at the ends, − half-way
//! sag    = m Q L⁴ J(z²)/(128 EI z coth z)                m = 1 while the wall does not hold it
//! ```
//!
//! The odd part, ends turned alike by `α`, has the moments `∓ 2 EI α/(L J(4z²))`.
//! Theory and limits: `docs/src/theory/mesh.md`.

use crate::simd::{number::Number, vector::Vector};

/// Effect of tension on the bending of an element.
#[derive(Debug, Clone, Copy)]
pub struct BeamColumn<N> {
    /// `J(z²)`.
    mean: N,
    /// `1/(z coth z)`.
    swing: N,
    /// `1/J(4z²)`.
    odd: N,
}

/// Support of the middle of an element at the wall.
#[derive(Debug, Clone, Copy)]
pub struct Middle<N> {
    /// `Q`, N/m.
    pub load: Vector<N>,
    /// Offset of the parabola's middle from the hole's axis, m.
    pub offset: Vector<N>,
    /// Clearance of the body from it, m.
    pub clearance: N,
}

/// Bending of an element by its loads.
#[derive(Debug, Clone, Copy)]
pub struct Shape<N> {
    /// Moment at the ends over the load `Q`, m².
    pub at_ends: N,
    /// Moment half-way over the load `Q`, m².
    pub half_way: N,
    /// Sag beyond the parabola, m.
    pub sag: N,
    /// One where the wall holds the middle, zero elsewhere.
    pub touches: N,
}

/// `π²/64`: where [`BeamColumn::of`] is Euler's load of the element on pins.
pub const EULER: f64 = std::f64::consts::PI * std::f64::consts::PI / 64.0;

impl<N: Number> BeamColumn<N> {
    /// Of `T L²/64EI`. In compression beyond Euler's load of the element, which a mesh should not
    /// let come, it is that of Euler's load.
    ///
    /// `J` of a quarter of `z²` is Lambert's continued fraction cut off after its fourth part, and
    /// `4 J(4x) = J(x) + 1/(1 + x J(x))` makes the others of it. They are exact to 3e-6 up to
    /// `T L² = 1000 EI` (13 MN of 5 in pipe between joints 9.6 m apart), to 1e-3 up to three times
    /// as much.
    #[inline(always)]
    pub fn of(column: N) -> Self {
        let [one, quarter] = [1.0, 0.25].map(N::splat);
        let x = column.max(N::splat(-EULER));
        let least =
            (N::splat(315.0) + N::splat(14.0) * x) / (N::splat(945.0) + x * (N::splat(105.0) + x));
        let mean = quarter * (least + one / (one + x * least));
        let swing = one / (one + N::splat(4.0) * x * mean);
        let odd = N::splat(4.0) / (mean + swing);
        Self { mean, swing, odd }
    }

    /// Moment at the far end over the angle by which both ends are turned alike, as a multiple of
    /// `2 EI/L`; three without tension.
    #[inline(always)]
    pub fn odd(&self) -> N {
        self.odd
    }

    /// Bending of an element of that length, m, and bending stiffness, N·m², by its load. The
    /// wall's support acts along the load's direction.
    #[inline(always)]
    pub fn bent(&self, length: N, stiffness: N, middle: &Middle<N>) -> Shape<N> {
        let Middle { load, offset, clearance } = *middle;
        let [one, tiny] = [1.0, N::TINY].map(N::splat);
        let part = N::splat(1.0 / 16.0) * length * length;
        let square = load.dot(load);
        let along = offset.dot(load);
        let inside = (clearance * clearance - offset.dot(offset)).max(N::zero());
        // The load times the way to the wall.
        let room = ((along * along + square * inside).sqrt() - along).max(tiny);
        // The load times its sag without support: L⁴/128 = 2 (L²/16)².
        let sagging =
            square * (part * part + part * part) * self.mean * self.swing / stiffness.max(tiny);
        let held = (room / sagging.max(tiny)).min(one);
        let swing = held * self.swing;
        // Where less than the mean of the swing is left, a stretch is on the wall.
        let lies = self.mean - swing;
        let lying = ((stiffness + stiffness) * room / square.max(tiny)).sqrt();
        Shape {
            at_ends: lies.if_positive(lying, part * (self.mean + swing)),
            half_way: lies.if_positive(N::zero(), part * (self.mean - swing)),
            sag: held * sagging / square.sqrt().max(tiny),
            touches: (one - held).if_positive(one, N::zero()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statics::span::{BodyContact, JointSpan};

    /// An element whose ends are placed like tool joints in a hole of that curvature bends as the
    /// span of the soft string, whichever part of it touches, to the error of the fraction: 3e-6,
    /// where `T L²` is 740 EI at most. The load and the hole's curvature are askew.
    #[test]
    fn an_element_between_joints_is_a_span() {
        const STIFFNESS: f64 = 1.25e6;
        const LENGTH_M: f64 = 9.6;
        const STANDOFF_M: f64 = 0.02;
        const CLEARANCE_M: f64 = 0.044;
        let span = JointSpan {
            bending_stiffness_N_m2: STIFFNESS,
            half_spacing_m: 0.5 * LENGTH_M,
            standoff_m: STANDOFF_M,
        };
        let (mut worst, mut seen) = (0.0_f64, [0; 3]);
        for tension in [-1.2e5, -1e4, 0.0, 1e4, 3e5, 1.2e6, 1e7] {
            for load in [1.0, 100.0, 500.0, 2e3, 1e4, 5e4] {
                let expected = span.bending(tension, load);
                let towards = Vector(0.6, 0.8, 0.0);
                let middle = Middle {
                    load: towards.scaled(load),
                    offset: towards.scaled(CLEARANCE_M - STANDOFF_M),
                    clearance: CLEARANCE_M,
                };
                let column = BeamColumn::of(tension * LENGTH_M.powi(2) / (64.0 * STIFFNESS));
                let found = column.bent(LENGTH_M, STIFFNESS, &middle);
                let scale = expected.at_joint_per_m.abs();
                for (found, expected) in [
                    (found.at_ends * load / STIFFNESS, expected.at_joint_per_m),
                    (found.half_way * load / STIFFNESS, expected.at_middle_per_m),
                ] {
                    worst = worst.max((found - expected).abs() / scale);
                }
                let touches = expected.contact != BodyContact::None;
                assert_eq!(found.touches, f64::from(u8::from(touches)), "{tension} {load}");
                if touches {
                    assert!((found.sag / STANDOFF_M - 1.0).abs() < 1e-12, "{}", found.sag);
                }
                seen[expected.contact as usize] += 1;
            }
        }
        assert!(seen.iter().all(|count| *count > 2), "{seen:?}");
        assert!(worst < 5e-6, "{worst:e}");
    }

    /// Stiffness against equal rotation of the ends: `x²/(x coth x − 1)` with `x = (L/2)√(T/EI)`.
    #[test]
    fn ends_turned_alike() {
        for (x, error) in [(0.1, 1e-12), (1.0, 1e-12), (5.0, 1e-8), (15.0, 1e-5), (28.0, 1e-3)] {
            let found: f64 = BeamColumn::of(x * x / 16.0).odd();
            let expected = x * x / (x / f64::tanh(x) - 1.0);
            assert!((found / expected - 1.0).abs() < error, "{x}: {}", found / expected - 1.0);
        }
        let x = 1.5_f64;
        let found: f64 = BeamColumn::of(-x * x / 16.0).odd();
        let error = found * (1.0 - x / x.tan()) / (x * x) - 1.0;
        assert!(error.abs() < 1e-10, "{error:e}");
    }
}
