//! `[top_drive]`.

use wholestring::dynamics::{SpeedController, TopDriveSettings};
use wholestring_config::prelude::*;

/// The controls, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Control {
    Constant,
    Pi,
    SoftTorque,
    ZTorque,
}

const WORDS: &[(&str, Control)] = &[
    ("constant", Control::Constant),
    (PI, Control::Pi),
    (SOFT_TORQUE, Control::SoftTorque),
    (Z_TORQUE, Control::ZTorque),
];

const PI: &str = "pi";
const SOFT_TORQUE: &str = "soft-torque";
const Z_TORQUE: &str = "z-torque";

/// Default impedance over the pipe's: SoftTorque reflects 0.6 of a wave of its frequency and keeps
/// its speed; Z-Torque matches the pipe.
const SOFT_RATIO: f64 = 4.0;
const MATCHED_RATIO: f64 = 1.0;

/// Default gains, N·m·s and N·m: a stiff drive.
const PROPORTIONAL_N_M_S: f64 = 38e3;
const INTEGRAL_N_M: f64 = 100e3;

/// Returns the controllers of a drive with inertia, by the words of a case, with their default
/// numbers.
pub fn usual_speed_controllers() -> [(&'static str, SpeedController); 3] {
    let (proportional_N_m_s, integral_N_m) = (PROPORTIONAL_N_M_S, INTEGRAL_N_M);
    [
        (PI, SpeedController::Pi { proportional_N_m_s, integral_N_m }),
        (
            SOFT_TORQUE,
            SpeedController::SoftTorque { impedance_ratio: SOFT_RATIO, frequency_Hz: None },
        ),
        (
            Z_TORQUE,
            SpeedController::ZTorque {
                impedance_ratio: MATCHED_RATIO,
                frequency_Hz: None,
                proportional_N_m_s,
                integral_N_m,
            },
        ),
    ]
}

table! {
    /// Rotation of the top of the string in the dynamic model.
    TopDriveTable in "[top_drive]" {
        /// "constant" (the speed equals its set point, whatever torque that requires), "pi" (a
        /// drive with inertia under a stiff speed control), "soft-torque" (one tuned to absorb the
        /// energy of one torsional frequency) or "z-torque" (one with the pipe's impedance over a
        /// band).
        control: Control = default(
            Choice { noun: "a control of the top drive", words: WORDS },
            Control::Constant,
        );
        /// Moment of inertia of the parts that turn with the string at its speed: motors, gear and
        /// quill. Raising it makes the drive stiffer to fast waves. Used by every control but
        /// "constant".
        inertia: f64 = default(
            Quantity::si(Dimension::MomentOfInertia, Range::positive_to(1e6).usual(50.0, 1e5), "2900 kg.m2"),
            2900.0,
        ).used_with(&[PI, SOFT_TORQUE, Z_TORQUE]);
        /// Torque per speed deviation. Raising it stiffens the drive. Used by "pi" and "z-torque".
        proportional: f64 = default(
            Quantity::si(Dimension::RotaryDamping, Range::positive_to(1e9).usual(10.0, 1e7), "38 kN.m.s"),
            PROPORTIONAL_N_M_S,
        ).used_with(&[PI, Z_TORQUE]);
        /// Torque per radian of deviation. Raising it restores the mean speed sooner. Used by "pi"
        /// and "z-torque".
        integral: f64 = default(
            Quantity::si(Dimension::Torque, Range::from_to(0.0, 1e9).usual(10.0, 1e7), "100 kN.m"),
            INTEGRAL_N_M,
        ).used_with(&[PI, Z_TORQUE]);
        /// Impedance of the drive over that of the uppermost pipe: at 1 it absorbs all of a wave,
        /// above 1 it reflects more of it and keeps its speed better. Default: 4 with
        /// "soft-torque", 1 with "z-torque".
        impedance_ratio: f64 = optional(Number { unit: "", range: Range::from_to(0.01, 1000.0) })
            .used_with(&[SOFT_TORQUE, Z_TORQUE]);
        /// "soft-torque": the frequency that it is tuned to. Default: the lowest torsional
        /// frequency of the string, fixed at the top and free at the bit. "z-torque": the lower
        /// edge of its band. Default: a fifth of that frequency.
        frequency: f64 = optional(Quantity::si(
            Dimension::Frequency,
            Range::from_to(1e-3, 100.0).usual(0.01, 5.0),
            "0.2 Hz",
        )).used_with(&[SOFT_TORQUE, Z_TORQUE]);
        /// Largest torque of the drive: it stalls where the string needs more. Default: none. Used
        /// by every control but "constant".
        torque_limit: f64 = optional(Quantity::si(
            Dimension::Torque,
            Range::positive_to(1e7).usual(1e3, 2e5),
            "60 kN.m",
        )).used_with(&[PI, SOFT_TORQUE, Z_TORQUE]);
    }
}

impl TopDriveTable {
    pub(crate) fn build(&self, reader: &mut Reader) -> Option<TopDriveSettings> {
        use Control::{Constant, Pi, SoftTorque, ZTorque};
        let control = self.control.get()?;
        for key in self.written() {
            if !key.is_used_with(word_of(WORDS, control)) {
                self.warn(&key, reader);
            }
        }
        let impedance_ratio = self.impedance_ratio.optional()?.map(|at| at.value);
        let frequency_Hz = self.frequency.optional()?.map(|at| at.value);
        let (proportional_N_m_s, integral_N_m) = (*self.proportional.get()?, *self.integral.get()?);
        let controller = match control {
            Constant => return Some(TopDriveSettings::Constant),
            Pi => SpeedController::Pi { proportional_N_m_s, integral_N_m },
            SoftTorque => SpeedController::SoftTorque {
                impedance_ratio: impedance_ratio.unwrap_or(SOFT_RATIO),
                frequency_Hz,
            },
            ZTorque => SpeedController::ZTorque {
                impedance_ratio: impedance_ratio.unwrap_or(MATCHED_RATIO),
                frequency_Hz,
                proportional_N_m_s,
                integral_N_m,
            },
        };
        Some(TopDriveSettings::Driven {
            inertia_kg_m2: *self.inertia.get()?,
            controller,
            torque_limit_N_m: self.torque_limit.optional()?.map(|at| at.value),
        })
    }

    fn warn(&self, key: &Written, reader: &mut Reader) {
        let words: Vec<String> = key.used_with.iter().map(|word| format!("\"{word}\"")).collect();
        let why = format!("used with control = {}", words.join(", "));
        Diagnostic::idle(key.name, key.place, why)
            .chosen("the control", self.control.place(), "constant")
            .report(reader);
    }
}
