//! Rotary shouldered connections.

use std::f64::consts::{FRAC_PI_4, PI};

/// The dimensions of a rotary shouldered connection that its torque needs (API RP 7G, appendix A.9;
/// dimensions in API Spec 7-2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotaryShoulder {
    /// Outside diameter of the box, m.
    pub od_m: f64,
    /// Inside diameter of the pin, m.
    pub id_m: f64,
    /// Diameter of the box's counterbore `Q_c`, m.
    pub counterbore_m: f64,
    /// Pitch diameter of the thread at the gauge point `C`, m.
    pub pitch_diameter_m: f64,
    /// Length of the pin `L_pc`, m.
    pub pin_length_m: f64,
    /// Lead of the thread, m.
    pub lead_m: f64,
    /// Taper on the diameter, m/m: 1/6 of 2 in/ft.
    pub taper: f64,
    /// Height of the thread before truncation `H`, m.
    pub thread_height_m: f64,
    /// Truncation of the root `S_rs`, m.
    pub root_truncation_m: f64,
    /// Half of the thread's angle, rad.
    pub half_angle_rad: f64,
}

/// Depth in the box and in the pin at which their sections are taken, and what of the pin has no
/// thread, m: 3/8, 1/8 and 5/8 in.
const BOX_AT_M: f64 = 0.375 * 0.0254;
const PIN_AT_M: f64 = 0.125 * 0.0254;
const NO_THREAD_M: f64 = 0.625 * 0.0254;

impl RotaryShoulder {
    /// Coefficient of friction of a thread compound with metallic zinc, on which the tables of API RP 7G
    /// rest.
    pub const FRICTION: f64 = 0.08;

    /// Area of the box 3/8 in from its shoulder, `A_b = π/4 (D² − (Q_c − E)²)`, m².
    pub fn box_area_m2(&self) -> f64 {
        let bore_m = self.counterbore_m - self.taper * BOX_AT_M;
        FRAC_PI_4 * (self.od_m.powi(2) - bore_m.powi(2))
    }

    /// Area of a pin without relief groove, `A_p = π/4 ((C − B)² − d²)`, m².
    pub fn pin_area_m2(&self) -> f64 {
        let root_m =
            2.0 * (0.5 * self.thread_height_m - self.root_truncation_m) + self.taper * PIN_AT_M;
        FRAC_PI_4 * ((self.pitch_diameter_m - root_m).powi(2) - self.id_m.powi(2))
    }

    /// Torque that puts a stress, Pa, on the smaller of box and pin, N·m:
    ///
    /// ```text
    /// T = S A (p/2π + R_t f/cos θ + R_s f)
    /// ```
    ///
    /// With the recommended stress it is the make-up torque, with the yield strength the torque at
    /// which the connection yields.
    pub fn torque_N_m(&self, stress_Pa: f64, friction: f64) -> f64 {
        let shoulder_m = 0.25 * (self.od_m + self.counterbore_m);
        let narrow_m = self.pitch_diameter_m - (self.pin_length_m - NO_THREAD_M) * self.taper;
        let thread_m = 0.25 * (self.pitch_diameter_m + narrow_m);
        let arm_m = self.lead_m / (2.0 * PI)
            + thread_m * friction / self.half_angle_rad.cos()
            + shoulder_m * friction;
        stress_Pa * self.box_area_m2().min(self.pin_area_m2()) * arm_m
    }
}
