//! The tube of a component, new or used.

use wholestring::string::{BodySection, Component};

use super::{Tube, tube::Collapse};

/// The body of a component whose yield strength is known. For used pipe the outside diameter is the
/// remaining one ([`Component::class`]).
#[derive(Debug, Clone, Copy)]
pub struct Body<'a> {
    component: &'a Component,
    section: BodySection,
    tensile_yield_N: f64,
    torsional_yield_N_m: f64,
    tube: Tube,
}

impl<'a> Body<'a> {
    /// The body of a component; `None` where the yield strength is not known.
    pub fn of(component: &'a Component) -> Option<Self> {
        let Component { od_m, id_m, .. } = *component;
        Some(Self {
            component,
            section: BodySection::of(component),
            tensile_yield_N: component.tensile_yield_N()?,
            torsional_yield_N_m: component.torsional_yield_N_m()?,
            tube: Tube { od_m, id_m, yield_strength_Pa: component.yield_strength_Pa? },
        })
    }

    /// The component.
    pub fn component(&self) -> &'a Component {
        self.component
    }

    /// Its section, for stresses.
    pub fn section(&self) -> &BodySection {
        &self.section
    }

    /// Minimum yield strength, Pa.
    pub fn yield_strength_Pa(&self) -> f64 {
        self.tube.yield_strength_Pa
    }

    /// Tension at which it yields, N: `P₀ = A Y` (API RP 7G).
    pub fn tensile_yield_N(&self) -> f64 {
        self.tensile_yield_N
    }

    /// Torque at which it yields without tension, N·m (API RP 7G).
    pub fn torsional_yield_N_m(&self) -> f64 {
        self.torsional_yield_N_m
    }

    /// Torque at which it yields under a tension `P`, N·m (API RP 7G), with the area `A`, the polar
    /// moment `J`, the diameter `D` and the yield strength `Y`:
    ///
    #[doc = include_str!("../../equations/torsional-yield-under-tension.html")]
    /// and zero beyond the tensile yield. A compression counts as a tension.
    pub fn torsional_yield_under_N_m(&self, tension_N: f64) -> f64 {
        let part = tension_N / self.tensile_yield_N;
        self.torsional_yield_N_m * (1.0 - part * part).max(0.0).sqrt()
    }

    /// Pressure inside over that outside at which it yields, Pa: new `0.875 · 2 Y t/D`, used with
    /// the remaining wall and the nominal diameter (API RP 7G).
    pub fn burst_Pa(&self) -> f64 {
        let class = self.component.class;
        if class.is_new() {
            return self.tube.burst_Pa();
        }
        let nominal_od_m = self.tube.id_m + 2.0 * self.tube.wall_m() / class.wall_left();
        Tube { od_m: nominal_od_m, ..self.tube }.barlow_Pa(self.tube.wall_m())
    }

    /// Pressure outside over that inside at which it collapses under an effective tension, N (API
    /// RP 7G, API TR 5C3; used pipe worn evenly on the outside). `σ_a + p_i` is the effective
    /// tension over the metal's area, less `(p_o − p_i) A_o/A` for the pressure outside on the end,
    /// which is left out on the safe side.
    pub fn collapse(&self, effective_tension_N: f64) -> Collapse {
        self.tube.collapse(effective_tension_N / self.component.area_m2())
    }
}

// Margin of overpull.

/// Part of the tensile yield that is allowed by default (API RP 7G: customary).
pub const ALLOWED_PART_OF_YIELD: f64 = 0.9;

/// Margin of overpull, N, `α P₀ − T` (API RP 7G): the capacity of a section of the string, a part
/// `α` of its tensile yield, beyond its present tension.
pub fn margin_of_overpull_N(tensile_yield_N: f64, allowed_part: f64, tension_N: f64) -> f64 {
    allowed_part * tensile_yield_N - tension_N
}
