//! Vectors of [`Number`]s.

use std::ops::{Add, Neg, Sub};

use super::number::Number;

/// A vector: north, east, down.
#[derive(Debug, Clone, Copy, serde::Serialize, serde::Deserialize)]
pub struct Vector<N>(pub N, pub N, pub N);

impl<N: Number> Vector<N> {
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self(N::zero(), N::zero(), N::zero())
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> N {
        self.2.mul_add(o.2, self.1.mul_add(o.1, self.0 * o.0))
    }
    /// Vector product `self × o`.
    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        Self(
            self.2.neg_mul_add(o.1, self.1 * o.2),
            self.0.neg_mul_add(o.2, self.2 * o.0),
            self.1.neg_mul_add(o.0, self.0 * o.1),
        )
    }
    /// `self × o + term`.
    #[inline(always)]
    pub fn cross_plus(self, o: Self, term: Self) -> Self {
        Self(
            self.2.neg_mul_add(o.1, self.1.mul_add(o.2, term.0)),
            self.0.neg_mul_add(o.2, self.2.mul_add(o.0, term.1)),
            self.1.neg_mul_add(o.0, self.0.mul_add(o.1, term.2)),
        )
    }
    /// `self * factor`.
    #[inline(always)]
    pub fn scaled(self, factor: N) -> Self {
        Self(self.0 * factor, self.1 * factor, self.2 * factor)
    }
    /// `self + direction * factor`.
    #[inline(always)]
    pub fn plus(self, direction: Self, factor: N) -> Self {
        Self(
            direction.0.mul_add(factor, self.0),
            direction.1.mul_add(factor, self.1),
            direction.2.mul_add(factor, self.2),
        )
    }
    /// `self - direction * factor`.
    #[inline(always)]
    pub fn minus(self, direction: Self, factor: N) -> Self {
        Self(
            direction.0.neg_mul_add(factor, self.0),
            direction.1.neg_mul_add(factor, self.1),
            direction.2.neg_mul_add(factor, self.2),
        )
    }
}

impl<N: Number> Add for Vector<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self(self.0 + o.0, self.1 + o.1, self.2 + o.2)
    }
}
impl<N: Number> Sub for Vector<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self(self.0 - o.0, self.1 - o.1, self.2 - o.2)
    }
}
impl<N: Number> Neg for Vector<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1, -self.2)
    }
}

impl From<nalgebra::Vector3<f64>> for Vector<f64> {
    fn from(v: nalgebra::Vector3<f64>) -> Self {
        Self(v.x, v.y, v.z)
    }
}
impl From<Vector<f64>> for nalgebra::Vector3<f64> {
    fn from(v: Vector<f64>) -> Self {
        Self::new(v.0, v.1, v.2)
    }
}
