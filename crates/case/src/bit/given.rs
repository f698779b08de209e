//! Set points of an operation that concern its bit and its motor.

use wholestring::{
    dynamics::{BitSettings, Motor},
    operation::Operation,
};

use wholestring_units::Dimension;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, rule::Spanned};

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
