//! Fourier's transform, with the same operations in the same order on every processor.

use std::f64::consts::{PI, TAU};

/// Transforms signals of one length `n`: `Z_k = Σ z_j exp(−2πi jk/n)`.
pub(crate) enum Fourier {
    /// A power of two.
    Halved(Halved),
    /// Another length, as a convolution with a chirp (L. I. Bluestein, *A linear filtering approach
    /// to the computation of discrete Fourier transform*, IEEE Trans. Audio Electroacoust. 18,
    /// 1970).
    Chirped {
        /// `exp(−πi j²/n)`: real and imaginary parts.
        chirp: [Vec<f64>; 2],
        /// The transform of its complex conjugate, over the length of the convolution.
        conjugate: [Vec<f64>; 2],
        /// A power of two that holds the convolution.
        inner: Halved,
    },
}

impl Fourier {
    pub(crate) fn of(length: usize) -> Self {
        if length.is_power_of_two() {
            return Self::Halved(Halved::of(length));
        }
        // j² modulo 2n, so that the angle keeps its digits.
        let squares = (0..length as u64).map(|j| (j * j % (2 * length as u64)) as f64);
        let (sines, cosines): (Vec<f64>, Vec<f64>) =
            squares.map(|square| libm::sincos(-PI * square / length as f64)).unzip();
        let inner = Halved::of((2 * length - 1).next_power_of_two());
        let around = |values: &[f64], sign: f64| {
            let mut whole = vec![0.0; inner.length];
            for (j, value) in values.iter().enumerate() {
                whole[j] = sign * value;
                whole[(inner.length - j) % inner.length] = sign * value;
            }
            whole
        };
        let (mut re, mut im) = (around(&cosines, 1.0), around(&sines, -1.0));
        inner.transform(&mut re, &mut im);
        Self::Chirped { chirp: [cosines, sines], conjugate: [re, im], inner }
    }

    /// Transforms a signal of this length: real and imaginary parts.
    pub(crate) fn transform(&self, re: &mut [f64], im: &mut [f64]) {
        match self {
            Self::Halved(halved) => halved.transform(re, im),
            Self::Chirped { chirp: [cosines, sines], conjugate: [by_re, by_im], inner } => {
                let (mut a, mut b) = (vec![0.0; inner.length], vec![0.0; inner.length]);
                for j in 0..re.len() {
                    (a[j], b[j]) = product([re[j], im[j]], [cosines[j], sines[j]]);
                }
                inner.transform(&mut a, &mut b);
                for j in 0..inner.length {
                    (a[j], b[j]) = product([a[j], b[j]], [by_re[j], by_im[j]]);
                }
                // With real and imaginary parts exchanged before and after, this is the inverse
                // transform.
                inner.transform(&mut b, &mut a);
                let scale = 1.0 / inner.length as f64;
                for j in 0..re.len() {
                    let (x, y) = product([a[j], b[j]], [cosines[j], sines[j]]);
                    (re[j], im[j]) = (x * scale, y * scale);
                }
            }
        }
    }
}

fn product([a, b]: [f64; 2], [c, d]: [f64; 2]) -> (f64, f64) {
    (a * c - b * d, a * d + b * c)
}

/// The transform of a power of two, halved again and again (J. W. Cooley, J. W. Tukey, *An
/// algorithm for the machine calculation of complex Fourier series*, Math. Comp. 19, 1965).
pub(crate) struct Halved {
    length: usize,
    /// `exp(−2πi j/n)` for the first half of the circle.
    roots: Vec<[f64; 2]>,
}

impl Halved {
    fn of(length: usize) -> Self {
        let root = |j: usize| {
            let (sine, cosine) = libm::sincos(-TAU * j as f64 / length as f64);
            [cosine, sine]
        };
        Self { length, roots: (0..length / 2).map(root).collect() }
    }

    fn transform(&self, re: &mut [f64], im: &mut [f64]) {
        let unused = usize::BITS - self.length.trailing_zeros();
        for j in 1..self.length {
            let to = j.reverse_bits() >> unused;
            if j < to {
                re.swap(j, to);
                im.swap(j, to);
            }
        }
        let mut half = 1;
        while half < self.length {
            let stride = self.length / (2 * half);
            for from in (0..self.length).step_by(2 * half) {
                for j in 0..half {
                    let (low, high) = (from + j, from + j + half);
                    let (x, y) = product([re[high], im[high]], self.roots[j * stride]);
                    (re[high], im[high]) = (re[low] - x, im[low] - y);
                    (re[low], im[low]) = (re[low] + x, im[low] + y);
                }
            }
            half *= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum itself, for lengths of every kind; 1e-12 is the rounding of a hundred numbers of
    /// size one.
    #[test]
    fn it_is_the_sum() {
        for n in [1, 2, 3, 4, 5, 7, 8, 12, 31, 64, 97, 100] {
            let signal = |j: usize| [(1.3 * j as f64).sin(), ((j * j) as f64 * 0.7).cos()];
            let (mut re, mut im): (Vec<f64>, Vec<f64>) =
                (0..n).map(|j| (signal(j)[0], signal(j)[1])).unzip();
            Fourier::of(n).transform(&mut re, &mut im);
            for k in 0..n {
                let (mut x, mut y) = (0.0, 0.0);
                for j in 0..n {
                    let (sine, cosine) = (-TAU * (j * k % n) as f64 / n as f64).sin_cos();
                    let (a, b) = product(signal(j), [cosine, sine]);
                    (x, y) = (x + a, y + b);
                }
                assert!((x - re[k]).hypot(y - im[k]) < 1e-12, "{n}: {k}");
            }
        }
    }
}
