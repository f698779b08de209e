//! Drive at the top of the string: a constant speed, or a drive with inertia under a controller.
//!
//! ```text
//! J Ω' = T − T_s
//! T = K_p (Ω_r − Ω) + K_i ∫ (Ω_r − Ω) dt        |T| at most the limit
//! Ω_r = Ω_set − H T_s / Z                        H = s/(s + ω₁), with Z-Torque alone
//! ```
//!
//! (Jansen and van den Steen 1995; Kyllingstad and Nessjøen 2009; Dwars 2015.) Theory:
//! `docs/src/theory/top-side.md`.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use crate::{
    damage::{Damaged, ensure},
    dynamics::{
        boundary::{extension::AnotherExtension, top_drive_controller::CustomDrive},
        kernel::chain::{Chain, element, node},
        settings::{SpeedController, TopDriveSettings},
    },
    rod::{mesh::Mesh, torsion},
    simd::number::Real,
};

/// Lower edge of Z-Torque's band where none is given, as a part of the string's own frequency.
const BAND_BELOW_STRING: f64 = 0.2;

/// The string in torsion, as a drive at its top is tuned to.
#[derive(Debug, Clone, Copy)]
pub struct TorsionalString {
    /// Characteristic torsional impedance of the uppermost pipe, N·m·s.
    pub impedance_N_m_s: f64,
    /// Lowest torsional frequency of the string, held at the top and free at the bit, Hz.
    pub frequency_Hz: f64,
}

/// Gains of a controller that is tuned.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Gains {
    /// `K_p`, N·m·s.
    pub proportional_N_m_s: f64,
    /// `K_i`, N·m.
    pub integral_N_m: f64,
    /// The impedance to show, where the controller listens to the string's torque.
    pub shown: Option<Shown>,
}

/// An impedance that a drive shows by giving way to the string's torque.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Shown {
    /// `Z`, N·m·s.
    pub impedance_N_m_s: f64,
    /// `ω₁`, rad/s: slower variations are left to the speed control.
    pub corner_rad_per_s: f64,
}

impl TorsionalString {
    /// The string of a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        Self {
            impedance_N_m_s: torsion::impedance_N_m_s(&mesh.elements[0].section),
            frequency_Hz: torsion::lowest_frequency_Hz(mesh),
        }
    }
}

impl Gains {
    /// The gains of `controller` for a drive of `inertia_kg_m2` on `string`.
    pub fn of(controller: SpeedController, inertia_kg_m2: f64, string: TorsionalString) -> Self {
        match controller {
            SpeedController::Pi { proportional_N_m_s, integral_N_m } => {
                Self { proportional_N_m_s, integral_N_m, shown: None }
            }
            SpeedController::SoftTorque { impedance_ratio, frequency_Hz } => {
                let omega = TAU * frequency_Hz.unwrap_or(string.frequency_Hz);
                Self {
                    proportional_N_m_s: impedance_ratio * string.impedance_N_m_s,
                    // Inertia and integral part cancel there.
                    integral_N_m: inertia_kg_m2 * omega * omega,
                    shown: None,
                }
            }
            SpeedController::ZTorque {
                impedance_ratio,
                frequency_Hz,
                proportional_N_m_s,
                integral_N_m,
            } => Self {
                proportional_N_m_s,
                integral_N_m,
                shown: Some(Shown {
                    impedance_N_m_s: impedance_ratio * string.impedance_N_m_s,
                    corner_rad_per_s: TAU
                        * frequency_Hz.unwrap_or(BAND_BELOW_STRING * string.frequency_Hz),
                }),
            },
        }
    }
}

/// The top drive in time.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct TopDrive {
    drive: Kind,
    stalled: bool,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
enum Kind {
    /// It follows its set point whatever that takes.
    Constant,
    /// A drive with inertia whose controller has gains.
    Tuned(Drive),
    /// A drive with inertia under a controller of the caller's own.
    Custom(CustomDrive),
}

