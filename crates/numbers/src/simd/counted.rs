//! A [`Number`] that counts its operations.

use std::{
    cell::Cell,
    ops::{Add, Div, Mul, Neg, Sub},
};

use serde::Serialize;

use super::number::{Number, Real};

/// Floating-point operations by their kinds.
///
/// Operations on signs, and selections (the larger, the smaller, the positive), are not counted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Flops {
    /// Additions and subtractions.
    pub additions: u64,
    /// Multiplications.
    pub multiplications: u64,
    /// Multiplications with an addition, in one instruction where the processor has it.
    pub multiply_additions: u64,
    /// Divisions.
    pub divisions: u64,
    /// Square roots.
    pub roots: u64,
}

impl Flops {
    const NONE: Self =
        Self { additions: 0, multiplications: 0, multiply_additions: 0, divisions: 0, roots: 0 };

    /// All of them: a multiplication with addition is two, anything else one.
    pub fn total(self) -> u64 {
        self.additions
            + self.multiplications
            + 2 * self.multiply_additions
            + self.divisions
            + self.roots
    }
}

thread_local! {
    static TALLY: Cell<Flops> = const { Cell::new(Flops::NONE) };
}

/// Counts the operations of `work` on [`Counted`] numbers in this thread.
pub fn count(work: impl FnOnce()) -> Flops {
    TALLY.set(Flops::NONE);
    work();
    TALLY.take()
}

fn note(more: impl FnOnce(&mut Flops)) {
    let mut flops = TALLY.get();
    more(&mut flops);
    TALLY.set(flops);
}

/// A number that reckons like the one it holds, without fused multiply-add, and notes it for
/// [`count`].
#[derive(Debug, Clone, Copy)]
pub struct Counted<R>(R);

macro_rules! counted_operator {
    ($trait:ident, $method:ident, $kind:ident) => {
        impl<R: Real> $trait for Counted<R> {
            type Output = Self;
            // A call each: counting need not be fast, but is compiled for every law.
            #[inline(never)]
            fn $method(self, other: Self) -> Self {
                note(|flops| flops.$kind += 1);
                Self(self.0.$method(other.0))
            }
        }
    };
}
counted_operator!(Add, add, additions);
counted_operator!(Sub, sub, additions);
counted_operator!(Mul, mul, multiplications);
counted_operator!(Div, div, divisions);

impl<R: Real> Neg for Counted<R> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<R: Real> Number for Counted<R> {
    type Real = R;
    const TINY: f64 = R::TINY;
    const WIDTH: usize = 1;
    fn splat(value: f64) -> Self {
        Self(R::from_f64(value))
    }
    unsafe fn load(from: *const R) -> Self {
        // SAFETY: the caller's `from` points to a number.
        unsafe { Self(*from) }
    }
    unsafe fn store(self, to: *mut R) {
        // SAFETY: the caller's `to` points to a number.
        unsafe { *to = self.0 }
    }
    #[inline(never)]
    fn sqrt(self) -> Self {
        note(|flops| flops.roots += 1);
        Self(self.0.sqrt())
    }
    #[inline(never)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        note(|flops| flops.multiply_additions += 1);
        Self(self.0.mul_add(factor.0, term.0))
    }
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
    fn any_positive(self) -> bool {
        self.0.any_positive()
    }
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        Self(self.0.if_positive(then.0, otherwise.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::vector::Vector;

    /// Counts that can be made by hand.
    #[test]
    fn every_kind_is_counted() {
        type N = Counted<f64>;
        let vector = |x: f64, y: f64, z: f64| Vector(N::splat(x), N::splat(y), N::splat(z));
        let (a, b) = (vector(1.0, 2.0, 3.0), vector(-2.0, 0.5, 4.0));
        let mut found = 0.0;
        let flops = count(|| {
            // One product and two multiply-adds.
            let dot = a.dot(b);
            // Three products and three multiply-adds.
            let cross = a.cross(b) - b;
            let far = -(dot / cross.2 + dot.sqrt()).max(N::zero());
            found = far.0;
        });
        assert_eq!(
            flops,
            Flops {
                additions: 4,
                multiplications: 4,
                multiply_additions: 5,
                divisions: 1,
                roots: 1,
            }
        );
        assert_eq!(flops.total(), 20);
        // a·b = 11, (a × b − b)_z = 0.5.
        assert_eq!(found, -(22.0 + 11f64.sqrt()));
        // Each count begins anew.
        assert_eq!(count(|| ()), Flops::NONE);
    }
}
