//! Work that a processor does as fast as it can.

use std::hint::black_box;

use super::{lanes::SINGLES, number::Number};

/// Chains of arithmetic that do not wait for one another. Two units that take four or five cycles
/// for a result are busy with ten; with two constants, more chains do not fit the sixteen registers
/// of AVX2.
const CHAINS: usize = 12;

/// Multiplies numbers in registers and adds to them, `rounds` times, and does nothing else; how
/// many floating-point operations that was, a multiplication with addition being two.
#[inline(always)]
pub fn work<N: Number>(rounds: usize) -> u64 {
    let (factor, term) = (N::splat(black_box(1.0)), N::splat(black_box(0.0)));
    let mut chains = different::<N>();
    for _ in 0..rounds {
        for chain in &mut chains {
            *chain = chain.mul_add(factor, term);
        }
    }
    keep(chains);
    2 * (CHAINS * N::WIDTH * rounds) as u64
}

/// Numbers that the compiler takes for different ones: it would reckon with equal ones only once.
#[inline(always)]
fn different<N: Number>() -> [N; CHAINS] {
    let mut numbers = [N::zero(); CHAINS];
    for number in &mut numbers {
        *number = N::splat(black_box(1.0));
    }
    numbers
}

/// Uses the results, so that the compiler cannot remove the computation.
#[inline(always)]
fn keep<N: Number>(numbers: [N; CHAINS]) {
    let mut sum = N::zero();
    for number in numbers {
        sum = sum + number;
    }
    let mut lanes = [N::Real::default(); SINGLES];
    assert!(N::WIDTH <= SINGLES);
    // SAFETY: there is room for `WIDTH` numbers.
    unsafe { sum.store(lanes.as_mut_ptr()) };
    black_box(lanes);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::counted::{Counted, count};

    /// The reported number of operations is correct, except that the sum at the end is not
    /// included.
    #[test]
    fn the_work_is_what_it_is_said_to_be() {
        let mut result = 0;
        let flops = count(|| result = work::<Counted<f64>>(10));
        assert_eq!(result, flops.total() - CHAINS as u64);
    }
}