#[derive(Debug, Clone, Serialize, Deserialize)]
struct Drive {
    gains: Gains,
    /// Moment of inertia of the half element above the string's first torque, kg·m².
    half_kg_m2: f64,
    limit_N_m: f64,
    /// Torque of the integral part, N·m.
    integral_N_m: f64,
    /// Slowly varying part of the string's torque, N·m.
    slow_N_m: f64,
}

/// Results of a step for the drive.
#[derive(Debug, Clone, Copy, Default)]
pub struct TopDriveStep {
    /// Torque between drive and string, N·m: the surface torque.
    pub string_torque_N_m: f64,
    /// Work done on the string and on the drive's inertia, J.
    pub work_J: f64,
}

impl TopDrive {
    /// The drive of `settings` on the top of `chain`, which gets its inertia.
    pub fn new(
        settings: &TopDriveSettings,
        string: TorsionalString,
        chain: &mut Chain<impl Real>,
    ) -> Self {
        let half_kg_m2 = node!(chain, 0, polar);
        // At the start the string is held: the drive supplies its torque.
        let torque = -element!(chain, 0, torsion) * element!(chain, 0, twist);
        let drive = match *settings {
            TopDriveSettings::Constant => Kind::Constant,
            TopDriveSettings::Driven { inertia_kg_m2, controller, torque_limit_N_m } => {
                node!(chain, 0, polar += inertia_kg_m2);
                let limit_N_m = torque_limit_N_m.unwrap_or(f64::INFINITY);
                Kind::Tuned(Drive {
                    gains: Gains::of(controller, inertia_kg_m2, string),
                    half_kg_m2,
                    limit_N_m,
                    integral_N_m: torque.clamp(-limit_N_m, limit_N_m),
                    slow_N_m: torque,
                })
            }
            TopDriveSettings::Custom(ref custom) => {
                node!(chain, 0, polar += custom.inertia_kg_m2);
                Kind::Custom(CustomDrive::new(custom, torque))
            }
        };
        Self { drive, stalled: false }
    }

    /// Gives a drive that has been read back the controller of these settings, where that is the
    /// caller's.
    pub(in crate::dynamics) fn attach(
        &mut self,
        settings: &TopDriveSettings,
    ) -> Result<(), AnotherExtension> {
        match (&mut self.drive, settings) {
            (Kind::Custom(drive), TopDriveSettings::Custom(custom)) => drive.attach(custom),
            _ => Ok(()),
        }
    }

    /// Whether a stored drive is one of these settings.
    pub(in crate::dynamics) fn check(&self, settings: &TopDriveSettings) -> Result<(), Damaged> {
        let fits = matches!(
            (&self.drive, settings),
            (Kind::Constant, TopDriveSettings::Constant)
                | (Kind::Tuned(_), TopDriveSettings::Driven { .. })
                | (Kind::Custom(_), TopDriveSettings::Custom(_))
        );
        ensure(fits, "the top drive")
    }

    /// Replaces the gains of a drive that has gains. The integral part compensates the change of
    /// the proportional part, so that the torque is continuous.
    pub fn change(&mut self, gains: Gains, chain: &Chain<impl Real>, set_rad_per_s: f64) {
        let Kind::Tuned(drive) = &mut self.drive else { return };
        let string = -element!(chain, 0, torsion) * element!(chain, 0, twist);
        let missing = |gains: &Gains, slow_N_m: f64| {
            let feedback =
                gains.shown.map_or(0.0, |shown| (string - slow_N_m) / shown.impedance_N_m_s);
            set_rad_per_s - feedback - node!(chain, 0, spin)
        };
        let before = drive.gains.proportional_N_m_s * missing(&drive.gains, drive.slow_N_m);
        if drive.gains.shown.is_none() {
            // The filter of the string's torque starts at this value.
            drive.slow_N_m = string;
        }
        let after = gains.proportional_N_m_s * missing(&gains, drive.slow_N_m);
        drive.integral_N_m += before - after;
        drive.gains = gains;
    }

