//! The eight-node hexahedral element with one point of integration.
//!
//! A field over the eight corners is turned into its sums over them with the signs of the products
//! of the natural coordinates (Hadamard's transform): the mean, three **gradients**, four
//! **hourglasses** (Flanagan and Belytschko 1981). The strain of a step is that at its middle
//! (Hughes and Winget 1980); the Kirchhoff stress `τ` pulls at the corners by `V₀ τ F⁻ᵀ`. Theory:
//! `docs/src/theory/rock.md`.

// Indices say which components are combined.
#![allow(clippy::needless_range_loop)]

use super::constants::Constants;
use wholestring_numbers::simd::number::Number;

/// Nine numbers, by row.
pub type Matrix<N> = [[N; 3]; 3];

/// Sums over the corners with signs: the mean times eight, x, y, xy, z, xz, yz, xyz. Corner `c` is
/// on the far side in x, y and z where bits 0, 1 and 2 of `c` are set. The transform is its own
/// transpose.
#[inline(always)]
pub fn transform<N: Number>(corner: [N; 8]) -> [N; 8] {
    let mut sums = corner;
    let mut next = corner;
    for pair in 0..4 {
        next[2 * pair] = sums[2 * pair] + sums[2 * pair + 1];
        next[2 * pair + 1] = sums[2 * pair + 1] - sums[2 * pair];
    }
    sums = next;
    for (a, b) in [(0, 2), (1, 3), (4, 6), (5, 7)] {
        next[a] = sums[a] + sums[b];
        next[b] = sums[b] - sums[a];
    }
    sums = next;
    for a in 0..4 {
        next[a] = sums[a] + sums[a + 4];
        next[a + 4] = sums[a + 4] - sums[a];
    }
    next
}

/// Values at the corners from coefficients of the gradients and hourglasses: the transform's
/// transpose.
#[inline(always)]
pub fn spread<N: Number>(gradients: [N; 3], hourglasses: [N; 4]) -> [N; 8] {
    let [x, y, z] = gradients;
    let [xy, xz, yz, xyz] = hourglasses;
    // Near and far in x, with the signs of y and z still to come: mean, y, z, yz.
    let zero_x = [-x, x];
    let y_x = [y - xy, y + xy];
    let z_x = [z - xz, z + xz];
    let yz_x = [yz - xyz, yz + xyz];
    let mut out = [x; 8];
    for i in 0..2 {
        let (near, far) = (zero_x[i] - y_x[i], zero_x[i] + y_x[i]);
        let (tilt_near, tilt_far) = (z_x[i] - yz_x[i], z_x[i] + yz_x[i]);
        out[i] = near - tilt_near;
        out[i + 2] = far - tilt_far;
        out[i + 4] = near + tilt_near;
        out[i + 6] = far + tilt_far;
    }
    out
}

/// Gradients and hourglasses of a vector field.
pub struct Modes<N> {
    /// Row: component; column: direction.
    pub gradient: Matrix<N>,
    /// By component: xy, xz, yz, xyz.
    pub hourglass: [[N; 4]; 3],
}

impl<N: Number> Modes<N> {
    /// Of a field at the corners, by component.
    #[inline(always)]
    pub fn of(field: [[N; 8]; 3], constants: &Constants) -> Self {
        let zero = N::zero();
        let mut modes = Self { gradient: [[zero; 3]; 3], hourglass: [[zero; 4]; 3] };
        for axis in 0..3 {
            let s = transform(field[axis]);
            for (j, sum) in [s[1], s[2], s[4]].into_iter().enumerate() {
                modes.gradient[axis][j] = sum * N::splat(constants.gradient[j]);
            }
            modes.hourglass[axis] = [s[3], s[5], s[6], s[7]];
        }
        modes
    }
}

// No closures below: a closure does not inherit the instruction set of its function.

#[inline(always)]
fn dot<N: Number>(a: [N; 3], b: [N; 3]) -> N {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

#[inline(always)]
fn column<N: Number>(m: &Matrix<N>, j: usize) -> [N; 3] {
    [m[0][j], m[1][j], m[2][j]]
}

#[inline(always)]
fn product<N: Number>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    let mut out = *a;
    for i in 0..3 {
        for j in 0..3 {
            out[i][j] = dot(a[i], column(b, j));
        }
    }
    out
}

#[inline(always)]
fn cofactor<N: Number>(f: &Matrix<N>, i: usize, j: usize) -> N {
    let (a, b) = ((i + 1) % 3, (i + 2) % 3);
    let (c, d) = ((j + 1) % 3, (j + 2) % 3);
    f[a][d].neg_mul_add(f[b][c], f[a][c] * f[b][d])
}

/// Present position of an element, and its motion in the step.
pub struct Motion<N> {
    /// Inverse of the deformation gradient.
    pub inverse: Matrix<N>,
    /// Change of volume: its determinant.
    pub volume: N,
    /// Strain of the step, xx, yy, zz, xy, yz, zx.
    pub strain: [N; 6],
    /// Rotation of the step, rad, about x, y, z.
    pub turn: [N; 3],
}

