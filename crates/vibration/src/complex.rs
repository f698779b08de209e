//! Functions of complex numbers, made of those of real ones that are the same on every machine.

use nalgebra::Complex;

/// `|z|`.
pub(crate) fn norm(z: Complex<f64>) -> f64 {
    libm::hypot(z.re, z.im)
}

/// The angle of `z` from the real axis, between −π and π.
pub(crate) fn argument(z: Complex<f64>) -> f64 {
    libm::atan2(z.im, z.re)
}

/// The number of this norm and this angle from the real axis.
pub(crate) fn polar(norm: f64, angle_rad: f64) -> Complex<f64> {
    let (sine, cosine) = libm::sincos(angle_rad);
    Complex::new(norm * cosine, norm * sine)
}

/// `e^z`.
pub(crate) fn exp(z: Complex<f64>) -> Complex<f64> {
    polar(libm::exp(z.re), z.im)
}