    /// Whether the last step required more torque than the drive can supply.
    pub fn is_stalled(&self) -> bool {
        self.stalled
    }

    /// Spin of the rigid motion that the string is to have at this set point, rad/s: a drive at its
    /// limit does not reach it.
    pub fn rigid_spin(&self, chain: &Chain<impl Real>, set_rad_per_s: f64) -> f64 {
        if self.stalled { node!(chain, 0, spin) } else { set_rad_per_s }
    }

    /// Before the step: a prescribed spin.
    pub fn prescribe(&self, chain: &mut Chain<impl Real>, set_rad_per_s: f64) {
        if let Kind::Constant = self.drive {
            node!(chain, 0, spin = set_rad_per_s);
        }
    }

    /// Turns the top after the step, which has left its spin alone: by the torque of the uppermost
    /// element as the step had it, and by the drive's own at the step's end, stable for any gain.
    pub fn act(
        &mut self,
        chain: &mut Chain<impl Real>,
        set_rad_per_s: f64,
        dt: f64,
    ) -> TopDriveStep {
        let string = -element!(chain, 0, torque);
        let before = node!(chain, 0, spin);
        let inertia = node!(chain, 0, polar);
        let drive = match &mut self.drive {
            Kind::Constant => {
                return TopDriveStep { string_torque_N_m: string, work_J: string * before * dt };
            }
            Kind::Custom(drive) => {
                let (torque, stalled) = drive.torque_N_m(set_rad_per_s, before, string, dt);
                self.stalled = stalled;
                let after = before + dt * (torque - string) / inertia;
                node!(chain, 0, spin = after);
                return TopDriveStep {
                    string_torque_N_m: string,
                    work_J: torque * 0.5 * (before + after) * dt,
                };
            }
            Kind::Tuned(drive) => drive,
        };
        let Gains { proportional_N_m_s, integral_N_m, shown } = drive.gains;
        // K_p + K_i dt: the integral of the step counts at its end.
        let gain = libm::fma(integral_N_m, dt, proportional_N_m_s);
        // The string's torque at the step's end, `M = string + k (Ω − Ω_below) dt + J_½ Ω'`, is
        // `fixed + stiff Ω`; the feedback is a fraction of it less its slow part.
        let wind = element!(chain, 0, torsion) * dt;
        let start = drive.half_kg_m2 / dt;
        let fixed = string - wind * node!(chain, 1, spin) - start * before;
        let stiff = wind + start;
        // H = s/(s + ω₁): the part below ω₁ follows slowly, the rest over Z lowers the reference.
        let (slow, feedback) = shown.map_or((0.0, 0.0), |s| {
            let slow = s.corner_rad_per_s * dt / libm::fma(s.corner_rad_per_s, dt, 1.0);
            (slow, (1.0 - slow) / s.impedance_N_m_s)
        });
        let reference = set_rad_per_s - feedback * (fixed - drive.slow_N_m);
        let slope = libm::fma(feedback, stiff, 1.0);
        let per_dt = inertia / dt;
        // J (Ω − Ω₀)/dt = K (Ω_r − Ω) + integral − string, where Ω_r depends on Ω, solved for Ω.
        let mut after = (per_dt * before + gain * reference + drive.integral_N_m - string)
            / libm::fma(gain, slope, per_dt);
        // Ω_r − Ω at the step's end.
        let missing = reference - slope * after;
        let mut torque = gain * missing + drive.integral_N_m;
        self.stalled = torque.abs() > drive.limit_N_m;
        if self.stalled {
            // The integral waits until the drive is able again.
            torque = torque.clamp(-drive.limit_N_m, drive.limit_N_m);
            after = before + (torque - string) / per_dt;
        } else {
            drive.integral_N_m += integral_N_m * dt * missing;
        }
        drive.slow_N_m += slow * (libm::fma(stiff, after, fixed) - drive.slow_N_m);
        node!(chain, 0, spin = after);
        TopDriveStep { string_torque_N_m: string, work_J: torque * 0.5 * (before + after) * dt }
    }
}
