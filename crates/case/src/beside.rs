//! Files that a case names, relative to the folder of the case.

use wholestring::operation::{Operation, OperationKind};
use wholestring_config::prelude::*;
use wholestring_judge::{CheckKind, Severity};
use wholestring_plan::Setup;
use wholestring_tabular::{ImportedReading, TableError, read_readings};
use wholestring_units::{Unit, UnitSet};

/// Reads the content of the file. `noun` names its kind; a file that cannot be read is a mistake of
/// the case.
pub(crate) fn read_beside(
    file: &Spanned<String>,
    noun: &str,
    files: &dyn Files,
    reader: &mut Reader,
) -> Option<Vec<u8>> {
    let error = match files.read(&file.value) {
        Ok(bytes) => return Some(bytes),
        Err(error) => error,
    };
    let why = match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => short(&error.to_string()),
    };
    let name = short(&file.value);
    Diagnostic::error(format!("the {noun} `{name}` cannot be read"))
        .at(file.place, why)
        .help("the name is relative to the folder of the case")
        .refuse(reader)
}

/// The mistake of a table in a file, underlined in the file if it is a text. `noun` names the
/// table.
pub(crate) fn unfit(
    error: &TableError,
    file: &Spanned<String>,
    noun: &str,
    reader: &mut Reader,
) -> Diagnostic {
    let sentence = error.sentence();
    let (message, expected) = sentence.split_once("; ").unwrap_or((&sentence, ""));
    let diagnostic = Diagnostic::error(message);
    match (error.text(), error.span(), error.place()) {
        (Some(text), Some(span), _) => {
            let source = reader.add_source(&file.value, text);
            let place = Span { source, start: span.start, end: span.end };
            diagnostic.at(place, expected).at(file.place, format!("the {noun}"))
        }
        (_, _, Some(place)) => {
            let diagnostic = diagnostic.at(file.place, format!("in {place}"));
            if expected.is_empty() { diagnostic } else { diagnostic.help(expected) }
        }
        _ => Diagnostic::error(format!("the {noun} cannot be read: {message}"))
            .at(file.place, expected),
    }
}

// Weights and torques that were measured at the surface, in a file that the case names.

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
pub(crate) fn measured_from_file(
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
