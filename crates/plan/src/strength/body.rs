//! The tube of a component, as worn as its class.

use wholestring::string::{BodySection, Component};

use super::{PipeClass, Tube, collapse::Collapse};

/// The body of a component, whose yield strength is known.
#[derive(Debug, Clone)]
pub struct Body {
    /// What is left of it: the outside worn evenly.
    left: Component,
    nominal: Tube,
    class: PipeClass,
    /// Second moment of area of what is left over that of the component.
    stiffness_left: f64,
}

impl Body {
    /// The body of a component; `None` where the yield strength is not known.
    pub fn of(component: &Component, class: PipeClass) -> Option<Self> {
        let yield_strength_Pa = component.yield_strength_Pa?;
        let wall_m = 0.5 * (component.od_m - component.id_m);
        let mut left = component.clone();
        left.od_m = component.id_m + 2.0 * class.wall_left() * wall_m;
        let nominal = Tube { od_m: component.od_m, id_m: component.id_m, yield_strength_Pa };
        let stiffness_left = left.second_moment_m4() / component.second_moment_m4();
        Some(Self { left, nominal, class, stiffness_left })
    }

    /// What is left of the component.
    pub fn left(&self) -> &Component {
        &self.left
    }

    /// Minimum yield strength, Pa.
    pub fn yield_strength_Pa(&self) -> f64 {
        self.nominal.yield_strength_Pa
    }

    /// Tension at which it yields, N: `P₀ = A Y` (API RP 7G).
    pub fn tensile_yield_N(&self) -> f64 {
        self.left.area_m2() * self.yield_strength_Pa()
    }

    /// Torque at which it yields without tension, N·m (API RP 7G).
    pub fn torsional_yield_N_m(&self) -> f64 {
        self.left.torsional_yield_N_m().unwrap_or(f64::INFINITY)
    }

    /// Torque at which it yields under a tension, N·m (API RP 7G):
    ///
    /// ```text
    /// Q_T = 0.096167 J/D √(Y² − (P/A)²)          in, psi, ft·lbf
    /// ```
    ///
    /// nothing beyond the tensile yield. A compression counts as a tension.
    pub fn torsional_yield_under_N_m(&self, tension_N: f64) -> f64 {
        let part = tension_N / self.tensile_yield_N();
        self.torsional_yield_N_m() * (1.0 - part * part).max(0.0).sqrt()
    }

    /// The section for stresses of what is left.
    pub fn section(&self) -> BodySection {
        BodySection::of(&self.left)
    }

    /// The bending moment that bends what is left to the curvature to which this one bends the whole
    /// body, N·m: the hole gives the curvature.
    pub fn bending_left_N_m(&self, bending_N_m: f64) -> f64 {
        bending_N_m * self.stiffness_left
    }

    /// Pressure inside over that outside at which it yields, Pa: new `0.875 · 2 Y t/D`, used with the
    /// wall that is left and the nominal diameter (API RP 7G).
    pub fn burst_Pa(&self) -> f64 {
        match self.class {
            PipeClass::New => self.nominal.burst_Pa(),
            worn => self.nominal.barlow_Pa(worn.wall_left() * self.nominal.wall_m()),
        }
    }

    /// Pressure outside over that inside at which it collapses under an effective tension, N
    /// (API RP 7G, API TR 5C3; the outside worn evenly). `σ_a + p_i` is the effective tension over
    /// the metal's area, less `(p_o − p_i) A_o/A`, what the pressure outside presses on the end: it
    /// is left out, to the safe side.
    pub fn collapse(&self, effective_tension_N: f64) -> Collapse {
        let Component { od_m, id_m, .. } = self.left;
        Tube { od_m, id_m, ..self.nominal }.collapse(effective_tension_N / self.left.area_m2())
    }
}
