//! Weights and torques that were measured at the surface, in a file that the case names.

use wholestring::operation::{Operation, OperationKind};
use wholestring_config::prelude::*;
use wholestring_judge::{CheckKind, Severity};
use wholestring_plan::Setup;
use wholestring_tabular::{ImportedReading, read_readings};
use wholestring_units::{Unit, UnitSet};

use crate::beside::{read_beside, unfit};

/// Surface measurements of the well of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Name of the file, as the case has it.
    pub file: String,
    /// The readings, in the order of the file.
    pub readings: Vec<ImportedReading>,
    /// Interpretation of the file, in sentences.
    pub notes: Vec<String>,
    /// Half of the last digit to which the depths of the bit are written, m.
    pub half_digit_m: f64,
    /// Units of the pick-up, slack-off and rotating weights, and of the torques off and on bottom.
    pub units: [Option<&'static Unit>; 5],
}

/// Reads the readings of a file, and checks whether the case can be compared with them.
pub(crate) fn from_file(
    file: &Spanned<String>,
    (setup, units): (&Setup, UnitSet),
    own: &[Operation],
    files: &dyn Files,
    reader: &mut Reader,
) -> Option<Measured> {
    let bytes = read_beside(file, "file of measured weights", files, reader)?;
    let imported = match read_readings(&bytes, &file.value) {
        Ok(imported) => imported,
        Err(error) => return unfit(&error, file, "measured weights", reader).refuse(reader),
    };
    let (imported, checks) = imported.measured(units);
    for check in checks {
        match check.check.severity {
            Severity::Error => {
                return Diagnostic::error(check.check.sentence)
                    .at(file.place, "the measured weights")
                    .refuse(reader);
            }
            // A row that contradicts itself is reported next to the plan, where it is visible.
            Severity::Warning if check.check.kind != CheckKind::OrderOfLoads => {
                let diagnostic = Diagnostic::warning(check.check.sentence);
                diagnostic.at(file.place, "the measured weights").report(reader);
            }
            _ => {}
        }
    }
    let (half_digit_m, units) = (imported.half_digit_m, imported.units);
    let mut readings = imported.readings;
    let drills = own.iter().any(|operation| operation.kind == OperationKind::Drill);
    let mut on_bottom = readings.iter().filter(|row| row.torque_on_bottom_N_m.is_some());
    if let (false, Some(row)) = (drills, on_bottom.next()) {
        let place = match on_bottom.count() {
            0 => format!("in {}", row.place),
            others => format!("in {} and {others} more", row.place),
        };
        Diagnostic::warning("torques on bottom were measured, but the case does not drill")
            .at(file.place, place)
            .help("they are left out; add \"drill\" to `kind` in [operation], with its set points")
            .report(reader);
        readings.iter_mut().for_each(|row| row.torque_on_bottom_N_m = None);
    }
    let weighs = |row: &ImportedReading| {
        [row.pick_up_N, row.slack_off_N, row.rotating_N].iter().any(Option::is_some)
    };
    if setup.rig.block_weight_N.is_none() && readings.iter().any(weighs) {
        let diagnostic =
            Diagnostic::warning("measured weights include the block's, which is not given");
        let diagnostic = diagnostic
            .at(file.place, "compared with a block weight of zero")
            .help("give `block_weight` under [rig]; `wholestring calibrate` finds it");
        reader.report(diagnostic);
    }
    let notes = imported.notes;
    Some(Measured { file: file.value.clone(), readings, notes, half_digit_m, units })
}