impl<N: Number> Motion<N> {
    /// From the gradient of the displacement and that of its change in the step.
    #[inline(always)]
    pub fn of(displacement: Matrix<N>, change: Matrix<N>) -> Self {
        let one = N::splat(1.0);
        let half = N::splat(0.5);
        // F = 1 + ∇u; its inverse by cofactors, its determinant by the first row.
        let mut f = displacement;
        for i in 0..3 {
            f[i][i] = f[i][i] + one;
        }
        let mut inverse = f;
        for i in 0..3 {
            for j in 0..3 {
                inverse[i][j] = cofactor(&f, j, i);
            }
        }
        let volume = dot(f[0], column(&inverse, 0));
        let over = one / volume;
        for i in 0..3 {
            for j in 0..3 {
                inverse[i][j] = inverse[i][j] * over;
            }
        }
        // Referred to the end of the step, `E = ΔF F⁻¹`; to its middle,
        // `E (1 − E/2)⁻¹ = E + E²/2 + ...`: the next term is beyond the tenth digit for the steps
        // that are stable.
        let end = product(&change, &inverse);
        let square = product(&end, &end);
        let mut m = end;
        for i in 0..3 {
            for j in 0..3 {
                m[i][j] = square[i][j].mul_add(half, end[i][j]);
            }
        }
        Self {
            inverse,
            volume,
            strain: [
                m[0][0],
                m[1][1],
                m[2][2],
                half * (m[0][1] + m[1][0]),
                half * (m[1][2] + m[2][1]),
                half * (m[2][0] + m[0][2]),
            ],
            turn: [
                half * (m[2][1] - m[1][2]),
                half * (m[0][2] - m[2][0]),
                half * (m[1][0] - m[0][1]),
            ],
        }
    }
}

/// `W τ − τ W` of a rotation about x, y, z.
#[inline(always)]
fn turning<N: Number>([x, y, z]: [N; 3], t: [N; 6]) -> [N; 6] {
    let [xx, yy, zz, xy, yz, zx] = t;
    let two = N::splat(2.0);
    [
        two * z.neg_mul_add(xy, y * zx),
        two * x.neg_mul_add(yz, z * xy),
        two * y.neg_mul_add(zx, x * yz),
        (xx - yy).mul_add(z, x.neg_mul_add(zx, y * yz)),
        (yy - zz).mul_add(x, y.neg_mul_add(xy, z * zx)),
        (zz - xx).mul_add(y, z.neg_mul_add(yz, x * xy)),
    ]
}

/// A stress that turns with the rock: the rotation's exponential to the second order.
#[inline(always)]
pub fn turned<N: Number>(turn: [N; 3], stress: [N; 6]) -> [N; 6] {
    let first = turning(turn, stress);
    let second = turning(turn, first);
    let half = N::splat(0.5);
    let mut out = stress;
    for i in 0..6 {
        out[i] = second[i].mul_add(half, first[i]) + stress[i];
    }
    out
}

/// Forces of a stress at the corners: coefficients of the gradients, by component.
#[inline(always)]
pub fn pulls<N: Number>(stress: [N; 6], inverse: Matrix<N>, constants: &Constants) -> Matrix<N> {
    let [xx, yy, zz, xy, yz, zx] = stress;
    let rows = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
    let mut out = rows;
    for i in 0..3 {
        for j in 0..3 {
            out[i][j] = dot(rows[i], inverse[j]) * N::splat(constants.pull[j]);
        }
    }
    out
}

/// Square of the length of a matrix.
#[inline(always)]
pub fn square<N: Number>(m: Matrix<N>) -> N {
    dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spreading_is_the_transpose_of_the_transform() {
        // <spread(c), u> = <c, transform(u)> for numbers at random.
        let u = [0.3, -1.2, 0.7, 2.1, -0.4, 0.9, 1.7, -2.2];
        let (g, h) = ([0.5, -0.8, 1.1], [0.2, 0.6, -0.9, 1.3]);
        let sums = transform(u);
        let there: f64 = spread(g, h).iter().zip(u).map(|(a, b)| a * b).sum();
        let [_, x, y, xy, z, xz, yz, xyz] = sums;
        let back = g[0] * x + g[1] * y + g[2] * z + h[0] * xy + h[1] * xz + h[2] * yz + h[3] * xyz;
        assert!((there - back).abs() < 1e-13, "{there} and {back}");
    }

    #[test]
    fn a_stress_turns_as_a_matrix_does() {
        // About z by a small angle: the tensor's rotation, to the third order.
        let angle: f64 = 1e-3;
        let turned = turned([0.0, 0.0, angle], [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let (sin, cos) = angle.sin_cos();
        let expected = [cos * cos, sin * sin, 0.0, sin * cos, 0.0, 0.0];
        for (got, wanted) in turned.iter().zip(expected) {
            assert!((got - wanted).abs() < 1e-9, "{turned:?} for {expected:?}");
        }
    }
}
