//! Inputs of the bit: set points of an operation that concern it and its motor, and those from
//! other tables.

use wholestring::{
    dynamics::{BitSettings, Motor},
    operation::Operation,
    rock::DrillingSpec,
};
use wholestring_config::{diagnostic::Diagnostic, reader::Reader, rule::Spanned, source::Files};
use wholestring_units::Dimension;

/// The set points that the file gives.
pub(crate) struct Given<'a> {
    pub(crate) rpm: Option<&'a Spanned<f64>>,
    pub(crate) wob: Option<&'a Spanned<f64>>,
    pub(crate) rop: Option<&'a Spanned<f64>>,
}

impl Given<'_> {
    /// Warns of an operation that exceeds the capacity of its motor.
    pub(crate) fn warn_of_motor(
        &self,
        bit: &BitSettings,
        operation: &Operation,
        reader: &mut Reader,
    ) {
        let (Motor::Displacement(motor), Some(wob)) = (bit.motor, self.wob) else {
            return;
        };
        let torque = operation.bit_torque_N_m;
        let [needed, most, stalls] = [torque, motor.max_torque_N_m(), motor.stall_torque_N_m]
            .map(|torque_N_m| reader.shown(Dimension::Torque, torque_N_m));
        if bit.drilling_speed_rad_per_s(operation) == 0.0 {
            reader.report(
                Diagnostic::warning("the motor stalls under this weight on bit")
                    .at(wob.place, format!("the motor gives {stalls} at the most"))
                    .help("lower wob, or give a stronger motor under [bit.motor]"),
            );
        } else if torque > motor.max_torque_N_m() {
            reader.report(
                Diagnostic::warning("the motor is loaded beyond its largest pressure drop")
                    .at(wob.place, format!("needs {needed}, the motor is rated for {most}")),
            );
        }
    }
}

// Inputs of the bit from other tables.

/// Inputs of the bit from other tables, where they are valid.
pub(crate) struct Around<'a> {
    /// Radius of the lowest component, m.
    pub(crate) radius_m: Option<f64>,
    /// Flow rate of the pumps, m³/s.
    pub(crate) flow_m3_per_s: Option<f64>,
    /// The rock that the bit drills, if it is solid rock.
    pub(crate) drilling: Option<&'a DrillingSpec>,
    /// Whether the bit is tested, whatever its law.
    pub(crate) is_tested: bool,
    pub(crate) files: &'a dyn Files,
}
