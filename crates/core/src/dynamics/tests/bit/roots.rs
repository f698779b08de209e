//! Roots of the characteristic equation of steady drilling with the regenerative law: the
//! independent answer to when it is stable.
//!
//! In the dimensionless form of Richard, Germay and Detournay (2007), time in `√(I/C)` and depth in
//! `2C/(ε a²)`, small deviations `u`, `φ` from steady drilling follow
//!
//! ```text
//! u″          = nψ (−(u − ũ) + r (φ − φ̃))
//! φ″ + κφ′ + φ = n  (−(u − ũ) + r (φ − φ̃))      r = v₀/ω₀
//! ```
//!
//! with the delay `2π/(n ω₀)` under the tilde. The wear flats' part is constant while the bit goes
//! down.

use nalgebra::{Complex, ComplexField};

type Number = Complex<f64>;

/// Steady drilling.
#[derive(Clone, Copy)]
pub(super) struct Drilling {
    pub(super) blades: f64,
    /// `ψ = ζ ε a I/(M C)`.
    pub(super) psi: f64,
    /// Torsional damping `κ`.
    pub(super) damping: f64,
    /// Depth of cut per radian `v₀/ω₀`.
    pub(super) pitch: f64,
    /// Rotary speed `ω₀`.
    pub(super) speed: f64,
}

impl Drilling {
    /// `(s² + nψE)(s² + κs + 1 − nrE) + n²ψrE²`, `E = 1 − e^(−sτ)`, by `s`: a shift of the angle
    /// and of the depth along the helix is no motion.
    fn characteristic(&self, s: Number) -> Number {
        let delay = std::f64::consts::TAU / (self.blades * self.speed);
        let e = Number::new(1.0, 0.0) - (-s * delay).exp();
        let cut = e * self.blades;
        let torsion = s * s + s * self.damping + 1.0;
        ((s * s + cut * self.psi) * (torsion - cut * self.pitch)
            + cut * cut * (self.psi * self.pitch))
            / s
    }

    /// Growth rate and frequency of the mode that grows most: Newton's method from all over the
    /// plane.
    pub(super) fn leading(&self) -> Number {
        let mut leading = Number::new(f64::NEG_INFINITY, 0.0);
        for re in -12..=6 {
            for im in 0..160 {
                let start = Number::new(0.25 * f64::from(re), 0.011 + 0.25 * f64::from(im));
                if let Some(root) = self.newton(start)
                    && root.re > leading.re
                {
                    leading = root;
                }
            }
        }
        leading
    }

    fn newton(&self, mut s: Number) -> Option<Number> {
        for _ in 0..60 {
            let h = 1e-6;
            let f = self.characteristic(s);
            let slope = (self.characteristic(s + h) - self.characteristic(s - h)) / (2.0 * h);
            let step = f / slope;
            s -= step;
            if s.modulus().is_nan() || s.modulus() > 100.0 {
                return None;
            }
            if step.modulus() < 1e-12 {
                // Zero itself is a root of the undivided equation only.
                return (s.modulus() > 1e-6).then_some(s);
            }
        }
        None
    }

    /// The speed above which steady drilling is stable, by bisection between one where it is not
    /// and one where it is.
    pub(super) fn threshold(self, mut low: f64, mut high: f64) -> f64 {
        let growth = |speed: f64| Self { speed, ..self }.leading().re;
        assert!(growth(low) > 0.0 && growth(high) < 0.0);
        for _ in 0..20 {
            let middle = 0.5 * (low + high);
            if growth(middle) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }
}

/// Without torsion and damping, `s² + nψ(1 − e^(−sτ)) = 0` first grows at `s = iπ/τ`, where the
/// delay is half a period: `ω₀ = 2 √(2ψ/n)`.
#[test]
fn the_root_finder_knows_the_axial_threshold() {
    let drilling = Drilling {
        blades: 4.0,
        psi: 14.0,
        // No coupling; its own torsion dies.
        damping: 0.5,
        pitch: 0.0,
        speed: 0.0,
    };
    let exact = 2.0 * (2.0 * drilling.psi / drilling.blades).sqrt();
    let found = drilling.threshold(0.8 * exact, 1.2 * exact);
    assert!((found / exact - 1.0).abs() < 1e-5, "{found} {exact}");
}
