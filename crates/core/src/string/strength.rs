//! Stresses in the metal of a component's body.

use super::Component;
use crate::simd::number::Number;

/// The section of a body, as its stresses need it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodySection<N = f64> {
    /// Inverse of the metal's area, 1/m².
    pub per_area_m2: N,
    /// Inverse of the section modulus `I/(D/2)`, 1/m³.
    pub per_modulus_m3: N,
    /// Inner over outer diameter.
    pub bore_part: N,
    /// Area of the bore over that of the metal.
    pub bore_per_area: N,
}

impl BodySection {
    /// The section of a component's body; tool joints, upsets and blades are not counted.
    pub fn of(component: &Component) -> Self {
        Self {
            per_area_m2: 1.0 / component.area_m2(),
            per_modulus_m3: 1.0 / component.section_modulus_m3(),
            bore_part: component.id_m / component.od_m,
            bore_per_area: component.inner_area_m2() / component.area_m2(),
        }
    }
}

impl<N: Number> BodySection<N> {
    /// Von Mises stress, Pa, on the outside of the bend, at the outer or the inner surface,
    /// whichever is greater, of a body that carries an effective tension `T`, N, a bending moment
    /// `M` and a torque `M_t`, N·m. `burst_square_Pa2` is the square of the pressure inside less
    /// that outside, Pa².
    ///
    #[doc = include_str!("../../equations/von-mises.html")]
    ///
    /// with `σ_b = M D/2I` and `τ = M_t D/4I` outside, the part `d/D` of both inside (Lamé).
    /// Theory: `docs/src/theory/strength.md`.
    #[inline(always)]
    pub fn von_mises_Pa(
        &self,
        tension_N: N,
        bending_N_m: N,
        torque_N_m: N,
        burst_square_Pa2: N,
    ) -> N {
        let one = N::splat(1.0);
        let pulled = tension_N.max(-tension_N) * self.per_area_m2;
        let bent = bending_N_m * self.per_modulus_m3;
        let sheared = N::splat(0.5) * torque_N_m * self.per_modulus_m3;
        let (part, bore) = (self.bore_part, self.bore_per_area);
        let outer = stress_square(pulled + bent, sheared, bore, burst_square_Pa2);
        let inner =
            stress_square(pulled + part * bent, part * sheared, one + bore, burst_square_Pa2);
        inner.max(outer).sqrt()
    }
}

/// Square of the von Mises stress of a normal stress, a shear stress and that of a pressure.
#[inline(always)]
fn stress_square<N: Number>(normal_Pa: N, shear_Pa: N, area: N, burst_square_Pa2: N) -> N {
    normal_Pa * normal_Pa + N::splat(3.0) * (shear_Pa * shear_Pa + area * area * burst_square_Pa2)
}

impl Component {
    /// Section modulus of the body, `I/(D/2)`, m³.
    pub fn section_modulus_m3(&self) -> f64 {
        self.second_moment_m4() / (0.5 * self.od_m)
    }

    /// Force in the metal, N, `T + p_i A_i − p_o A_o + ρ Q²/A_i`: effective tension `T`, the forces
    /// of the mud's pressures outside and inside on the metal, and the momentum of the stream in
    /// the bore. `stream_N_m2` is `ρ Q²`, N·m²; without a bore there is no stream.
    pub fn true_tension_N(
        &self,
        effective_N: f64,
        outside_Pa: f64,
        inside_Pa: f64,
        stream_N_m2: f64,
    ) -> f64 {
        let bore_m2 = self.inner_area_m2();
        let stream_N = if bore_m2 > 0.0 { stream_N_m2 / bore_m2 } else { 0.0 };
        // `p_o A_o − p_i A_i`: nothing is left of digits that cancel where the pressures are the
        // same.
        let pressed_N = outside_Pa * self.area_m2() + (outside_Pa - inside_Pa) * bore_m2;
        effective_N - pressed_N + stream_N
    }
}
