//! Rotational stiffness of elements at an end.

use super::deflection::Deflection;
use crate::simd::number::Doubles;

/// Moment that turns an end of elements by one radian, N·m.
#[derive(Debug, Clone, Copy)]
pub struct EndStiffness<N> {
    /// If the other end turns by the same angle the other way: `EI/L` without tension, zero from
    /// Euler's load of the element on.
    pub even: N,
    /// If it turns by the same angle the same way: `3 EI/L` without tension.
    pub odd: N,
    /// Moment half-way as one end turns.
    pub half_way: N,
}

impl<N: Doubles> EndStiffness<N> {
    /// Stiffness of elements from the moments at their ends and half-way over the load, m², and
    /// from the moment that turns both ends alike, N·m. An element compressed beyond Euler's load
    /// has only the latter, because with a negative stiffness a node could not distribute its
    /// moment.
    #[inline(always)]
    pub fn of(deflection: &Deflection<N>, [at_ends, half_way]: [N; 2], odd: N) -> Self {
        let with = |part: N| deflection.bending + deflection.pull * part;
        Self { even: with(at_ends).max(N::zero()), odd, half_way: with(half_way) }
    }

    /// While the other end stays as it is.
    #[inline(always)]
    pub fn held(&self) -> N {
        self.even + self.odd
    }

    /// Part of the moment of the turning end that is carried over to the fixed end: half without
    /// tension.
    #[inline(always)]
    pub fn carry_over(&self) -> N {
        (self.odd - self.even) / self.held().max(N::splat(N::TINY))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{rod::beam_column::BeamColumn, simd::vector::Vector};

    /// From tension to many times Euler's load an element holds its ends by something: two of them
    /// share a node's moment out in parts from 0 to 1, and carry no more over than arrives. Without
    /// that the moment of a string under water hammer was infinite, and its stress "inf %" of the
    /// yield strength.
    #[test]
    fn a_buckled_element_still_shares_moments_out() {
        const LENGTH_M: f64 = 9.6;
        const STIFFNESS_N_M2: f64 = 1.25e6;
        let held = |tension_N: f64| {
            let pull = tension_N / LENGTH_M;
            let deflection = Deflection {
                odd: Vector::zero(),
                even: Vector::zero(),
                pull,
                bending: STIFFNESS_N_M2 / LENGTH_M,
                weight: Vector::zero(),
            };
            let column = BeamColumn::of(tension_N * LENGTH_M.powi(2) / (64.0 * STIFFNESS_N_M2));
            let middle = crate::rod::beam_column::Middle {
                load: Vector(100.0, 0.0, 0.0),
                offset: Vector::zero(),
                clearance: 0.05,
            };
            let shape = column.bent(LENGTH_M, STIFFNESS_N_M2, &middle);
            let odd = 3.0 * STIFFNESS_N_M2 / LENGTH_M * column.odd();
            EndStiffness::of(&deflection, [shape.at_ends, shape.half_way], odd)
        };
        for above_N in [1e6, 0.0, -1e5, -1.34e5, -4e5, -6e5, -1e7] {
            for below_N in [1e6, -1.34e5, -6e5, -1e7] {
                let [above, below] = [above_N, below_N].map(held);
                let part = above.held() / (above.held() + below.held());
                assert!((0.0..=1.0).contains(&part), "{above_N} {below_N}: {part}");
                let carried = above.carry_over();
                assert!(carried.abs() <= 1.0, "{above_N}: {carried}");
            }
        }
    }
}
