//! Rotary shouldered connections: make-up torque and yield loads.

use std::f64::consts::{FRAC_PI_4, PI};

use serde::Serialize;

/// Friction of threads and shoulder with the compounds of API RP 7A1, for which API RP 7G's torques
/// are.
const COMPOUND_FRICTION: f64 = 0.08;
/// Cosine of half the included angle of the thread, 30°: all forms here have flanks at 60°.
const COS_FLANK: f64 = 0.866_025_403_784_438_6;
/// Distance from the shoulder to the gauge point, at which the pitch diameter is measured, m.
const GAUGE_POINT_M: f64 = 0.625 * 0.0254;
/// Distance of the pin's critical section from the gauge point towards the shoulder, m. (The pin's
/// thread is measured 3/4 in from its shoulder, where the taper has reduced it by that of 1/8 in.)
const PIN_SECTION_M: f64 = 0.125 * 0.0254;
/// Distance from the box's shoulder to its critical section, m.
const BOX_SECTION_M: f64 = 0.375 * 0.0254;

/// Strength of a component's connections; `None` for unknown values.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct ConnectionStrength {
    /// Torque that they are made up with, N·m: a string that turns with more makes them up further.
    pub make_up_torque_N_m: Option<f64>,
    /// Torque at which pin or box yields, N·m.
    pub torsional_yield_N_m: Option<f64>,
    /// Tension at which the pin yields, N, without the effect of making up.
    pub tensile_yield_N: Option<f64>,
}

impl ConnectionStrength {
    /// Whether nothing is known.
    pub(crate) fn is_unknown(&self) -> bool {
        *self == Self::default()
    }
}

/// Which part of the shoulder carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shoulder {
    /// All of it, as API RP 7G's tables of tool joints have it.
    Whole,
    /// No more of it than where the box would be as strong as the pin, as its tables of drill
    /// collars have it.
    Balanced,
}

/// Dimensions of a connection's thread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotaryConnection {
    /// Name: `NC50`, `5-1/2 FH`.
    pub name: &'static str,
    /// Pitch diameter at the gauge point, `C`, m.
    pub pitch_diameter_m: f64,
    /// Taper on the diameter, m/m.
    pub taper: f64,
    /// Lead of the thread, `p`, m.
    pub lead_m: f64,
    /// Height of the thread, not truncated, `H`, m.
    pub thread_height_m: f64,
    /// Truncation of its root, `S`, m.
    pub root_truncation_m: f64,
    /// Length of the pin, `L`, m.
    pub pin_length_m: f64,
    /// Diameter of the box's counterbore, `Q`, m.
    pub counterbore_m: f64,
}

impl RotaryConnection {
    /// Section of the pin 3/4 in from its shoulder, m²: `π/4 [(C − B)² − d²]` with
    /// `B = 2 (H/2 − S) + taper · 1/8 in`.
    pub fn pin_area_m2(&self, id_m: f64) -> f64 {
        let root_m = self.pitch_diameter_m
            - 2.0 * (0.5 * self.thread_height_m - self.root_truncation_m)
            - self.taper * PIN_SECTION_M;
        FRAC_PI_4 * (root_m * root_m - id_m * id_m).max(0.0)
    }

    /// Section of the box 3/8 in from its shoulder, m²: `π/4 [D² − (Q − taper · 3/8 in)²]`.
    pub fn box_area_m2(&self, od_m: f64) -> f64 {
        let bore_m = self.box_bore_m();
        FRAC_PI_4 * (od_m * od_m - bore_m * bore_m).max(0.0)
    }

    fn box_bore_m(&self) -> f64 {
        self.counterbore_m - self.taper * BOX_SECTION_M
    }

    /// Torque that stresses the weaker of pin and box to `stress_Pa`, N·m, after Farr as API RP 7G
    /// (16th edition, A.9) has it, with `S` the stress, `A` the lesser area of pin and box, `p` the
    /// lead, `t` the taper, `f = 0.08`, `θ = 30°` and `D` the outside diameter of the box:
    ///
    #[doc = include_str!("../../equations/connection-torque.html")]
    ///
    /// At the yield strength it is the torsional yield, at 60 % of it the make-up torque of tool
    /// joints, at 62 500 psi (430.9 MPa) that of drill collars.
    pub fn torque_N_m(&self, od_m: f64, id_m: f64, stress_Pa: f64, shoulder: Shoulder) -> f64 {
        let (pin_m2, box_m2) = (self.pin_area_m2(id_m), self.box_area_m2(od_m));
        let shoulder_od_m = match shoulder {
            Shoulder::Whole => od_m,
            Shoulder::Balanced => od_m.min((pin_m2 / FRAC_PI_4 + self.box_bore_m().powi(2)).sqrt()),
        };
        let narrow_m = (self.pin_length_m - GAUGE_POINT_M) * self.taper;
        let thread_m = (2.0 * self.pitch_diameter_m - narrow_m) / 4.0;
        let shoulder_m = (shoulder_od_m + self.counterbore_m) / 4.0;
        let lever_m =
            self.lead_m / (2.0 * PI) + COMPOUND_FRICTION * (thread_m / COS_FLANK + shoulder_m);
        stress_Pa * pin_m2.min(box_m2) * lever_m
    }
}
