//! What an operation asks of its bit and its motor.

use std::f64::consts::PI;

use wholestring::{
    dynamics::{BitLaw, BitSettings, Motor},
    operation::Operation,
};

use wholestring_units::number_text;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, rule::Spanned};

/// The set points that stand in the file.
pub(crate) struct Given<'a> {
    pub(crate) rpm: Option<&'a Spanned<f64>>,
    pub(crate) wob: Option<&'a Spanned<f64>>,
    pub(crate) rop: Option<&'a Spanned<f64>>,
}

impl Given<'_> {
    /// Warns of a set point that the law makes nothing of.
    pub(crate) fn warn_of_law(&self, law: &BitLaw, reader: &mut Reader) {
        let finds = match law {
            // No case file has a law of its own.
            BitLaw::Rate(_) | BitLaw::Custom(_) => return,
            BitLaw::Regenerative(_) => "the regenerative law of the bit finds its own",
            BitLaw::DetournayDefourny(_) => "Detournay and Defourny's law of the bit finds its own",
            BitLaw::Table(_) => "the table of the bit has its own",
            BitLaw::Rock(_) => "the rock under the bit has its own",
        };
        if let Some(rop) = self.rop {
            reader.report(Diagnostic::warning("`rop` has no effect here").at(rop.place, finds));
        }
        let Some(wob) = self.wob else { return };
        let kilonewtons = |force: f64| number_text((force * 1e-2).round() * 1e-1);
        match law {
            BitLaw::Regenerative(law) if wob.value <= law.cutters.wear_flat_weight_N() => {
                let bearing = kilonewtons(law.cutters.wear_flat_weight_N());
                reader.report(
                    Diagnostic::warning("the wear flats bear all weight: the bit does not cut")
                        .at(wob.place, format!("they bear {bearing} kN"))
                        .help("raise wob, or lower wear_flat or contact_strength under [bit]"),
                );
            }
            BitLaw::DetournayDefourny(law) => {
                let most = law.cleaning_limit_m.map(|limit| law.weight_on_bit_N(limit));
                if let Some(most) = most.filter(|most| wob.value > *most) {
                    reader.report(
                        Diagnostic::warning("the bit is choked: not all weight cuts")
                            .at(wob.place, format!("{} kN drill as fast", kilonewtons(most)))
                            .help("lower wob, or raise cleaning_limit under [bit]"),
                    );
                }
            }
            _ => {}
        }
    }

    /// Refuses an operation that its bit's table does not know.
    pub(crate) fn check_table(
        &self,
        bit: &BitSettings,
        operation: &Operation,
        reader: &mut Reader,
    ) -> Option<()> {
        let BitLaw::Table(law) = &bit.law else {
            return Some(());
        };
        let speed = bit.drilling_speed_rad_per_s(operation);
        if law.table.holds(operation.weight_on_bit_N, speed) {
            return Some(());
        }
        let [least, largest] = law.table.weights_N().map(|n| number_text(n * 1e-3));
        let [slowest, fastest] = law.table.speeds_rad_per_s().map(in_rev_per_min);
        let mut diagnostic = Diagnostic::error(format!(
            "the table of the bit does not know \"{}\": {} kN at {} rev/min",
            operation.kind.name(),
            number_text(operation.weight_on_bit_N * 1e-3),
            in_rev_per_min(speed),
        ));
        let weight = format!("the table has {least} to {largest} kN");
        let turning = format!("the table has {slowest} to {fastest} rev/min of the bit");
        if let Some(wob) = self.wob {
            diagnostic = diagnostic.at(wob.place, weight);
        }
        if let Some(rpm) = self.rpm.filter(|_| operation.kind.rotates()) {
            diagnostic = diagnostic.at(rpm.place, turning);
        } else {
            diagnostic = diagnostic.help(turning);
        }
        reader.report(diagnostic);
        None
    }

    /// What a motor cannot bear.
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
            .map(|torque| number_text((torque * 1e-1).round() * 1e-2));
        if bit.drilling_speed_rad_per_s(operation) == 0.0 {
            reader.report(
                Diagnostic::warning("the motor stalls under this weight on bit")
                    .at(wob.place, format!("the motor gives {stalls} kN.m at the most"))
                    .help("lower wob, or give a stronger motor under [bit.motor]"),
            );
        } else if torque > motor.max_torque_N_m() {
            reader.report(
                Diagnostic::warning("the motor is loaded beyond its largest pressure drop").at(
                    wob.place,
                    format!("takes {needed} kN.m, the motor is made for {most} kN.m"),
                ),
            );
        }
    }
}

fn in_rev_per_min(speed_rad_per_s: f64) -> String {
    number_text((speed_rad_per_s * 300.0 / PI).round() * 0.1)
}
